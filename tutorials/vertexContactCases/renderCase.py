"""Draw the deformed bodies of any case of vertexContactFoam, coloured by a
point field, without a screen. VTK's reader of OpenFOAM cases, which is
ParaView's, opens case.foam with all its regions.

    renderCase.py [CASE]                    last time, as CASE/render.png
    renderCase.py -d CASE                   the decomposed case
    renderCase.py -f sigmaEq -t 0.01 0.02 -o two.png CASE
"""

import argparse
from dataclasses import dataclass, replace
from functools import partial
from math import floor, log10
from pathlib import Path

import numpy as np

from vertexContactCases import drawFields, drawSolids
from vertexContactCases.drawFields import Field
from vertexContactCases.readFields import Reader

UNITS = {"pressure": "Pa", "sigma": "Pa", "sigmaEq": "Pa",
         "contactTraction": "Pa", "pointU": "m/s", "pointD": "m",
         "contactGap": "m", "lm": "kg/(m² s)"}
NAMES = {"epsilonPEq": "plastic strain", "pointU": "velocity",
         "pointD": "displacement", "sigmaEq": "von Mises stress",
         "contactTraction": "contact traction", "contactGap": "contact gap",
         "lm": "linear momentum"}
SIGNED = "pressure", "contactGap"
PREFIXES = {-6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
VIEWS = {"oblique": drawSolids.VIEW,
         "upright": drawSolids.turn(0, -65) @ drawSolids.turn(2, -30),
         "z": np.eye(3),
         "x": drawSolids.turn(0, -90) @ drawSolids.turn(2, -90),
         "y": drawSolids.turn(0, -90)}


def prefixed(value, unit):
    """(name, factor) of the unit that suits a value: ("kPa", 1e3)."""
    power = 0
    if unit in ("Pa", "m", "m/s", "s") and value > 0:
        power = min(max(3*floor(log10(value*1.001)/3), -6), 9)
    return PREFIXES[power] + unit, 10.0**power


def chosenField(reader, name=None, component=None):
    """The field with this name; by default the plastic strain or the pressure,
    in SI units."""
    names = reader.vtk.point_array_names
    if name is None:
        name = next((n for n in ("epsilonPEq", "pressure") if n in names),
                    None)
    if name not in names:
        raise SystemExit(f"{reader.case} has no field {name}; there are "
                         f"{' '.join(names) or 'none'}")
    return Field(name, NAMES.get(name, name), 1, component,
                 name in SIGNED or component is not None)


def inUnit(field, limit):
    """A field in the unit that suits values up to the limit."""
    unit, value = prefixed(limit, UNITS.get(field.name, ""))
    return replace(field, unit=value,
                   label=f"{field.label} [{unit}]" if unit else field.label)


def frontOfPlane(body):
    """The visible side of a plane body."""
    z = body.cell_centers().points[:, 2]
    return body.extract_cells(z > z.max() - 0.25*np.ptp(z)).extract_surface(
        algorithm="dataset_surface")


def reflected(bodies, axis):
    """Surfaces, and their mirror images at 0 of an axis."""
    return [part for body in bodies for part in (
        body, body.reflect(np.eye(3)[axis], point=(0, 0, 0)))]


def frames(reader, times, field, view, mirrors, decomposed):
    def surface(body):
        body = body.extract_surface(algorithm="dataset_surface")
        return frontOfPlane(body) if reader.plane else body

    found = drawFields.frames(reader.case, times, field, "internalMesh",
                              surface, decomposed)
    for i, frame in enumerate(found):
        bodies = frame.bodies
        for axis in mirrors:
            bodies = reflected(bodies, axis)
        for body in bodies:
            body.points = body.points @ view.T
        found[i] = replace(frame, bodies=bodies)
    return found


@dataclass
class Scene:
    """The bodies of a case at some times, and how they are drawn; what is not
    given is chosen.

    field       a name, or a Field of drawFields
    view        matrix; may also stretch
    mirrors     axes at whose zero the bodies are mirrored
    """

    case: Path
    field: object = None
    times: tuple = None
    view: object = None
    component: int = None
    mirrors: tuple = ()
    decomposed: bool = False
    percentile: float = None

    def __post_init__(self):
        reader = Reader(self.case, self.decomposed)
        given = isinstance(self.field, Field)
        if not given:
            self.field = chosenField(reader, self.field, self.component)
        if self.times is None:
            self.times = reader.times[-1:]
        if self.view is None:
            self.view = VIEWS["z" if reader.plane else "oblique"]
        if self.percentile is None:
            self.percentile = 0.2 if reader.plane else 1
        self.plane = reader.plane
        self.frames = frames(reader, self.times, self.field, self.view,
                             self.mirrors, self.decomposed)
        if not given:
            self.field = inUnit(self.field, self.limits[1])

    @property
    def limits(self):
        return drawFields.range_(self.frames, self.field, self.percentile)

    @property
    def style(self):
        """Arguments of drawFields.panel."""
        if self.plane:
            return {"render": drawFields.image, "outlines": True}
        return {"render": partial(drawSolids.image, edges=0.25),
                "outlines": False}

    def draw(self, file, columns=None, width=6.4, dpi=100, **more):
        """Panels of all times. Other arguments are those of
        drawFields.draw."""
        if columns is None:
            xMin, xMax, yMin, yMax = drawFields.box(self.frames)
            columns = (1 if xMax - xMin > 2.5*(yMax - yMin)
                       else min(len(self.frames), 4))
        drawFields.draw(
            file, self.frames, self.field,
            prefixed(self.frames[-1].time, "s"), columns, width,
            percentile=self.percentile, dpi=dpi, **self.style, **more)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__.split("\n\n")[0],
        epilog="More: tutorials/README.md")
    parser.add_argument("case", nargs="?", default=".", metavar="CASE")
    parser.add_argument("-d", "--decomposed", action="store_true",
                        help="processor*/ instead of the time folders")
    parser.add_argument("-f", "--field", help="point field (default "
                        "epsilonPEq if there is one, else pressure)")
    parser.add_argument("-c", "--component", type=int,
                        help="of a vector or tensor (default magnitude)")
    parser.add_argument("-t", "--times", type=float, nargs="+",
                        help="written times (default the last)")
    parser.add_argument("-v", "--view", choices=VIEWS,
                        help="from an axis; at an angle with y upwards (oblique) "
                        "or z (upright); default z for plane cases, else "
                        "oblique")
    parser.add_argument("-w", "--wall", type=float,
                        help="a line at this x in the picture")
    parser.add_argument("-o", "--output", metavar="FILE",
                        help="default CASE/render.png")
    options = parser.parse_args()
    case = Path(options.case)
    if not (case/"system"/"controlDict").is_file():
        raise SystemExit(f"{case} is not a case: it has no system/controlDict")
    reader = Reader(case, options.decomposed)
    if not reader.times:
        raise SystemExit(f"{case} has no written times")
    file = options.output or case/"render.png"
    Scene(case, options.field, options.times, VIEWS.get(options.view),
          options.component, decomposed=options.decomposed
          ).draw(file, wall=options.wall)
    print(file)
