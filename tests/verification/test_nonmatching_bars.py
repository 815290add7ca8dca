"""Impact of two bars with meshes that do not match (Section 7.3)."""

import numpy as np
import pytest

from vertexContactCases import readResults
from vertexContactTests.caseTools import (Tutorial, checkEnergies, relativeL1,
                                          root)

BARS = "nonMatchingBars"
NEAREST = (("PAIRING", "nearestFace"),)
RELEASE = (("endTime", 2.5e-4),)
SHORT = (("endTime", 1e-5),)
COARSE = Tutorial(BARS, "2", control=RELEASE)
COARSE_NEAREST = Tutorial(BARS, "2", control=RELEASE, options=NEAREST)
FULL_COARSE = Tutorial(BARS, "2")
FULL = Tutorial(BARS)
PEAK = Tutorial(BARS, control=SHORT)
PEAK_NEAREST = Tutorial(BARS, control=SHORT, options=NEAREST)

scenes = pytest.mark.scenes


def force(case):
    """Contact force by time."""
    return np.abs(case.contact("bars")["bar1.right:Fx"])


def impulse(case):
    return case.contact("bars")["bar1.right:Ix"][-1]


def difference(case, field, column):
    """Relative L1 difference from conforming meshes, x component at the
    corner of bar 2."""
    data = readResults.csv(
        root/"tutorials"/BARS/"referenceData"/"conforming.csv")
    times, values = case.probe("pointA", field)
    return relativeL1(data["Time"],
                      np.interp(data["Time"], times, values[:, 0]),
                      data[column])


def checkImpact(f, case):
    contact, momentum = case.contact("bars"), case.momentum
    touching = contact["area"] > 0
    f.within("first contact [us]", 1e6*contact["Time"][touching][0], 4, 0.1)
    f.atMost("change of total momentum / a bar's", max(
        np.abs(momentum[f"total:p{c}"] - momentum[f"total:p{c}"][0]).max()
        for c in "xyz")/momentum["bar1:px"][0], 1e-12)
    checkEnergies(f, case, "bars", balance=5e-4, total=3e-3, penetration=0.08)


@scenes(COARSE, COARSE_NEAREST)
@pytest.mark.parametrize("scene", (COARSE, COARSE_NEAREST),
                         ids=("AMI", "nearestFace"))
def test_coarse_bars_close_their_balances(run, figures, scene):
    """5 and 2 elements over the width, until 250 us."""
    case = run(scene)
    pairing = dict(scene.options).get("PAIRING", "AMI")
    with figures(f"3.4 non-matching bars, 5:2, {pairing}") as f:
        checkImpact(f, case)
        contact = case.contact("bars")
        f.within("last contact [us]",
                 1e6*contact["Time"][contact["area"] > 0][-1], 239, 4)
        f.atLeast("energy at 250 us / initial",
                  case.totalEnergy[-1]/case.totalEnergy[0], 0.8)
        # The peak is in the first step; the impulse covers all steps
        f.within("peak force of this pairing / AMI",
                 force(case).max()/force(run(COARSE)).max(), 1, 0.01)
        f.within("impulse of this pairing / AMI",
                 impulse(case)/impulse(run(COARSE)), 1, 0.01)


@scenes(PEAK, PEAK_NEAREST)
def test_peak_force(run, figures):
    """10 and 4 elements over the width (Mesh I), until 10 us."""
    with figures("3.4 non-matching bars, Mesh I, until 10 us") as f:
        for scene in PEAK, PEAK_NEAREST:
            checkImpact(f, run(scene))
        f.within("peak force, nearestFace / AMI",
                 force(run(PEAK_NEAREST)).max()/force(run(PEAK)).max(), 1,
                 0.01)
        f.within("impulse, nearestFace / AMI",
                 impulse(run(PEAK_NEAREST))/impulse(run(PEAK)), 1, 0.01)


@scenes(FULL, FULL_COARSE)
def test_agrees_with_conforming_meshes(run, figures):
    """Mesh I, against conforming meshes of 10 elements over the width."""
    case = run(FULL)
    with figures("3.4 non-matching bars, Mesh I") as f:
        checkImpact(f, case)
        for field, column in ("pointU", "vx"), ("pointD", "ux"):
            f.falling(f"{column} of the corner, relative L1 difference from "
                      "conforming meshes, 5:2 and 10:4",
                      [difference(c, field, column)
                       for c in (run(FULL_COARSE), case)])
