#!/usr/bin/env python3
"""Pictures of this case: force.png, deformation.png and energies.png.

    plot.py [CASE]
"""

import sys
from pathlib import Path

from vertexContactCases import drawFields, drawHistories, prandtl, readResults
from vertexContactCases.drawHistories import plt

MESHES = {8: "Mesh I", 16: "Mesh II", 32: "Mesh III", 64: "Mesh IV"}
TIMES = 100e-6, 150e-6, 175e-6, 250e-6
TIME_UNIT = "µs", 1e-6
STRESS = drawFields.Field(
    "sigmaEq", "von Mises stress [MPa]", 1e6, signed=False)


def size(case):
    """Elements over the width of the stamp."""
    return int(drawHistories.parameter(case, "nStampX", 16))


def label(case):
    n = size(case)
    return MESHES.get(n, f"{n} elements")


def plotForce(file, runs):
    """The force on the stamp, the force of the block, and the limit for
    Prandtl's block; and the path of the stamp."""
    unit, value = TIME_UNIT
    figure, (left, right) = plt.subplots(
        1, 2, figsize=(11, 4.5), sharex=True, layout="constrained")
    for run in runs:
        data = readResults.table(run.folder, "contactForces", "imprint.dat")
        left.plot(data["Time"]/value, data["stamp.surface:Fy"]/1e6,
                  label=run.label, **run.style)
        times, way = readResults.probe(run.folder, "stamp", "pointD")
        right.plot(times/value, -way[:, 1]/1e-3, label=run.label, **run.style)
    t = data["Time"]
    left.plot(t/value, prandtl.force(t)/1e6, color="black",
              label="on the stamp")
    left.axhline(prandtl.LIMIT/1e6, color="0.5", linestyle="--",
                 label="limit, Prandtl")
    left.set_ylabel("force [MN/m]")
    right.set_ylabel("way of the stamp [mm]")
    for ax in left, right:
        ax.set_xlabel(f"time [{unit}]")
        ax.grid(color="0.9")
        ax.margins(x=0)
    left.legend()
    figure.savefig(file, dpi=drawHistories.DPI)
    plt.close(figure)


def main(case="."):
    case = Path(case)
    runs = drawHistories.findRuns(case, size, label)
    plotForce(case/"force.png", runs)
    drawFields.draw(
        case/"deformation.png", drawFields.read(case, TIMES, STRESS), STRESS,
        TIME_UNIT, columns=2, width=11)
    drawHistories.plotWork(
        case/"energies.png", runs[-1], TIME_UNIT, ("kJ/m", 1e3),
        {"externalWork": "work of the force",
         "plasticDissipation": "plastic work", "kinetic": "kinetic energy",
         "strain": "strain energy",
         "numericalDissipation": "numerical dissipation"})


if __name__ == "__main__":
    main(*sys.argv[1:])
