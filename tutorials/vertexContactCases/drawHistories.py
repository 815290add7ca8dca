"""Histories of the meshes that a tutorial has been run with, in one picture.

Allrun keeps the histories of each mesh in results/<MESH>, which looks like a
case as far as postProcessing and system/caseParameters go.
"""

from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
from foamlib import FoamFile

from vertexContactCases import readResults

DPI = 150


@dataclass(frozen=True)
class Run:
    """The case with the histories of a mesh, and their style."""

    folder: Path
    label: str
    style: dict


def parameter(case, key, default=None):
    """A value that Allrun wrote into system/caseParameters or
    presetParameters."""
    for name in "caseParameters", "presetParameters":
        file = Path(case)/"system"/name
        found = FoamFile(file).get(key) if file.exists() else None
        if found is not None:
            return found
    return default


def findRuns(case, size, label):
    """Runs sorted by size(folder), a number. The run of the case is the last
    one and is highlighted."""
    case = Path(case)
    others = {size(folder): folder for folder in (case/"results").glob("*")
              if (folder/"postProcessing").is_dir()}
    others.pop(size(case), None)
    runs = [Run(folder, label(folder), dict(color=f"C{i}", linewidth=1))
            for i, (_, folder) in enumerate(sorted(others.items()), start=1)]
    return [*runs, Run(case, label(case),
                       dict(color="C0", linewidth=2, zorder=1.9))]


@contextmanager
def diagram(file, xlabel, ylabel, **others):
    """Axes of a picture of one diagram, which is written at the end.

    others  what Axes.set takes
    """
    figure, ax = plt.subplots(figsize=(8, 5), layout="constrained")
    ax.margins(x=0)
    yield ax
    ax.set(xlabel=xlabel, ylabel=ylabel, **others)
    ax.grid(color="0.9")
    ax.legend()
    figure.savefig(file, dpi=DPI)
    plt.close(figure)


def _finish(figure, axes, file, timeLabel, lines):
    """The style that all pictures share."""
    for ax in axes.flat:
        ax.grid(color="0.9")
    for ax in axes[-1]:
        ax.set_xlabel(timeLabel)
    axes[0, 0].margins(x=0)
    figure.get_layout_engine().set(wspace=0.04)
    figure.legend(*lines, ncols=3, loc="outside upper center")
    figure.savefig(file, dpi=DPI)
    plt.close(figure)


def plotHistories(file, runs, points, quantities, timeUnit, contact,
                  component=0):
    """Quantities (rows) at points (columns), over time, of all runs.

    points      {function object: title}
    quantities  ((field, label, unit), ...)
    timeUnit    ("ms", 1e-3)
    contact     time of the impact, by the gap and the velocities
    component   of vectors and tensors
    """
    unit, value = timeUnit
    figure, axes = plt.subplots(
        len(quantities), len(points), figsize=(10, 3*len(quantities)),
        sharex=True, sharey="row", squeeze=False, layout="constrained")
    for column, (point, title) in zip(axes.T, points.items()):
        for ax, (field, label, fieldUnit) in zip(column, quantities):
            ax.axvline(contact/value, color="black", linewidth=1,
                       linestyle=":", label="first contact, expected")
            for run in runs:
                t, values = readResults.probe(run.folder, point, field)
                ax.plot(t/value, values[:, component]/fieldUnit,
                        label=run.label, **run.style)
            if ax in axes[:, 0]:
                ax.set_ylabel(label)
        column[0].set_title(title)
    _finish(figure, axes, file, f"time [{unit}]",
            axes[0, 0].get_legend_handles_labels())


def plotEnergies(file, runs, bodies, timeUnit,
                 label="energy per thickness [J/m]"):
    """Total energy and accumulated numerical dissipation of all runs, and the
    energies of each body in the last one.

    bodies      {region: title}
    label       of the latter
    """
    unit, value = timeUnit
    figure, axes = plt.subplots(
        2, len(bodies), figsize=(11, 8), sharex=True, layout="constrained")
    axes[1, 1].sharey(axes[1, 0])
    for run in runs:
        data = readResults.table(run.folder, "solidEnergies", "energies.dat")
        t = data["Time"]/value
        total = data["total:kinetic"] + data["total:strain"]
        for ax, energy in zip(
                axes[0], (total, data["total:numericalDissipation"])):
            ax.plot(t, 100*energy/total[0], label=run.label, **run.style)
    axes[0, 0].set_title("total energy of both bodies")
    axes[0, 1].set_title("numerical dissipation, accumulated")
    for ax in axes[0]:
        ax.set_ylabel("energy / initial energy [%]")

    for ax, (body, title) in zip(axes[1], bodies.items()):
        kinetic, strain = data[f"{body}:kinetic"], data[f"{body}:strain"]
        for name, energy, style in (("total", kinetic + strain, "-"),
                                    ("kinetic", kinetic, "--"),
                                    ("strain", strain, "-.")):
            ax.plot(t, energy, style, color="C0", label=name)
        ax.set_title(f"{title}, {runs[-1].label}")
        ax.set_ylabel(label)
    axes[1, 0].margins(y=0.12)
    axes[1, 0].legend(loc="upper right", ncols=3)
    _finish(figure, axes, file, f"time [{unit}]",
            axes[0, 0].get_legend_handles_labels())


def plotEnergy(file, runs, timeUnit, energyUnit):
    """Of one body, or of all together. Left: energies of the last run. Right:
    total energy and accumulated numerical dissipation of all.

    energyUnit  ("MJ", 1e6)
    """
    unit, value = timeUnit
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
    parts = [("total", total, "-"), ("kinetic", kinetic, "--"),
             ("strain", strain, "-."),
             ("numerical dissipation", dissipation, ":")]
    plastic = data["total:plasticDissipation"]
    if plastic[-1] > 0:
        parts.append(("plastic dissipation", plastic, (0, (5, 1, 1, 1, 1, 1))))
    for name, energy, style in parts:
        left.plot(t, energy/energyUnit[1], linestyle=style, color="C0",
                  label=name)
    left.set(title=runs[-1].label, ylabel=f"energy [{energyUnit[0]}]")
    right.set(title="total energy, and (dotted) numerical dissipation",
              ylabel="energy / initial energy [%]")
    for ax in left, right:
        ax.grid(color="0.9")
        ax.margins(x=0)
        ax.set_xlabel(f"time [{unit}]")
        ax.legend(loc="center right")
    figure.savefig(file, dpi=DPI)
    plt.close(figure)


def plotWork(file, run, timeUnit, energyUnit, parts):
    """Where the work of the loads is, of all bodies of a run.

    energyUnit  ("MJ", 1e6)
    parts       {column of energies.dat: what it is called}
    """
    data = readResults.table(run.folder, "solidEnergies", "energies.dat")
    with diagram(file, f"time [{timeUnit[0]}]", f"energy [{energyUnit[0]}]",
                 title=run.label) as ax:
        for key, name in parts.items():
            ax.plot(data["Time"]/timeUnit[1],
                    data[f"total:{key}"]/energyUnit[1], label=name)
