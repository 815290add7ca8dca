#!/usr/bin/env python3
"""Pictures of this case: deformation.png, histories.png and energies.png.

    plot.py [CASE]
"""

import sys
from pathlib import Path

from vertexContactCases import drawFields, drawHistories

MESHES = {4: "Mesh I", 8: "Mesh II", 16: "Mesh III", 32: "Mesh IV"}
TIMES = 0.002, 0.004, 0.006, 0.008, 0.01, 0.012, 0.016, 0.02
TIME_UNIT = "ms", 1e-3
PRESSURE = drawFields.Field("pressure", "pressure [kPa]", 1e3)
CONTACT = 0.004/2           # half of the gap at the tips, their velocity
SCENES = {"self": "self-contact", "nonMatching": "self-contact, non-matching",
          "half": "half, rigid plane"}


def settings(case):
    """Elements over the thickness, and scene."""
    return (int(drawHistories.parameter(case, "nThick", 8)),
            str(drawHistories.parameter(case, "scene", "self")))


def label(case):
    n, scene = settings(case)
    return f"{MESHES.get(n, f'{n} elements')}, {SCENES[scene]}"


def main(case="."):
    case = Path(case)
    drawFields.draw(
        case/"deformation.png", drawFields.read(case, TIMES, PRESSURE),
        PRESSURE, TIME_UNIT, columns=4, width=12)
    runs = drawHistories.findRuns(case, settings, label)
    drawHistories.plotHistories(
        case/"histories.png", runs,
        {"pointA": "A: tip of the upper leg, inside",
         "pointB": "B: its middle, inside"},
        (("pointU", r"velocity $v_y$ [m/s]", 1),
         ("pointD", r"displacement $u_y$ [mm]", 1e-3)),
        TIME_UNIT, CONTACT, component=1)
    # Relative to the initial value, for the half model and for the whole
    drawHistories.plotEnergy(
        case/"energies.png", runs, TIME_UNIT, ("J/m", 1))


if __name__ == "__main__":
    main(*sys.argv[1:])
