#!/usr/bin/env python3
"""Pictures of this case: epsilonPEq.png, pressure.png, with heat
pointT.png, histories.png and energies.png.

    plot.py [CASE]
"""

import sys
from pathlib import Path

from vertexContactCases import drawFields, drawHistories, drawSolids

MESHES = {6: "Mesh I", 8: "Mesh II", 12: "Mesh III", 16: "Mesh IV"}
TIMES = 20e-6, 40e-6, 60e-6, 80e-6
TIME_UNIT = "µs", 1e-6
STRAIN = drawFields.Field(
    "epsilonPEq", "equivalent plastic strain", 1, signed=False)
TEMPERATURE = drawFields.Field("pointT", "temperature [K]", 1, signed=False)
PRESSURE = drawFields.Field("pressure", "pressure [GPa]", 1e9)
VIEW = drawSolids.turn(0, 8) @ drawSolids.turn(1, -150)  # onto the mirrors


def elements(case):
    """Elements over the radius."""
    return 2*int(drawHistories.parameter(case, "nHalf", 3))


def label(case):
    n = elements(case)
    size = f"{n} elements over the radius"
    return f"{MESHES[n]}, {size}" if n in MESHES else size


def main(case="."):
    case = Path(case)
    fields = [STRAIN, PRESSURE]
    if drawHistories.parameter(case, "heat"):
        fields.append(TEMPERATURE)
    for field in fields:
        drawSolids.draw(
            case/f"{field.name}.png",
            drawSolids.read(case, TIMES, field, VIEW),
            field, TIME_UNIT, columns=len(TIMES), percentile=0.5)
    runs = drawHistories.findRuns(case, elements, label)
    drawHistories.plotHistories(
        case/"histories.png", runs,
        {"pointTop": "free end", "pointRim": "rim of the foot"},
        (("pointU", r"velocity $v_y$ [m/s]", 1),
         ("pointD", r"displacement $u_y$ [mm]", 1e-3)),
        TIME_UNIT, 0, component=1)
    drawHistories.plotEnergy(case/"energies.png", runs, TIME_UNIT, ("J", 1))


if __name__ == "__main__":
    main(*sys.argv[1:])
