#!/usr/bin/env python3
"""Pictures of this case: deformation.png and energies.png.

    plot.py [CASE]
"""

import sys
from pathlib import Path

from vertexContactCases import drawFields, drawHistories, drawSolids

MESHES = {4: "Mesh I", 6: "Mesh II", 8: "Mesh III", 12: "Mesh IV"}
TIMES = 0.02, 0.04, 0.06, 0.08, 0.1
TIME_UNIT = "ms", 1e-3
PRESSURE = drawFields.Field("pressure", "pressure [MPa]", 1e6)


def size(case):
    """Poisson's ratio, and elements over the width."""
    return (float(drawHistories.parameter(case, "nu", 0.3)),
            int(drawHistories.parameter(case, "nWidth", 4)))


def label(case):
    nu, n = size(case)
    return f"{MESHES.get(n, f'{n} x {6*n} x {n}')}, nu = {nu:g}"


def main(case="."):
    case = Path(case)
    drawSolids.draw(
        case/"deformation.png", drawSolids.read(case, TIMES, PRESSURE),
        PRESSURE, TIME_UNIT, columns=len(TIMES))
    drawHistories.plotEnergy(
        case/"energies.png", drawHistories.findRuns(case, size, label),
        TIME_UNIT, ("MJ", 1e6))


if __name__ == "__main__":
    main(*sys.argv[1:])
