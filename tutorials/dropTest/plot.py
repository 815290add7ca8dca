#!/usr/bin/env python3
"""Pictures of this case: force.png, stress.png, deformation.png and
energies.png.

    plot.py [CASE]
"""

import sys
from pathlib import Path

from vertexContactCases import (bumperModel, drawFields, drawHistories,
                                drawSolids, readResults)

MESHES = {3: "Mesh I", 4: "Mesh II", 6: "Mesh III", 8: "Mesh IV"}
TIMES = 0.0005, 0.001, 0.0015, 0.0025
TIME_UNIT = "ms", 1e-3
FIELDS = {"elastic": drawFields.Field("sigmaEq", "von Mises stress [MPa]", 1e6,
                                      signed=False)}
VIEW = drawSolids.turn(0, -75) @ drawSolids.turn(2, 25)


def settings(case):
    """Elements over the height of a foot, the kind of the box, and of the
    steps."""
    return (round(8/float(drawHistories.parameter(case, "size", 2))),
            str(drawHistories.parameter(case, "box", "elastic")),
            "own" if drawHistories.parameter(case, "subCycling") else "one")


def label(case):
    n, box, steps = settings(case)
    return (f"{MESHES.get(n, f'{n} elements')}, {box} box"
            + (", own steps" if steps == "own" else ""))


def plotForce(file, runs):
    """Force of the floor: unfiltered, filtered, and from the model."""
    unit, value = TIME_UNIT
    model = bumperModel.drop()
    with drawHistories.diagram(
            file, f"time [{unit}]", "force of the floor [N]") as ax:
        ax.plot((bumperModel.FIRST_CONTACT + model.times)/value, model.forces,
                color="black", label="mass on a spring")
        for run in runs:
            data = readResults.table(run.folder, "contactForces", "floor.dat")
            t = data["Time"]/value
            line, = ax.plot(t, data["bumper.bottom:Fz"], label=run.label,
                            **run.style)
        ax.plot(t, data["bumper.bottom:filteredFz"], "--",
                color=line.get_color(), label="the last, filtered at 2 kHz")


def plotStress(file, runs):
    """The largest stress in the box, at any place."""
    unit, value = TIME_UNIT
    with drawHistories.diagram(
            file, f"time [{unit}]",
            "largest von Mises stress in the box [MPa]") as ax:
        for run in runs:
            if settings(run.folder)[1] == "rigid":
                continue
            data = readResults.table(run.folder, "peaks", "extremes.dat")
            ax.plot(data["Time"]/value, data["box:sigmaEq:max"]/1e6,
                    label=run.label, **run.style)


def main(case="."):
    case = Path(case)
    runs = drawHistories.findRuns(case, settings, label)
    plotForce(case/"force.png", runs)
    if settings(case)[1] == "elastic":
        plotStress(case/"stress.png", runs)
        field = FIELDS["elastic"]
        drawSolids.draw(
            case/"deformation.png", drawSolids.read(case, TIMES, field, VIEW),
            field, TIME_UNIT, columns=2, width=10)
    drawHistories.plotEnergy(
        case/"energies.png", runs, TIME_UNIT, ("mJ", 1e-3))


if __name__ == "__main__":
    main(*sys.argv[1:])
