#!/usr/bin/env python3
"""Pictures of this case: stresses.png and deformation.png.

    plot.py [CASE]
"""

import sys
from pathlib import Path

import numpy as np

from vertexContactCases import drawFields, drawHistories, lame
from vertexContactCases.readFields import Reader

MESHES = {4: "Mesh I", 8: "Mesh II", 16: "Mesh III", 32: "Mesh IV"}
TIMES = 5e-6, 25e-6
TIME_UNIT = "µs", 1e-6
STRESS = drawFields.Field(
    "sigmaEq", "von Mises stress [MPa]", 1e6, signed=False)


def polar(X, sigma):
    """Radii, and radial and hoop stress, from components xx xy xz yy yz zz."""
    r = np.hypot(X[:, 0], X[:, 1])
    c, s = X[:, 0]/r, X[:, 1]/r
    xx, xy, _, yy = sigma[:, :4].T
    return (r, c**2*xx + 2*c*s*xy + s**2*yy,
            s**2*xx - 2*c*s*xy + c**2*yy)


def plotStresses(file, case, label):
    """Radial and hoop stress of all nodes at the last time, and Lame's
    solution."""
    reader = Reader(case)
    bodies = reader.read(reader.times[-1])
    with drawHistories.diagram(
            file, "radius [mm]", "stress [MPa]", title=label) as ax:
        ax.margins(x=0.05)
        for name, body in bodies.items():
            # The order of VTK is xx yy zz xy yz xz
            sigma = np.asarray(body.point_data["sigma"], dtype=float)
            r, radial, hoop = polar(np.asarray(body.points, dtype=float),
                                    sigma[:, (0, 3, 5, 1, 4, 2)])
            first = name == "shaft"
            ax.plot(r/1e-3, radial/1e6, ".", color="C0",
                    label="radial" if first else None)
            ax.plot(r/1e-3, hoop/1e6, ".", color="C1",
                    label="hoop" if first else None)
        theory = "Lamé"
        for radii in (np.linspace(lame.A, lame.B*(1 - 1e-9)),
                      np.linspace(lame.B, lame.C)):
            for stress in lame.stresses(radii):
                ax.plot(radii/1e-3, stress/1e6, color="black", linewidth=1,
                        label=theory)
                theory = None


def main(case="."):
    case = Path(case)
    n = int(drawHistories.parameter(case, "nShaft", 8))
    plotStresses(case/"stresses.png", case, MESHES.get(n, f"{n} elements"))
    drawFields.draw(
        case/"deformation.png", drawFields.read(case, TIMES, STRESS), STRESS,
        TIME_UNIT, columns=2, width=11)


if __name__ == "__main__":
    main(*sys.argv[1:])
