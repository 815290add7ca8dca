"""Writes the page stability.md and its pictures from the rows of the table."""

import inspect
import json
import textwrap
from collections import Counter
from fractions import Fraction

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap

from .groups import CELLS, GROUPS, PRESETS
from .judge import BALANCE, GAINS, OUTCOMES, RISE, STABLE, STOPPED, WRONG

MARKS = {STABLE: "·", GAINS: "energy", STOPPED: "stopped", WRONG: "**wrong**"}
COLOURS = "#8bc48a", "#f2c14e", "#9aa0a6", "#d1495b"

# maxCo of the presets balanced and paper
DEFAULT, PAPER = 0.9, 0.6

TITLES = {
    "presets": "Poisson's ratio, step and preset",
    "step": "Largest stable step",
    "release": "Release from another volume",
    "mach": "Impact Mach number",
    "impedance": "Impedance ratio",
    "faces": "Face-size ratio, impact",
    "pressure": "Face-size ratio, uniform pressure",
    "gap": "Initial gap and overlap",
    "slivers": "Slivers",
    "aspect": "Aspect ratio",
    "units": "Units",
    "single": "One cell a body",
    "cradle": "Ten bodies in a row",
    "friction": "Friction",
    "settling": "Rest under gravity",
    "resting": "Rest after a damping",
    "spin": "Free rotation",
    "vibration": "Free vibration",
    "paper": "Impacts with the scheme of the paper",
    "paperStep": "Largest stable step of the scheme of the paper"}

# The head of the page
GOOD = (
    """The step. The bound of the step is what a body can take: it is stable at
    least up to 1.0 of the bound in one dimension and 1.1 in two and three,
    whatever the cells, the correction, Poisson's ratio and the deformation. The default is
    0.9 of the bound.""",
    """Impacts: up to 1.2 times the speed of waves, impedances up to 1:1e6,
    slivers down to 0.5 degrees, aspect ratios of cells up to 1:100, any
    Poisson's ratio, all presets: the energy never exceeds the initial one.""",
    """Bodies of three cells across, or more, gain no energy in a million steps
    of vibration; nor do bodies that turn 4881 times.""",
    """Blocks come to rest, on a plane and on bodies whose cells have the same
    length or down to a fourth of it, with friction and tied, in two and three
    dimensions. On fine bases this takes longest: on a base of 1:4 a block in
    two dimensions still moves by some 1e-8 of a cell in the second half of a
    million steps, by 1e-12 in that of two million. None gains energy (rest
    under gravity).""",
    """Blocks at rest stay at rest. After a damping in the first quarter of the
    time, no block moves by more than 1e-10 of a cell in the second half of a
    million steps: with friction or without, tied, or on a slope of half and
    nine tenths of the angle of friction (rest after a damping).""",
    """Faces of 1:64 take energy from an impact and give none, however seldom
    they are paired (faces).""")
POOR = (
    """Preset fast has longer steps. With it impacts gain up to 0.6 % of their
    energy at the default step (0.5 % are allowed here), and far more beyond
    1.1 of the stable step. Bodies that begin with large stresses, which are
    released, have balances of up to 12 % where they gain no energy; with half
    of the step these are four times better (presets, release).""",
    """Where contact is only a few faces wide, the gap gives way under load: a
    block on a base with a coefficient of friction of 10 penetrates it by a
    tenth of a cell (friction).""",
    """Bodies of one or two cells across, in all directions, vibrate for ever.
    With large amplitudes their energy rises and falls by up to 2 %, with
    preset fast by up to a sixth (free vibration).""",
    """Without friction blocks slide off soft bases, as physics has it. Half a
    block, held by a mirror plane, swings with its base for a million steps
    and longer (rest under gravity).""",
    """Rubber with a Poisson's ratio of 0.49 or more that is released from
    another volume, 40 % less or 60 % more, may gain energy or stop within a
    few steps: with native cells, with simplicialSingle cells in three
    dimensions, and at 0.4999, squeezed, with any cells in three dimensions.
    Since November 2026 nothing resists the rate of the volume; before, most of
    these runs were stable (release).""",
    """Bodies that start inside each other are pushed apart, with energy that
    no body has given (gap).""")

