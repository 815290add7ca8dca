#!/usr/bin/env python3
"""Picture of this case: histories.png.

    plot.py [CASE]
"""

import sys
from math import pi
from pathlib import Path

import numpy as np

from vertexContactCases import drawHistories, readResults
from vertexContactCases.drawHistories import plt

MESHES = {6: "Mesh I", 8: "Mesh II", 12: "Mesh III", 16: "Mesh IV"}
TURN = 2*pi/30      # s


def settings(case):
    """The settings that differ between runs."""
    def value(key, default):
        return drawHistories.parameter(case, key, default)
    return (str(value("preset", "")), int(value("nEdge", 6)),
            *(float(value(f"omega{c}", w)) for c, w in zip("XYZ", (0, 0, 30))))


def label(case):
    preset, n, *omega = settings(case)
    mesh = MESHES.get(n, f"{n}^3 elements")
    axis = "" if omega[:2] == [0, 0] else \
        " about ({:.2g} {:.2g} {:.2g})".format(*(w/30 for w in omega))
    option = f", preset {preset}" if preset else ""
    return f"{mesh}{axis}{option}"


def main(case="."):
    case = Path(case)
    runs = drawHistories.findRuns(case, settings, label)
    figure, axes = plt.subplots(1, 3, figsize=(12, 4.5), layout="constrained")
    for run in runs:
        energies, momenta = (
            readResults.table(run.folder, "solidEnergies", f"{name}.dat")
            for name in ("energies", "momentum"))
        turns = energies["Time"]/TURN
        L = np.array([momenta[f"total:L{c}"] for c in "xyz"])
        L0 = L[:, :1]
        along = np.sum(L*L0, axis=0)/np.sum(L0*L0)
        kinetic, strain = energies["total:kinetic"], energies["total:strain"]
        total = kinetic + strain
        for ax, values in zip(axes, (along, total/total[0], strain/total[0])):
            ax.plot(turns, 100*values, label=run.label, **run.style)
    for ax, title in zip(axes, (
            "angular momentum about the axis / initial [%]",
            "total energy / initial [%]",
            "strain energy / initial total energy [%]")):
        ax.set_title(title, fontsize="medium")
        ax.set_xlabel("turns")
        ax.grid(color="0.9")
        ax.margins(x=0)
    for ax in axes[:2]:
        # At least a percent, so that round-off looks like round-off
        low, high = ax.get_ylim()
        ax.set_ylim(min(low, 99), max(high, 101))
        ax.ticklabel_format(useOffset=False)
    figure.legend(*axes[0].get_legend_handles_labels(), ncols=2,
                  loc="outside upper center")
    figure.savefig(case/"histories.png", dpi=drawHistories.DPI)
    plt.close(figure)


if __name__ == "__main__":
    main(*sys.argv[1:])
