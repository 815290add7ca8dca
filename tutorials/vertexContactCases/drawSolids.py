"""Draw the deformed bodies of a three-dimensional case, seen at an angle, side
by side at some times. Extends drawFields, which draws plane cases."""

import numpy as np
import pyvista

from vertexContactCases import drawFields
from vertexContactCases.drawFields import DPI

PIXELS = 2      # per pixel of the picture, for smooth edges


def turn(axis, angle):
    """Matrix of a rotation about x (0), y (1) or z (2), in degrees."""
    c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R = np.eye(3)
    R[i, i], R[i, j], R[j, i], R[j, j] = c, -s, s, c
    return R


# x to the right, y upwards, seen slightly from the right and from above
VIEW = turn(0, 18) @ turn(1, -28)


def read(case, times, field, view=VIEW, decomposed=False):
    """Frames of those of the times that are written: the deformed surfaces,
    rotated so that they are seen from +z."""
    def surface(body):
        body = body.extract_surface(algorithm="dataset_surface")
        body.points = body.points @ view.T
        return body

    return drawFields.frames(case, times, field, "internalMesh", surface,
                             decomposed)


def image(frame, field, limits, window, width, edges=0.5):
    """What is in the window, as width times so many pixels as that takes.

    edges   how opaque they are
    """
    xMin, xMax, yMin, yMax = window
    height = round(width*(yMax - yMin)/(xMax - xMin))
    plotter = pyvista.Plotter(off_screen=True, window_size=(width, height),
                              lighting="none")
    plotter.background_color = "white"
    # From behind the eye, from the left and from above
    plotter.add_light(pyvista.Light(
        position=(-1, 1, 2), light_type="scene light", intensity=0.5))
    near = max(body.bounds[5] for body in frame.bodies)
    for body in frame.bodies:
        plotter.add_mesh(
            body, scalars=field.values(body), cmap=field.colours, clim=limits,
            ambient=0.55, diffuse=0.9, show_edges=True, edge_color="black",
            edge_opacity=edges, line_width=PIXELS, show_scalar_bar=False)
    return drawFields.pixels(plotter, window, near)


def draw(file, frames, field, timeUnit, columns, width=10, percentile=2,
         wall=None, dpi=DPI):
    """Panels of the bodies at each time, in this number of columns, with one
    colour scale; other arguments as in drawFields.draw."""
    drawFields.draw(file, frames, field, timeUnit, columns, width,
                    render=image, outlines=False, percentile=percentile,
                    wall=wall, dpi=dpi)
