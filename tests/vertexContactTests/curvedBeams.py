"""Two elastoplastic half rings that press past each other, with friction or
without, against published reactions (curvedBeams.csv).

The lower one, of radii 10 and 12 mm, stands on its ends; the ends of the upper
one, of 8 and 10 mm, are driven 31.5 mm along. Quasi-static there; here within
20 ms. Run, it makes curvedBeams.png."""

import tempfile
from pathlib import Path

import numpy as np

from vertexContactCases import drawHistories, readResults
from vertexContactCases.drawHistories import plt
from vertexContactTests.caseTools import DEFAULT, meansAround, root
from vertexContactTests.smallCases import (Body, SmallCase, condition,
                                           friction, interface, polar, table)

FOLDER = root/"tests"/"verification"/"publishedContact"
FILE = FOLDER/"curvedBeams.csv"
FRICTION = "0", "0.3", "0.6"
WAY = 31.5e-3
DURATION = 0.02
LOWER = 12.
# The rings just touch
UPPER = LOWER - np.sqrt(22**2 - 17**2)

STEEL = {"type": "HenckyVonMises", "rho": 7800, "E": 689.5564786e6,
         "nu": 0.32, "tauY": 31e6, "Hardening": 261.2e6}


def ring(name, inner, angle, centre, ends, outside, across):
    """Half a ring from a given angle on, 2 mm thick and 1 m wide; lengths in
    mm."""
    return Body(
        (across, 10*across), name=name, start=(1e-3*inner, angle, 0),
        size=(2e-3, np.pi, 1), material=dict(STEEL),
        moved=lambda X: polar(X) + 1e-3*np.array((*centre, 0)),
        sides={"bottom": ends, "top": ends, outside: "contact"})


def motion(duration=DURATION):
    """Motion of the ends [m/s]: a tenth of the time to start, a tenth to
    stop."""
    V = WAY/(0.9*duration)
    return condition("fixedVelocity", velocity=table(
        (0, (0, 0, 0)), (0.1*duration, (V, 0, 0)),
        (0.9*duration, (V, 0, 0)), (duration, (0, 0, 0))))


def write(folder, k, duration=DURATION, across=5):
    """The case, not run yet. across: cells through the thickness."""
    return SmallCase(
        folder,
        [ring("lower", 10, 0, (LOWER, 0),
              condition("fixedVelocity", velocity=(0, 0, 0)), "right",
              across),
         ring("upper", 8, np.pi, (UPPER, 17), motion(duration), "right",
              across)],
        duration,
        {"between": interface(("upper", "right"), ("lower", "right"),
                              friction(float(k)), pairing="nearestFace")},
        preset=DEFAULT, functions=("contactForces",),
        probes={"driven": ("upper", (1e-3*(UPPER - 9), 17e-3, 0))},
        control={"writeInterval": duration/10, "maxCo": 0.9})


def theirs():
    """The published table, with columns displacement, and k:x, k:y."""
    return readResults.csv(FILE)


def history(case):
    """Displacements [mm], and reactions along and across [N/mm], from a
    run."""
    contact = readResults.table(case.path, "contactForces", "between.dat")
    times, D = readResults.probe(case.path, "driven", "pointD")
    return 1e3*np.interp(contact["Time"], times, D[:, 0]), 1e-3*np.array(
        [contact[f"upper.right:F{c}"] for c in "xy"])


def reactions(case, way=0.3):
    """Displacements of theirs(), and means of the reactions over this distance
    in mm before and after them."""
    places = theirs()["displacement"]
    return places, meansAround(*history(case), places, way)


def plot(file, cases, way=0.3):
    """Plot the reactions of {k: case} over the published ones: as they are
    (pale), and as means over a distance in mm before and after."""
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.5), sharex=True,
                                layout="constrained")
    data = theirs()
    places = np.arange(way, 1e3*WAY - way, way)
    for (k, case), colour in zip(cases.items(), ("C0", "C1", "C2")):
        x, F = history(case)
        means = meansAround(x, F, places, way)
        for ax, values, mean, c in zip(axes, F, means, "xy"):
            ax.plot(x, values, color=colour, linewidth=0.3, alpha=0.2)
            ax.plot(places, mean, color=colour, linewidth=1.5,
                    label=f"k = {k}")
            ax.plot(data["displacement"], data[f"{k}:{c}"], "o",
                    color=colour, markerfacecolor="none", markersize=5,
                    label=f"Neto et al., k = {k}")
    for ax, name in zip(axes, ("along", "across")):
        ax.set(xlabel="displacement [mm]", ylabel=f"reaction {name} [N/mm]")
        ax.grid(color="0.9")
    axes[1].legend(fontsize=8)
    figure.savefig(file, dpi=drawHistories.DPI)
    plt.close(figure)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        plot(FILE.with_suffix(".png"), {
            k: write(Path(folder)/k, k).run() for k in FRICTION})
