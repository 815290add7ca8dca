"""Run a case to its end or to its error, and find which of the four outcomes
it has."""

import re
from dataclasses import dataclass, field
from subprocess import TimeoutExpired

import numpy as np

from vertexContactTests.caseTools import DEFAULT
from vertexContactTests.smallCases import Body, SmallCase, largest

# Limits of the rise of the energy and of the residual of its balance, relative
# to the energy of the scene
RISE, BALANCE = 0.005, 0.05

STABLE, GAINS, STOPPED, WRONG = "stable", "gains energy", "stopped", "wrong"
OUTCOMES = STABLE, GAINS, STOPPED, WRONG


@dataclass
class Result:
    """Result of a run: the outcome, the measured figures with their limits
    (None: no limit), and the figures out of bounds, or the message."""

    outcome: str
    figures: dict = field(default_factory=dict)
    why: str = ""

    def __getitem__(self, name):
        return self.figures[name][0]


def small(folder, bodies, endTime, control=None, maxCo=None, preset=DEFAULT,
          scheme=None, **more):
    """A case with the solver's own defaults. All scenes accept these options:
    maxCo, if it differs from the default; preset; and options of the scheme
    for all bodies."""
    bodies = [bodies] if isinstance(bodies, Body) else bodies
    for body in bodies:
        body.scheme = {**body.scheme, **(scheme or {})}
    case = SmallCase(folder, bodies, endTime, control=control, preset=preset,
                     **more)
    file = case/"system/controlDict"
    text = re.sub(r"(?m)^maxCo .*\n", "", file.read_text())
    if maxCo is not None:
        text += f"maxCo {maxCo:.17g};\n"
    file.write_text(text)
    return case


def message(log):
    """First line of the only fatal error; empty if there is none."""
    found = re.findall(r"--> FOAM FATAL(?: IO)? ERROR:?[^\n]*\n(.*?)\n", log)
    return found[0].strip() if len(found) == 1 else ""


def ownEnergy(case):
    """Kept energy of all bodies minus the work of external loads. Interaction
    between the bodies may only lower it."""
    return case.keptEnergy - case.energies["total:externalWork"]


def rise(energy, scale):
    """Largest rise over any earlier value."""
    return float(np.max(energy - np.minimum.accumulate(energy))/scale)


def momentumChange(case, scale):
    p = case.momentumOf()
    return largest(p - p[0])/scale


def bounded(value, least, most):
    return np.isfinite(value) and (least is None or value >= least) \
        and (most is None or value <= most)


def outcome(case, check=None, scale=None, riseLimit=RISE,
            balanceLimit=BALANCE, parts=None):
    """Run and judge a case. check(case) gives (name, value, least, most) for
    the conditions of this scene. scale is an energy, or scale(case); by
    default it is the initial energy. With parts, the rise is computed from the
    largest energies in so many parts of the run."""
    try:
        code, log = case.attempt()
    except TimeoutExpired:
        return Result(WRONG, why="no end")
    if code != 0:
        told = message(log)
        clean = code == 1 and told
        return Result(STOPPED if clean else WRONG, {}, told or
                      f"exit code {code} without one message")
    if "\nEnd" not in log:
        return Result(WRONG, why="ends without End")
    energy = ownEnergy(case)
    if not np.all(np.isfinite(energy)):
        return Result(WRONG, why="energy not finite")
    scale = scale(case) if callable(scale) else scale or energy[0]
    if parts and len(energy) > parts:
        energy = np.array([e.max() for e in np.array_split(energy, parts)])
    rows = [("rise", rise(energy, scale), None, riseLimit),
            ("balance", largest(case.energies["total:balance"])/scale, None,
             balanceLimit),
            ("steps", int(re.search(r"\nSteps: (\d+) in", log)[1]), 1, None)]
    rows += check(case) if check else []
    figures = {name: (float(value), least, most)
               for name, value, least, most in rows}
    bad = [f"{name} {value[0]:.3g}" for name, value in figures.items()
           if not bounded(*value)]
    if not bad:
        return Result(STABLE, figures)
    gains = not bounded(*figures["rise"])
    return Result(GAINS if gains else WRONG, figures, ", ".join(bad))