# Explanations of the unstable runs
NOTES = {
    "release": """The length of a step is what is stable in the state at its
    beginning. Where pressures of hundreds of times the modulus are released,
    the body becomes stiffer within a step: for a few steps the dissipation
    then feeds energy instead. With maxCo 0.6 squeezed bodies are stable in 3D
    with simplicial cells, and with simplicialSingle ones at 0.499; with native
    cells no step helps. Balances of 0.05 to 0.12 are the accuracy of such a
    step, not a gain: with two thirds of the step 0.12 becomes 0.05.""",
    "gap": """Surfaces that are inside each other at the start separate at the
    speed gap/tau, where tau is the time of a wave through the cells there. No
    body has given the energy for this. It is the rise of bars that begin 0.05
    of a cell inside each other, and is as large with a small step (0.107 in
    1D).""",
    "cradle": """Contact slows surfaces down before they touch. That costs
    energy where the gap is a fraction of a cell: here nine times. With a small
    step 0.754 of the velocity remains.""",
    "settling": """A node that sticks remembers where it began to stick. Before
    this was so, a block of 2 x 2 x 2 cells on a body of the same cells turned
    about its vertical axis. Without friction and without the plane of
    symmetry, the displacement of a block along its base grows from round-off
    with 0.03 per unit of time at 5 % of the modulus, 0.003 at 0.5 %.""",
    "vibration": """Bodies of one or two cells across have vibrations without
    any dissipation, since the velocity jumps do not see them. Their energy
    varies, since in a step that is not small strains of some tenths are not
    linear, but it does not grow. Before the step was the least of the last
    ones (recentLeast), they reached up to a thousand times their energy: in
    each period, a step that follows the deformation is shorter where the body
    is squeezed than where it is stretched, and that feeds energy. Energies are
    sampled once in steps/20000 steps: within the first few, in which most is
    dissipated, the balance is up to 0.03, with preset fast up to 0.22.""",
    "paper": """Without reconstruction waves dissipate so much that velocities
    are wrong; with the full reconstruction energy rises where all modes of a
    mesh are excited."""}

# Groups whose table has all figures of each run. Otherwise the last parameter
# is in columns
LISTED = "single", "cradle", "settling", "resting", "spin", "vibration"


class Row:
    """A run, read from the table."""

    def __init__(self, row):
        self.group, self.outcome = row["group"], row["outcome"]
        self.why, self.seconds = row["why"], float(row["seconds"])
        self.parameters = json.loads(row["parameters"])
        if self.group in ("step", "paperStep"):
            self.parameters |= self.parameters.pop("scheme")
        self.figures = json.loads(row["figures"])

    def __getitem__(self, name):
        return self.parameters[name]


def wrapped(text, **more):
    return textwrap.fill(" ".join(text.split()), 150, break_long_words=False,
                         break_on_hyphens=False, **more)


def table(head, lines):
    rows = [head, ["---"]*len(head), *lines]
    return "\n".join(f"| {' | '.join(str(c) for c in r)} |" for r in rows)


def span(bounds):
    """The range of the bounds of all runs, which may differ between runs."""
    known = sorted({b for b in bounds if b is not None})
    ends = dict.fromkeys(known[:1] + known[-1:])
    return " … ".join(f"{b:.3g}" for b in ends)


def limits(rows):
    """The limits for all runs of a group."""
    found = {}
    for row in rows:
        for name, (_, *bounds) in row.figures.items():
            found.setdefault(name, []).append(bounds)
    lines = []
    for name, bounds in found.items():
        least, most = (span(b) for b in zip(*bounds))
        if most:
            least = f" at least {least} and" if least not in ("", "0") else ""
            lines.append(f"{name}{least} at most {most}")
    return ", ".join(lines)


def pivot(rows):
    """A table with the last parameter in columns, and all others in rows."""
    *names, last = rows[0].parameters
    columns = list(dict.fromkeys(r[last] for r in rows))
    lines = {}
    for r in rows:
        lines.setdefault(tuple(r[n] for n in names), {})[r[last]] = \
            MARKS[r.outcome]
    return table([*names, *(f"{last} {columns[0]:g}"
                            if not isinstance(columns[0], str) and i == 0
                            else c for i, c in enumerate(columns))],
                 [[*key, *(line.get(c, "") for c in columns)]
                  for key, line in lines.items()])


def listed(rows):
    names = list(rows[0].parameters)
    figures = list(dict.fromkeys(f for r in rows for f in r.figures))
    return table([*names, "outcome", *figures], [
        [*r.parameters.values(), r.outcome, *(
            f"{r.figures[f][0]:.3g}" if f in r.figures else ""
            for f in figures)] for r in rows])


