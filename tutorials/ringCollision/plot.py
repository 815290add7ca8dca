#!/usr/bin/env python3
"""Pictures of this case: deformation.png, histories.png and energies.png.

    plot.py [CASE]
"""

import sys
from pathlib import Path

from vertexContactCases import drawFields, drawHistories

MESHES = {10: "Mesh I", 20: "Mesh II", 40: "Mesh III", 80: "Mesh IV"}
TIMES = 0.01, 0.02, 0.03, 0.04
TIME_UNIT = "ms", 1e-3
PRESSURE = drawFields.Field("pressure", "pressure [kPa]", 1e3)
CONTACT = 0.008/1.18        # gap, relative velocity


def elements(case):
    """Elements over the thickness of a ring."""
    return int(drawHistories.parameter(case, "nRadial", 20))


def label(case):
    n = elements(case)
    along = 4*int(drawHistories.parameter(case, "nQuarter", 63))
    size = f"{n} x {along} elements a ring"
    return f"{MESHES[n]}, {size}" if n in MESHES else size


def main(case="."):
    case = Path(case)
    # Figure 13
    drawFields.draw(
        case/"deformation.png", drawFields.read(case, TIMES, PRESSURE),
        PRESSURE, TIME_UNIT, columns=2, width=10)
    # Figures 14 and 15
    runs = drawHistories.findRuns(case, elements, label)
    drawHistories.plotHistories(
        case/"histories.png", runs,
        {"pointA": "A: ring 1, X = 40 mm", "pointB": "B: ring 2, X = 48 mm"},
        (("pointU", r"velocity $v_x$ [m/s]", 1),
         ("sigma", r"stress $\sigma_{xx}$ [kPa]", 1e3),
         ("pointD", r"displacement $u_x$ [mm]", 1e-3)),
        TIME_UNIT, CONTACT)
    # Figure 12
    drawHistories.plotEnergies(
        case/"energies.png", runs, {"ring1": "ring 1", "ring2": "ring 2"},
        TIME_UNIT)


if __name__ == "__main__":
    main(*sys.argv[1:])
