"""Draw the deformed bodies of a plane case, coloured by a point field.

VTK reads the time folders (readFields) and pyvista renders the bodies,
matplotlib puts the panels, their labels and the colour bar together.
"""

from dataclasses import dataclass
from math import ceil

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
import pyvista
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection
from matplotlib.colors import ListedColormap, Normalize

from vertexContactCases.readFields import Reader, deformed

DPI = 150
# Zero is grey, not white
SIGNED = matplotlib.colormaps["coolwarm"]
POSITIVE = ListedColormap(SIGNED(np.linspace(0.5, 1, 256)), "positive")


@dataclass(frozen=True)
class Field:
    """A point field: its name and the unit of the drawing; its component
    (otherwise the magnitude is drawn); whether both signs matter."""

    name: str
    label: str
    unit: float
    component: int | None = None
    signed: bool = True

    @property
    def colours(self):
        return SIGNED if self.signed else POSITIVE

    def values(self, body):
        """Values of the field; zero in a body without this field, such as a
        rigid one."""
        if self.name not in body.point_data:
            return np.zeros(body.n_points)
        values = np.asarray(body[self.name])
        if values.ndim == 1:
            return values
        return (np.linalg.norm(values, axis=1) if self.component is None
                else values[:, self.component])


@dataclass(frozen=True)
class Frame:
    """The deformed bodies, with point values of a field, at a time."""

    time: float
    bodies: list


def frames(case, times, field, part, surface, decomposed=False):
    """Frames of those of the times that are written. surface(body) is the
    drawn part of a deformed body."""
    reader = Reader(case, decomposed)
    if field.name not in reader.vtk.point_array_names:
        raise FileNotFoundError(f"{case} has no field {field.name} at any time")
    found = [Frame(time, [
        surface(deformed(body)) for body in
        reader.read(time, part, ("pointD", field.name)).values()])
        for time in reader.near(times)]
    if not found:
        raise FileNotFoundError(f"{case} has none of the times {times}")
    return found


def _front(patch):
    """The front patch of the two empty patches."""
    z = patch.cell_centers().points[:, 2]
    front = patch.extract_cells(z > z.mean())
    return front.extract_surface(algorithm="dataset_surface")


def read(case, times, field, patch="frontAndBack", decomposed=False):
    """Frames of those of the times that have been written."""
    return frames(case, times, field, patch, _front, decomposed)


def box(frames, margin=0.02):
    """xMin, xMax, yMin, yMax of all bodies in all frames, with a margin."""
    bounds = np.array([b.bounds for f in frames for b in f.bodies])
    low, high = bounds[:, (0, 2)].min(axis=0), bounds[:, (1, 3)].max(axis=0)
    space = margin*(high - low).max()
    return tuple(np.column_stack((low - space, high + space)).flat)


def range_(frames, field, percentile=0.2):
    """Limits of the colours for all values in all frames except a few;
    symmetric about zero, or from zero."""
    values = np.concatenate([field.values(b) for f in frames
                             for b in f.bodies])
    limits = np.percentile(values, (percentile, 100 - percentile))
    limit = np.abs(limits).max() or 1
    return -limit if field.signed else 0, limit


def image(frame, field, limits, window, width):
    """Image of the window, with this width in pixels and the height that it
    needs."""
    xMin, xMax, yMin, yMax = window
    height = round(width*(yMax - yMin)/(xMax - xMin))
    plotter = pyvista.Plotter(off_screen=True, window_size=(width, height))
    plotter.background_color = "white"
    for body in frame.bodies:
        plotter.add_mesh(body, scalars=field.values(body), clim=limits,
                         cmap=field.colours, lighting=False,
                         show_scalar_bar=False)
    return pixels(plotter, window)


def pixels(plotter, window, near=0):
    """Image of the plotter's window, seen along -z from in front of near;
    closes the plotter."""
    xMin, xMax, yMin, yMax = window
    x, y = (xMin + xMax)/2, (yMin + yMax)/2
    plotter.camera_position = ((x, y, near + 1), (x, y, near), (0, 1, 0))
    plotter.camera.parallel_projection = True
    plotter.camera.parallel_scale = (yMax - yMin)/2
    plotter.renderer.ResetCameraClippingRange()
    picture = plotter.screenshot(None, return_img=True)
    plotter.close()
    return picture