def bad(rows):
    """The unstable runs and the reasons: one line per reason."""
    reasons = {}
    for r in rows:
        if r.outcome != STABLE:
            reasons.setdefault((r.outcome, r.why.split(":")[0]
                                if r.outcome == STOPPED else r.why), []
                               ).append(r)
    lines = []
    for (outcome, why), some in reasons.items():
        first = " ".join(f"{k} {v}" for k, v in some[0].parameters.items())
        more = f" and {len(some) - 1} more" if len(some) > 1 else ""
        lines.append(wrapped(f"- {outcome}: {first}{more}: {why}",
                             subsequent_indent="  "))
    return "\n".join(lines)


def worst(rows):
    """Largest figures of the stable runs."""
    good = [r for r in rows if r.outcome == STABLE]
    names = [f for f in dict.fromkeys(f for r in good for f in r.figures)
             if f not in ("steps", "angle")]
    return ", ".join(f"{name} " + format(max(
        abs(r.figures[name][0]) for r in good if name in r.figures), ".2g")
        for name in names)

# The largest stable step

def largestStep(rows, *names):
    """The largest maxCo up to which all runs are stable, by these
    parameters."""
    found = {}
    keys = dict.fromkeys(tuple(r[n] for n in names) for r in rows)
    for key in keys:
        mine = [r for r in rows if tuple(r[n] for n in names) == key]
        found[key] = 0
        for value in sorted({r["maxCo"] for r in mine}):
            if any(r.outcome != STABLE for r in mine if r["maxCo"] == value):
                break
            found[key] = value
    return found


def stepTable(rows):
    names = "dimensions", "cells", "correction", "nu", "stretch"
    found = largestStep(rows, *names)
    stretches = list(dict.fromkeys(k[-1] for k in found))
    lines = []
    for key in dict.fromkeys(k[:-1] for k in found):
        values = [found[(*key, s)] for s in stretches]
        lines.append([f"{key[0]}D", key[1], Fraction(key[2]).limit_denominator(
            99), key[3], *(f"{v:g}" for v in values),
            f"{min(values)/DEFAULT:.2f}"])
    return table(["", *names[1:4], *("free" if s == 1 else f"length {s}"
                                     for s in stretches),
                  f"margin of {DEFAULT:g}"], lines)


def paperTable(rows):
    found = largestStep(rows, "reconstruction", "nu", "dimensions")
    lines = []
    for key in dict.fromkeys(k[:2] for k in found):
        three = [found[(*key, d)] for d in (1, 2, 3)]
        lines.append([*key, *(f"{g:g}" for g in three),
                      f"{min(three)/PAPER:.2f}"])
    return table(["reconstruction", "nu", "1D", "2D", "3D",
                  f"margin of {PAPER:g}"], lines)


# Pictures

def save(figure, file):
    figure.savefig(file, dpi=80, bbox_inches="tight")
    plt.close(figure)


def presetPicture(rows, file):
    presets = [p for p in PRESETS if any(r["preset"] == p for r in rows)]
    nus = sorted({r["nu"] for r in rows})
    steps = sorted({r["maxCo"] for r in rows})
    figure, axes = plt.subplots(1, len(presets), squeeze=False, sharey=True,
                                figsize=(3.2*len(presets) + 0.6, 2.8))
    for axis, preset in zip(axes[0], presets):
        grid = np.full((len(nus), len(steps)), np.nan)
        for r in rows:
            if r["preset"] == preset:
                grid[nus.index(r["nu"]), steps.index(r["maxCo"])] = \
                    OUTCOMES.index(r.outcome)
        axis.imshow(grid, cmap=ListedColormap(COLOURS), vmin=0, vmax=3,
                    aspect="auto", origin="lower")
        axis.set_xticks(range(1, len(steps), 2), [
            f"{s:g}" for s in steps[1::2]])
        axis.set_yticks(range(len(nus)), [f"{n:g}" for n in nus])
        axis.set(title=preset, xlabel="maxCo")
    axes[0][0].set_ylabel("Poisson's ratio")
    figure.legend(handles=[plt.Rectangle((0, 0), 1, 1, color=c)
                           for c in COLOURS], labels=OUTCOMES, ncol=4,
                  loc="lower center", bbox_to_anchor=(0.5, -0.18),
                  frameon=False)
    save(figure, file)


