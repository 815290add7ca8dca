#!/usr/bin/env python3
"""Pictures of this case: deformation.png, histories.png and energies.png.

    plot.py [CASE]
"""

import sys
from pathlib import Path

import numpy as np

from vertexContactCases import drawFields, drawHistories, drawSolids

MESHES = {2.75: "Mesh I", 1.96: "Mesh II", 1.44: "Mesh III", 1.145: "Mesh IV"}
TIMES = np.arange(0.0025, 0.0501, 0.0025)
TIME_UNIT = "ms", 1e-3
PRESSURE = drawFields.Field("pressure", "pressure [kPa]", 1e3)
WALL = 0.044
CONTACT = 0.004/1.18        # gap, velocity
VIEW = drawSolids.turn(0, -35)      # the wall is seen edge-on


def size(case):
    """Length of the edges [mm]."""
    return float(drawHistories.parameter(case, "size", 1.96))


def label(case):
    edge = size(case)
    text = f"edges of {edge:.3g} mm"
    return f"{MESHES[edge]}, {text}" if edge in MESHES else text


def main(case="."):
    case = Path(case)
    # Figure 32
    drawSolids.draw(
        case/"deformation.png", drawSolids.read(case, TIMES, PRESSURE, VIEW),
        PRESSURE, TIME_UNIT, columns=5, wall=WALL)
    # Figure 34 shows the same of the elasto-plastic torus
    runs = drawHistories.findRuns(case, lambda run: -size(run), label)
    drawHistories.plotHistories(
        case/"histories.png", runs,
        {"pointA": "A: at the wall, X = 40 mm",
         "pointB": "B: opposite, X = −40 mm"},
        (("pointU", r"velocity $v_x$ [m/s]", 1),
         ("pointD", r"displacement $u_x$ [mm]", 1e-3),
         ("sigma", r"stress $\sigma_{xx}$ [kPa]", 1e3),
         ("pressure", "pressure [kPa]", 1e3)),
        TIME_UNIT, CONTACT)
    # Figure 30
    drawHistories.plotEnergy(case/"energies.png", runs, TIME_UNIT, ("J", 1))


if __name__ == "__main__":
    main(*sys.argv[1:])
