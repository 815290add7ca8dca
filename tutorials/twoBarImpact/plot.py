#!/usr/bin/env python3
"""Pictures of a case of this tutorial: twoBarImpact.png and energies.png.

    plot.py [CASE]
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from foamlib import FoamFile

from vertexContactCases import readResults
from vertexContactCases.exactSolution import TwoBarImpact

EXACT = dict(color="black", linewidth=1, linestyle=(0, (4, 2)), zorder=3)


def elements(case):
    for name in "caseParameters", "barBlock":
        file = case/"system"/name
        if file.exists() and "nElements" in FoamFile(file):
            return int(FoamFile(file)["nElements"])
    raise KeyError(f"no nElements in {case}/system")


def label(case):
    return f"vertexContact, {elements(case)} elements a bar"


def plotHistories(case, exact):
    """v, sigma and u at the ends that touch, as Figures 8 and 9."""
    left, right = exact.bars
    times = np.linspace(0, exact.endTime, 4001)
    figure, axes = plt.subplots(
        3, 2, figsize=(10, 9), sharex=True, sharey="row", layout="constrained")

    for column, (name, bar, X) in enumerate(
            (("A", 0, left.end), ("B", 1, right.start))):
        rows = (
            ("pointU", r"velocity $v_x$ [m/s]", exact.velocity),
            ("sigma", r"stress $\sigma_{xx}$ [Pa]", exact.stress),
            ("pointD", r"displacement $u_x$ [m]", exact.displacement))
        for ax, (field, quantity, solution) in zip(axes[:, column], rows):
            t, values = readResults.probe(case, f"point{name}", field)
            ax.plot(t, values[:, 0], color="C0", linewidth=2,
                    label=label(case))
            ax.plot(times, solution(bar, X, times), label="exact", **EXACT)
            ax.grid(color="0.9")
            if column == 0:
                ax.set_ylabel(quantity)
        axes[0, column].set_title(f"{name}: bar {bar + 1}, X = {X:g} m")
        axes[2, column].set_xlabel("time [s]")
    axes[0, 0].set_xlim(0, exact.endTime)
    figure.get_layout_engine().set(wspace=0.05)
    figure.legend(*axes[0, 0].get_legend_handles_labels(), ncols=2,
                  loc="outside upper center")
    figure.savefig(case/"twoBarImpact.png", dpi=150)


def plotEnergies(case, exact):
    """Energies per cross-section, as Figure 6."""
    data = readResults.table(case, "solidEnergies", "energies.dat")
    t, unit, milli = data["Time"], r"[mJ/m$^2$]", 1000
    total = data["total:kinetic"] + data["total:strain"]
    times = np.linspace(0, exact.endTime, 1401)
    energies = [exact.energies(bar, times) for bar in (0, 1)]
    initial = sum(e[0] for bar in energies for e in bar)

    figure, axes = plt.subplots(
        2, 2, figsize=(11, 8), sharex=True, layout="constrained")
    ax = axes[0, 0]
    ax.plot(t, 100*total/initial, color="C0", linewidth=2)
    ax.plot(times, 100*sum(e for bar in energies for e in bar)/initial,
            **EXACT)
    ax.set_title("total energy of both bars")
    ax.set_ylabel("energy / initial energy [%]")
    ax.text(0.03, 0.06, f"lost: {100*(1 - total[-1]/initial):.2f} %",
            transform=ax.transAxes)

    ax = axes[0, 1]
    dissipation = data["total:numericalDissipation"]
    ax.plot(t, 100*dissipation/initial, color="C3", linewidth=2)
    ax.set_title("numerical dissipation of both bars, accumulated")
    ax.set_ylabel("energy / initial energy [%]")

    for i, ax in enumerate(axes[1]):
        kinetic, strain = data[f"bar{i+1}:kinetic"], data[f"bar{i+1}:strain"]
        ax.plot(t, milli*(kinetic + strain), color="C0", linewidth=2, label="total")
        ax.plot(t, milli*kinetic, color="C1", linewidth=2, label="kinetic")
        ax.plot(t, milli*strain, color="C2", linewidth=2, label="strain")
        ax.plot(times, milli*sum(energies[i]), **EXACT)
        for e in energies[i]:
            ax.plot(times, milli*e, **EXACT)
        ax.plot([], [], label="exact", **EXACT)
        ax.set_title(f"bar {i+1}")
        ax.set_ylabel(f"energy per cross-section {unit}")
        ax.set_xlabel("time [s]")
    figure.suptitle(label(case))
    axes[1, 0].legend(loc="upper right")
    for ax in axes.flat:
        ax.grid(color="0.9")
    axes[0, 0].set_xlim(0, exact.endTime)
    figure.savefig(case/"energies.png", dpi=150)


def main(case="."):
    case = Path(case)
    exact = TwoBarImpact.fromCase(case)
    plotHistories(case, exact)
    plotEnergies(case, exact)


if __name__ == "__main__":
    main(*sys.argv[1:])