def stepPicture(rows, file):
    """The smallest value over all corrections and lengths."""
    found = largestStep(rows, "nu", "cells", "dimensions")
    nus = list(dict.fromkeys(k[0] for k in found))
    figure, axes = plt.subplots(1, len(nus), squeeze=False, sharey=True,
                                figsize=(3.6*len(nus) + 0.6, 2.6))
    for axis, nu in zip(axes[0], nus):
        for i, d in enumerate((1, 2, 3)):
            values = [found.get((nu, c, d), 0) for c in CELLS]
            axis.bar(np.arange(3) + 0.27*(i - 1), values, 0.25,
                     label=f"{d}D", color=("#2b6f9e", "#6aa9d0", "#b9d6ea")[i])
        axis.axhline(DEFAULT, color="#d1495b", lw=1.2, label="default")
        axis.set_xticks(range(3), CELLS)
        axis.set_title(f"nu = {nu:g}")
    axes[0][0].set_ylabel("largest stable maxCo")
    axes[0][-1].legend(frameon=False, fontsize=8, ncol=4, loc="lower right",
                       bbox_to_anchor=(1, 1.1))
    save(figure, file)


def section(here, group, rows):
    text = [f"## {TITLES[group]}", ""]
    text.append(wrapped("As above." if group == "paperStep" else
                        inspect.getdoc(GROUPS[group][0])))
    text.append("")
    if group == "step":
        stepPicture(rows, here/"step.png")
        text += [stepTable(rows), "", "![largest stable maxCo by "
                 "cells and dimension](stability/step.png)", ""]
    elif group == "paperStep":
        text += [paperTable(rows), ""]
    elif group in LISTED:
        text += [listed(rows), ""]
    else:
        text += [pivot(rows), ""]
    if group == "presets":
        presetPicture(rows, here/"presets.png")
        text += ["![outcome by Poisson's ratio, maxCo and preset]"
                 "(stability/presets.png)", ""]
    asked = f"Limits: {limits(rows)}."
    if worst(rows):
        asked += f" Largest of the stable runs: {worst(rows)}."
    text += [wrapped(asked), ""]
    if group not in ("step", "paperStep") and bad(rows):
        text += [bad(rows), ""]
        if group in NOTES:
            text += [wrapped(NOTES[group]), ""]
    return text


HOLDS = "\n".join((
    "What holds:", "",
    *(wrapped(f"- {line}", subsequent_indent="  ") for line in GOOD), "",
    "What does not:", "",
    *(wrapped(f"- {line}", subsequent_indent="  ") for line in POOR)))


def write(here, rows):
    rows = [Row(r) for r in rows]
    groups = {g: [r for r in rows if r.group == g] for g in GROUPS}
    groups = {g: some for g, some in groups.items() if some}
    lines = []
    for group, some in groups.items():
        count = Counter(r.outcome for r in some)
        lines.append([f"[{TITLES[group]}](#{anchor(TITLES[group])})", group,
                      len(some), *(count[o] for o in OUTCOMES),
                      f"{sum(r.seconds for r in some):.0f}"])
    text = "\n".join((
        "# Stability map", "", wrapped(f"""This page shows what is stable, what
        is not, and why. It has more than a thousand small runs, each pushed in
        one direction until it fails or reaches the end of the range. They use
        the default scheme (preset balanced, maxCo {DEFAULT:g}) unless stated
        otherwise; two short groups at the end use preset paper. Lengths,
        densities and speeds of waves are of order 1."""), "", HOLDS, "",
        wrapped("""`tests/robustness/stability/map.py [-jobs N] [group ...]`
        writes this page from `stability/stability.csv`, which has the figures
        of each run. `tests/robustness/test_stability.py` runs a part of
        it."""), "",
        "Outcomes:", "",
        *(wrapped(f"- {line}", subsequent_indent="  ") for line in (
            f"""**stable** (`·`): the run was completed; the energy of all
            bodies minus the work of external loads never exceeds an earlier
            value by more than `rise`, {100*RISE:g} % of the initial energy
            unless the scene says otherwise; the residual of the energy balance
            is at most `balance`, {100*BALANCE:g} % of it; and all other figures
            of the scene are within the limits given below its table;""",
            """**gains energy** (`energy`): the run was completed, but the
            energy rises more;""",
            "**stopped**: the run ended with exit code 1 and one message;",
            """**wrong**: anything else: a crash, a run that does not end, or a
            figure outside its limits.""")), "", ""))
    text += table(["scene", "group", "runs", *OUTCOMES, "seconds of one core"],
                  lines) + "\n\n"
    for group, some in groups.items():
        text += "\n".join(section(here, group, some)) + "\n"
    (here.parent/"stability.md").write_text(text.rstrip() + "\n")


def anchor(title):
    return "".join(c for c in title.lower().replace(" ", "-")
                   if c.isalnum() or c == "-")
