#!/usr/bin/env python3
"""Pictures of this case: deformation.png and energies.png.

    plot.py [CASE]
"""

import os
import sys
from pathlib import Path

# tutorials/, also for a case that was copied elsewhere
sys.path += [str(Path(__file__).resolve().parent.parent),
             os.environ.get("VERTEXCONTACT_DIR", ".") + "/tutorials"]

import drawFields
import drawHistories
import drawSolids
import readResults
from drawFields import plt

MESHES = {4: "Mesh I", 6: "Mesh II", 8: "Mesh III"}
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


def plotEnergies(file, runs):
    """Left: energies of the last run. Right: total energy and numerical
    dissipation of all."""
    unit, value = TIME_UNIT
    figure, (left, right) = plt.subplots(
        1, 2, figsize=(11, 4.5), sharex=True, layout="constrained")
    for run in runs:
        data = readResults.table(run.folder, "solidEnergies", "energies.dat")
        t = data["Time"]/value
        kinetic, strain = data["total:kinetic"], data["total:strain"]
        dissipation = data["total:numericalDissipation"]
        total = kinetic + strain
        right.plot(t, 100*total/total[0], label=run.label, **run.style)
        right.plot(t, 100*dissipation/total[0], **{**run.style,
                                                   "linestyle": ":"})
    for name, energy, style in (
            ("total", total, "-"), ("kinetic", kinetic, "--"),
            ("strain", strain, "-."), ("numerical dissipation", dissipation,
                                       ":")):
        left.plot(t, energy/1e6, style, color="C0", label=name)
    left.set(title=runs[-1].label, ylabel="energy [MJ]")
    right.set(title="total energy, and (dotted) numerical dissipation",
              ylabel="energy / initial energy [%]")
    for ax in left, right:
        ax.grid(color="0.9")
        ax.margins(x=0)
        ax.set_xlabel(f"time [{unit}]")
        ax.legend(loc="center right")
    figure.savefig(file, dpi=drawHistories.DPI)
    plt.close(figure)


def main(case="."):
    case = Path(case)
    drawSolids.draw(
        case/"deformation.png", drawSolids.read(case, TIMES, PRESSURE),
        PRESSURE, TIME_UNIT, columns=len(TIMES))
    plotEnergies(case/"energies.png",
                 drawHistories.findRuns(case, size, label))


if __name__ == "__main__":
    main(*sys.argv[1:])
