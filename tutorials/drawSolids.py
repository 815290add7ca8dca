"""Draw the deformed bodies of a three-dimensional case, seen at an angle, side
by side at some times. Extends drawFields, which draws plane cases."""

from math import isclose
from pathlib import Path

import numpy as np
import pyvista
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

import drawFields
from drawFields import COLOURS, DPI, plt

PIXELS = 2      # a pixel of the picture, for smooth edges


def turn(axis, angle):
    """Matrix of a rotation about x (0), y (1) or z (2), in degrees."""
    c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R = np.eye(3)
    R[i, i], R[i, j], R[j, i], R[j, j] = c, -s, s, c
    return R


# x to the right, y upwards, seen a little from the right and from above
VIEW = turn(0, 18) @ turn(1, -28)


def read(case, times, field, view=VIEW):
    """Frames of those of the times that have been written: the surfaces where
    they are now, turned so that they are seen from +z."""
    case = Path(case)
    if not any(case.glob(f"[0-9]*/*/{field.name}")):
        raise FileNotFoundError(f"{case} has no {field.name} of any time")
    reader = pyvista.OpenFOAMReader(str(case/"system"/"controlDict"))
    reader.disable_all_patch_arrays()
    for name in reader.patch_array_names:
        if name.endswith("/internalMesh"):
            reader.enable_patch_array(name)
    reader.disable_all_point_arrays()
    for name in "pointD", field.name:
        reader.enable_point_array(name)

    frames = []
    for written in reader.time_values:
        if not any(isclose(written, time, rel_tol=1e-6) for time in times):
            continue
        reader.set_active_time_value(written)
        bodies = []
        for region in reader.read():
            body = region["internalMesh"].extract_surface(
                algorithm="dataset_surface").warp_by_vector("pointD")
            body.points = body.points @ view.T
            bodies.append(body)
        frames.append(drawFields.Frame(written, bodies))
    if not frames:
        raise FileNotFoundError(f"{case} has none of the times {times}")
    return frames


def _image(frame, field, limits, window, width):
    """What is in the window, as width times so many pixels as that takes."""
    xMin, xMax, yMin, yMax = window
    height = round(width*(yMax - yMin)/(xMax - xMin))
    plotter = pyvista.Plotter(off_screen=True, window_size=(width, height),
                              lighting="none")
    plotter.background_color = "white"
    # From behind the eye, the left and above
    plotter.add_light(pyvista.Light(
        position=(-1, 1, 2), light_type="scene light", intensity=0.5))
    near = max(body.bounds[5] for body in frame.bodies)
    for body in frame.bodies:
        plotter.add_mesh(
            body, scalars=field.name, cmap=COLOURS, clim=limits,
            ambient=0.55, diffuse=0.9, show_edges=True, edge_color="black",
            edge_opacity=0.5, line_width=PIXELS, show_scalar_bar=False)
    x, y = (xMin + xMax)/2, (yMin + yMax)/2
    plotter.camera_position = ((x, y, near + 1), (x, y, near), (0, 1, 0))
    plotter.camera.parallel_projection = True
    plotter.camera.parallel_scale = (yMax - yMin)/2
    plotter.renderer.ResetCameraClippingRange()
    pixels = plotter.screenshot(None, return_img=True)
    plotter.close()
    return pixels


def draw(file, frames, field, timeUnit, columns, width=10, percentile=2,
         wall=None):
    """Panels of the bodies at each time, in so many columns, with one scale
    of colours.

    timeUnit    ("ms", 1e-3)
    width       of the figure [inch]
    percentile  of the values on either side that may be beyond the colours
    wall        where in x a plane is that is seen edge-on
    """
    unit, value = timeUnit
    limits = drawFields.range_(frames, field, percentile)
    window = drawFields.box(frames)
    bar, title = 1.1, 0.3
    w = (width - bar)/columns
    h = w*(window[3] - window[2])/(window[1] - window[0])
    rows = -(-len(frames)//columns)
    height = rows*(h + title) + 0.1
    figure = plt.figure(figsize=(width, height))
    for i, frame in enumerate(frames):
        row, column = divmod(i, columns)
        ax = figure.add_axes((
            column*w/width, 1 - (row + 1)*(h + title)/height,
            w/width, h/height))
        ax.axis("off")
        ax.imshow(_image(frame, field, limits, window, round(PIXELS*DPI*w)),
                  extent=window, aspect="auto", interpolation="antialiased")
        if wall is not None:
            ax.axvline(wall, color="black", linewidth=1.5)
        ax.set_title(f"{frame.time/value:g} {unit}", fontsize="medium", pad=2)
    barHeight = min(0.85*height, 5)
    figure.colorbar(
        ScalarMappable(Normalize(*(limit/field.unit for limit in limits)),
                       COLOURS),
        cax=figure.add_axes(((width - bar + 0.15)/width,
                             0.5 - barHeight/2/height,
                             0.15/width, barHeight/height)),
        label=field.label, extend="both")
    figure.savefig(file, dpi=DPI)
    plt.close(figure)
