#!/usr/bin/env python3
"""Pictures of this case: deformation.png, energies.png and box.png.

    plot.py [CASE]
"""

import sys
from pathlib import Path

from vertexContactCases import discs, drawFields, drawHistories, heap

MESHES = {4: "Mesh I", 6: "Mesh II", 8: "Mesh III", 12: "Mesh IV"}
TIMES = 0.1, 0.2, 0.3, 0.8
TIME_UNIT = "s", 1
PRESSURE = drawFields.Field("pressure", "pressure [kPa]", 1e3)


def size(case):
    """Elements along a quarter of a disc."""
    return int(drawHistories.parameter(case, "nQuarter", 6))


def label(case):
    n = size(case)
    return MESHES.get(n, f"{n} elements")


def plotEnergies(file, run):
    """The parts of the energy to which the work of gravity goes."""
    times, parts = heap.ledger(run.folder)
    with drawHistories.diagram(
            file, "time [s]", "energy [J/m]", title=run.label) as ax:
        for name, energy in parts.items():
            ax.plot(times, energy, label=name)


def plotBox(file, runs):
    """Force of the box, relative to the weight."""
    with drawHistories.diagram(
            file, "time [s]",
            "force of the box upwards / weight of the discs") as ax:
        ax.axhline(1, color="black", linewidth=1, linestyle=":")
        for run in runs:
            times, force, *_ = heap.box(run.folder)
            weight = heap.mass(size(run.folder))*heap.GRAVITY
            ax.plot(times, force[:, 1]/weight, label=run.label, **run.style)


def main(case="."):
    case = Path(case)
    runs = drawHistories.findRuns(case, size, label)
    plotEnergies(case/"energies.png", runs[-1])
    plotBox(case/"box.png", runs)
    drawFields.draw(
        case/"deformation.png", drawFields.read(case, TIMES, PRESSURE),
        PRESSURE, TIME_UNIT, columns=2, width=9,
        window=(0, discs.WIDTH, 0, 0.28))


if __name__ == "__main__":
    main(*sys.argv[1:])
