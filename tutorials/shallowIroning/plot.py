#!/usr/bin/env python3
"""Pictures of this case: forces.png, deformation.png and energies.png.

    plot.py [CASE]
"""

import sys
from pathlib import Path

from vertexContactCases import drawFields, drawHistories, published
from vertexContactCases.drawHistories import plt

MESHES = {6: "Mesh I", 12: "Mesh II", 24: "Mesh III", 48: "Mesh IV"}
TIMES = 0.0005, 0.0007, 0.0011, 0.0015
TIME_UNIT = "ms", 1e-3
PRESSURE = drawFields.Field("pressure", "pressure [MPa]", 1e6)
MARKERS = "o^sDv"


def size(case):
    """Elements over the width of the block."""
    return int(drawHistories.parameter(case, "nBlockX", 12))


def label(case):
    n = size(case)
    return MESHES.get(n, f"{n} elements")


def plotForces(file, runs):
    """Forces over the path of the top of the block: 1 mm down, 10 mm along."""
    figure, axes = plt.subplots(1, 2, figsize=(11, 5), sharex=True,
                                layout="constrained")
    theirs = published.sources()
    ways = theirs["down"] + theirs["along"]
    for ax, kind in zip(axes, "HV"):
        for (source, name), marker in zip(published.SOURCES.items(), MARKERS):
            ax.plot(ways, theirs[f"{source}:{kind}"], marker, color="0.5",
                    markersize=5, markerfacecolor="none", label=name)
        for run in runs:
            down, along, H, V = published.forces(run.folder)
            ax.plot(down + along, H if kind == "H" else V, label=run.label,
                    **run.style)
        ax.grid(color="0.9")
        ax.set_xlabel("way of the top: 1 mm down, then along [mm]")
    axes[0].set_ylabel("force along [N/mm]")
    axes[1].set_ylabel("force downwards [N/mm]")
    axes[0].margins(x=0)
    figure.legend(*axes[0].get_legend_handles_labels(), ncols=4,
                  loc="outside upper center")
    figure.savefig(file, dpi=drawHistories.DPI)
    plt.close(figure)


def main(case="."):
    case = Path(case)
    runs = drawHistories.findRuns(case, size, label)
    plotForces(case/"forces.png", runs)
    drawHistories.plotWork(
        case/"energies.png", runs[-1], TIME_UNIT, ("J/m", 1),
        {"externalWork": "work of the top", "strain": "strain energy",
         "frictionDissipation": "friction", "kinetic": "kinetic energy",
         "numericalDissipation": "numerical dissipation"})
    drawFields.draw(
        case/"deformation.png", drawFields.read(case, TIMES, PRESSURE),
        PRESSURE, TIME_UNIT, columns=2, width=12)


if __name__ == "__main__":
    main(*sys.argv[1:])