def _outlines(body):
    """The boundary of a body, as few polylines with many points."""
    edges = body.extract_feature_edges(
        boundary_edges=True, feature_edges=False, manifold_edges=False,
        non_manifold_edges=False)
    return edges.strip(join=True, max_length=edges.n_cells + 1)


def _addLines(ax, data, **style):
    """Add polylines; each is its number of points followed by their
    indices."""
    points, cells, lines, i = data.points[:, :2], data.lines, [], 0
    while i < len(cells):
        end = i + 1 + cells[i]
        lines.append(points[cells[i + 1:end]])
        i = end
    ax.add_collection(LineCollection(lines, snap=False, **style))


def _panels(figure, count, columns, window, width):
    """Axes for a number of panels, row by row, and for the colour bar; sets
    the height of the figure. Lengths in inches."""
    left, above, right = (0.65, 0.1, 1.1) if columns == 1 else (0.1, 0.3, 1.1)
    w = (width - right)/columns - left
    h = w*(window[3] - window[2])/(window[1] - window[0])
    rows = ceil(count/columns)
    height = rows*(h + above) + 0.1
    figure.set_size_inches(width, height)

    def place(x, y, w, h):
        return figure.add_axes((x/width, y/height, w/width, h/height))

    panels = []
    for i in range(count):
        row, column = divmod(i, columns)
        ax = place(left + column*(left + w), height - (row + 1)*(h + above),
                   w, h)
        ax.set(xlim=window[:2], ylim=window[2:])
        ax.axis("off")
        panels.append(ax)
    barHeight = min(0.85*height, 5)
    return panels, place(width - right + 0.15, (height - barHeight)/2,
                         0.15, barHeight)


def panel(ax, frame, field, limits, window, width, render=image,
          outlines=True, wall=None, floor=None):
    """Draw the bodies at a time, with this width in pixels and the height that
    it needs."""
    ax.set(xlim=window[:2], ylim=window[2:])
    ax.axis("off")
    ax.imshow(render(frame, field, limits, window, width), extent=window,
              aspect="auto", interpolation="antialiased")
    if outlines:
        for body in frame.bodies:
            _addLines(ax, _outlines(body), color="black", linewidth=0.8)
    if wall is not None:
        ax.axvline(wall, color="black", linewidth=1.5)
    if floor is not None:
        ax.axhline(floor, color="black", linewidth=1.5)


def draw(file, frames, field, timeUnit, columns=1, width=8, mesh=False,
         render=image, outlines=True, percentile=0.2, wall=None,
         floor=None, dpi=DPI, window=None):
    """Panels of the bodies at each time, if so wanted below one of the mesh,
    with one scale of colours.

    timeUnit    ("ms", 1e-3)
    width       of the figure [inch]
    render      makes the pixels of a panel
    percentile  of the values on either side that may be beyond the colours
    wall, floor where in x, y a plane is that is seen edge-on
    window      xMin, xMax, yMin, yMax of each panel (default: all bodies)
    """
    unit, value = timeUnit
    limits = range_(frames, field, percentile)
    window = window or box(frames)
    contents = [(frame, kind) for frame in frames
                for kind in (("mesh", "field") if mesh else ("field",))]
    figure = plt.figure()
    panels, bar = _panels(figure, len(contents), columns, window, width)

    for ax, (frame, kind) in zip(panels, contents):
        if kind == "mesh":
            for body in frame.bodies:
                _addLines(ax, body.extract_all_edges(), color="0.35",
                          linewidth=0.3)
                _addLines(ax, _outlines(body), color="black", linewidth=0.8)
        else:
            # Twice the pixels of the file, for smooth edges
            panel(ax, frame, field, limits, window,
                  round(2*dpi*width/columns), render, outlines, wall,
                  floor)
        label = f"{frame.time/value:.4g} {unit}"
        if columns > 1:
            ax.set_title(label, fontsize="medium", pad=2)
        else:
            ax.text(0, 0.5, label, ha="right", va="center",
                    transform=ax.transAxes)

    colours = ScalarMappable(
        Normalize(*(limit/field.unit for limit in limits)), field.colours)
    figure.colorbar(colours, cax=bar, label=field.label,
                    extend="both" if field.signed else "max")
    figure.savefig(file, dpi=dpi)
    plt.close(figure)
