#!/usr/bin/env python3
"""Pictures of this case: velocities.png, forces.png, spheres.png and
energies.png.

    plot.py [CASE]
"""

import sys
from pathlib import Path

from vertexContactCases import (drawFields, drawHistories, drawSolids,
                                hertzChain, readResults)
from vertexContactCases.drawHistories import plt

MESHES = {3: "Mesh I", 4: "Mesh II", 6: "Mesh III", 8: "Mesh IV"}
TIMES = 0.001, 0.0025, 0.0055, 0.008, 0.011, 0.0145
TIME_UNIT = "ms", 1e-3
VELOCITY = drawFields.Field("pointU", "velocity $v_x$ [m/s]", 1, 0,
                            signed=False)
# The mirror y = 0 is in front, z points upwards
VIEW = drawSolids.turn(0, -90)
CHAINS = ({"finite": False, "style": dict(color="0.5", linestyle="--"),
           "label": "chain of half spaces (Hertz)"},
          {"finite": True, "style": dict(color="black", linestyle="-"),
           "label": "chain of finite spheres"})


def settings(case):
    """Elements over the radius of the largest contact, and gap [mm]."""
    return (int(drawHistories.parameter(case, "nContact", 4)),
            float(drawHistories.parameter(case, "gap", 1e3*hertzChain.GAP)))


def label(case):
    n, gap = settings(case)
    return f"{MESHES.get(n, f'{n} elements')}, gaps of {gap:g} mm"


def finish(file, figure, ax, ylabel):
    ax.set(xlabel=f"time [{TIME_UNIT[0]}]", ylabel=ylabel)
    ax.grid(color="0.9")
    ax.margins(x=0)
    figure.legend(ncols=3, loc="outside upper center")
    figure.savefig(file, dpi=drawHistories.DPI)
    plt.close(figure)


def plotHistories(velocityFile, forceFile, runs):
    """All runs with the gap of the last run, and the chains with this gap."""
    value = TIME_UNIT[1]
    gap = settings(runs[-1].folder)[1]
    runs = [run for run in runs if settings(run.folder)[1] == gap]
    end = hertzChain.velocities(runs[-1].folder)[0][-1]
    chains = [(*hertzChain.chain(end, 1e-3*gap, c["finite"]), c)
              for c in CHAINS]

    figure, ax = plt.subplots(figsize=(9, 5.5), layout="constrained")
    for times, v, _, c in chains:
        ax.plot(times/value, v, **c["style"], linewidth=1.2,
                label=[c["label"]] + ["_"]*(v.shape[1] - 1))
    for run in runs:
        times, v = hertzChain.velocities(run.folder)
        ax.plot(times/value, v, **run.style,
                label=[run.label] + ["_"]*(v.shape[1] - 1))
    last = chains[-1][1]
    for i, v in enumerate(last.T):
        ax.annotate(f"{i + 1}", (times[-1]/value, v[-1]), xytext=(4, 0),
                    textcoords="offset points", va="center", fontsize=8)
    finish(velocityFile, figure, ax, "velocity / first sphere's at the start")

    figure, ax = plt.subplots(figsize=(9, 5), layout="constrained")
    for times, _, F, c in chains:
        ax.plot(times/value, F, **c["style"], linewidth=1.2,
                label=[c["label"]] + ["_"]*(F.shape[1] - 1))
    for run in runs:
        for i, (t, F) in hertzChain.contactForces(run.folder).items():
            ax.plot(t/value, F, **run.style,
                    label=run.label if i == 1 else "_")
    finish(forceFile, figure, ax, "force between neighbours [N]")


def plotEnergies(file, run):
    """Kinetic energy of each sphere, and the sum of all energies."""
    data = readResults.table(run.folder, "solidEnergies", "energies.dat")
    unit, value = TIME_UNIT
    total = data["total:kinetic"] + data["total:strain"]
    figure, (left, right) = plt.subplots(
        1, 2, figsize=(11, 4.5), sharex=True, layout="constrained")
    for i in range(1, hertzChain.SPHERES + 1):
        left.plot(data["Time"]/value,
                  100*data[f"sphere{i}:kinetic"]/total[0],
                  label=f"kinetic, sphere {i}")
    left.plot(data["Time"]/value, 100*data["total:strain"]/total[0],
              color="0.5", linestyle="--", label="strain, all")
    left.plot(data["Time"]/value, 100*total/total[0], color="black",
              label="total")
    for name, values in (
            ("lost in all", total[0] - total),
            ("numerical dissipation", data["total:numericalDissipation"]),
            ("taken by contact", -data["total:contactWork"])):
        right.plot(data["Time"]/value, 100*values/total[0], label=name)
    for ax in left, right:
        ax.set(xlabel=f"time [{unit}]", ylabel="energy / initial energy [%]",
               title=run.label)
        ax.grid(color="0.9")
        ax.margins(x=0)
    left.legend(loc="center right", framealpha=1, fontsize="small")
    right.legend()
    figure.savefig(file, dpi=drawHistories.DPI)
    plt.close(figure)


def main(case="."):
    case = Path(case)
    runs = drawHistories.findRuns(case, settings, label)
    plotHistories(case/"velocities.png", case/"forces.png", runs)
    plotEnergies(case/"energies.png", runs[-1])
    drawSolids.draw(
        case/"spheres.png", drawSolids.read(case, TIMES, VELOCITY, VIEW),
        VELOCITY, TIME_UNIT, columns=2, width=12)


if __name__ == "__main__":
    main(*sys.argv[1:])
