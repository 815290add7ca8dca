#!/usr/bin/env python3
"""Pictures of this case: force.png, traction.png, deformation.png and
energies.png.

    plot.py [CASE]
"""

import sys
from pathlib import Path

import numpy as np

from vertexContactCases import (drawFields, drawHistories, drawSolids,
                                hertzSolution, readResults)
from vertexContactCases.readFields import Reader

MESHES = {0.28: "Mesh I", 0.21: "Mesh II", 0.14: "Mesh III", 0.105: "Mesh IV"}
TIMES = 0.001, 0.0025, 0.004, 0.0055
LARGEST_FORCE = 0.0025      # the written time that is closest to it
TIME_UNIT = "ms", 1e-3
PRESSURE = drawFields.Field("pressure", "pressure [kPa]", 1e3)
# The mirrors are in front, z points upwards; seen from the height of the
# equator
VIEW = drawSolids.turn(0, -90) @ drawSolids.turn(2, 45)


def settings(case):
    """Scene, and edge length at the contact [mm], negative so that finer
    meshes come later."""
    return (str(drawHistories.parameter(case, "scene", "plane")),
            -float(drawHistories.parameter(case, "size", 0.21)))


def label(case):
    scene, size = settings(case)
    mesh = MESHES.get(-size, f"edges of {-size:g} mm")
    return f"{mesh}, {scene}"


def force(case):
    """Times, and the force on the whole sphere 1; the model is a quarter."""
    data = readResults.table(case, "contactForces", "contact.dat")
    return data["Time"], 4*np.abs(data["sphere1.surface:Fz"])


def tractions(case, time):
    """Distances from the axis, and normal tractions, of the nodes of the lower
    half of sphere 1."""
    surface = Reader(case).read(
        time, "surface", ("pointD", "contactTraction"))["sphere1"]
    lower = surface.points[:, 2] < hertzSolution.RADIUS
    x = (surface.points + surface["pointD"])[lower]
    return (np.hypot(x[:, 0], x[:, 1]),
            np.abs(surface["contactTraction"][lower, 2]))


def plotForce(file, runs):
    unit, value = TIME_UNIT
    with drawHistories.diagram(
            file, f"time [{unit}]", "force on the sphere [N]") as ax:
        times, values = hertzSolution.history()
        ax.plot(times/value, values, color="black", label="Hertz")
        for run in runs:
            times, values = force(run.folder)
            ax.plot(times/value, values, label=run.label, **run.style)


def plotTraction(file, case):
    """Traction compared with the theory for the force at this time."""
    F = np.interp(LARGEST_FORCE, *force(case))
    a = hertzSolution.contactRadius(F)
    with drawHistories.diagram(
            file, "distance from the axis [mm]", "contact traction [kPa]",
            title=f"{LARGEST_FORCE/1e-3:g} ms") as ax:
        ax.margins(x=0.05)
        r = np.linspace(0, 1.5*a, 301)
        ax.plot(r/1e-3, hertzSolution.pressure(r, F)/1e3, color="black",
                label=f"Hertz, {F:.3g} N")
        r, t = tractions(case, LARGEST_FORCE)
        near = r < 1.5*a
        ax.plot(r[near]/1e-3, t[near]/1e3, "o", markersize=4,
                label=label(case))


def main(case="."):
    case = Path(case)
    runs = drawHistories.findRuns(case, settings, label)
    plotForce(case/"force.png", runs)
    plotTraction(case/"traction.png", case)
    drawSolids.draw(
        case/"deformation.png", drawSolids.read(case, TIMES, PRESSURE, VIEW),
        PRESSURE, TIME_UNIT, columns=len(TIMES), width=12)
    drawHistories.plotEnergy(
        case/"energies.png", runs, TIME_UNIT, ("µJ, of the quarter", 1e-6))


if __name__ == "__main__":
    main(*sys.argv[1:])
