#!/usr/bin/env python3
"""Pictures of this case: deformation.png, histories.png, line.png and
energies.png.

    plot.py [CASE]
"""

import sys
from pathlib import Path

import numpy as np

from vertexContactCases import (drawFields, drawHistories, drawSolids,
                                readResults)
from vertexContactCases.drawHistories import plt

MESHES = {(4, 10): "Mesh I", (6, 10): "Mesh II", (8, 10): "Mesh III",
          (12, 10): "Mesh IV", (10, 10): "conforming"}
TIMES = 40e-6, 80e-6, 120e-6, 160e-6, 200e-6, 260e-6
LINE_TIME = 260e-6
TIME_UNIT = "µs", 1e-6
PRESSURE = drawFields.Field("pressure", "pressure [MPa]", 1e6)
QUANTITIES = (("pointU", r"velocity $v_x$ [m/s]", 1),
              ("pointD", r"displacement $u_x$ [mm]", 1e-3),
              ("sigma", r"stress $\sigma_{xx}$ [MPa]", 1e6),
              ("pressure", "pressure [MPa]", 1e6))
CONTACT = 0.0004/100        # gap, relative velocity


def settings(case):
    """Elements over the width of bars 2 and 1, and the pairing."""
    def value(key, default):
        return drawHistories.parameter(case, key, default)
    return (int(value("nWidth2", 4)), int(value("nWidth1", 10)),
            str(value("pairing", "AMI")))


def label(case):
    n2, n1, pairing = settings(case)
    mesh = MESHES.get((n2, n1), f"{n1} and {n2} elements over the width")
    return f"{mesh}, {pairing}"


def lineValues(case, field):
    """Positions of the nodes on the axis of bar 2, and x components at these
    nodes, at the time of the line."""
    points = np.array(drawHistories.parameter(case, "linePoints"))
    values = []
    for i in range(len(points)):
        t, v = readResults.probe(case, "line", field, i)
        values.append(v[np.argmin(np.abs(t - LINE_TIME)), 0])
    return points[:, 0], np.array(values)


def plotLine(file, runs):
    """Figure 26."""
    figure, axes = plt.subplots(2, 2, figsize=(10, 7), sharex=True,
                                layout="constrained")
    for ax, (field, title, unit) in zip(axes.flat, QUANTITIES):
        for run in runs:
            X, values = lineValues(run.folder, field)
            ax.plot(X/1e-3, values/unit, label=run.label, **run.style)
        ax.set_ylabel(title)
        ax.grid(color="0.9")
        ax.margins(x=0)
    for ax in axes[1]:
        ax.set_xlabel("X [mm], on the axis of bar 2")
    figure.legend(*axes[0, 0].get_legend_handles_labels(), ncols=3,
                  loc="outside upper center")
    figure.savefig(file, dpi=drawHistories.DPI)
    plt.close(figure)


def main(case="."):
    case = Path(case)
    # Figures 23 and 24
    drawSolids.draw(
        case/"deformation.png", drawSolids.read(case, TIMES, PRESSURE),
        PRESSURE, TIME_UNIT, columns=2, width=12)
    # Figure 25
    runs = drawHistories.findRuns(case, settings, label)
    drawHistories.plotHistories(
        case/"histories.png", runs,
        {"pointA": "A: bar 2, X = (32.8, 3.2, 3.2) mm",
         "pointB": "B: bar 1, X = (32.4, 3.2, 3.2) mm"},
        QUANTITIES, TIME_UNIT, CONTACT)
    # Figure 26
    plotLine(case/"line.png", runs)
    # Figure 27
    drawHistories.plotEnergies(
        case/"energies.png", runs, {"bar1": "bar 1", "bar2": "bar 2"},
        TIME_UNIT, "energy [J]")


if __name__ == "__main__":
    main(*sys.argv[1:])
