#!/usr/bin/env python3
"""Pictures of this case: deformation.png, impact.png, histories.png and
energies.png.

    plot.py [CASE]
"""

import sys
from pathlib import Path

from vertexContactCases import drawFields, drawHistories

MESHES = {8: "Mesh I", 16: "Mesh II", 32: "Mesh III", 64: "Mesh IV"}
TIMES = 50e-6, 75e-6, 1e-4, 125e-6, 150e-6, 2e-4, 250e-6, 3e-4, 325e-6
IMPACT = 90e-6,
TIME_UNIT = "µs", 1e-6
PRESSURE = drawFields.Field("pressure", "pressure [MPa]", 1e6)
CONTACT = 0.008/100         # gap, relative velocity


def elements(case):
    """Elements over the width of a bar."""
    return int(drawHistories.parameter(case, "nWidth", 16))


def label(case):
    n = elements(case)
    along = drawHistories.parameter(case, "nLength", 80)
    size = f"{n} x {along} elements a bar"
    return f"{MESHES[n]}, {size}" if n in MESHES else size


def main(case="."):
    case = Path(case)
    # Figure 20
    drawFields.draw(
        case/"deformation.png", drawFields.read(case, TIMES, PRESSURE),
        PRESSURE, TIME_UNIT)
    # Figure 17
    drawFields.draw(
        case/"impact.png", drawFields.read(case, IMPACT, PRESSURE),
        PRESSURE, TIME_UNIT, mesh=True)
    # Figure 18
    runs = drawHistories.findRuns(case, elements, label)
    drawHistories.plotHistories(
        case/"histories.png", runs,
        {"pointA": "A: bar 1, X = 32.4 mm", "pointB": "B: bar 2, X = 40.4 mm"},
        (("pointU", r"velocity $v_x$ [m/s]", 1),
         ("pointD", r"displacement $u_x$ [mm]", 1e-3)),
        TIME_UNIT, CONTACT)
    drawHistories.plotEnergies(
        case/"energies.png", runs, {"bar1": "bar 1", "bar2": "bar 2"},
        TIME_UNIT)


if __name__ == "__main__":
    main(*sys.argv[1:])
