"""The legs of a hairpin clap together (Mesh I), compared with its upper half
on a rigid plane."""

import numpy as np
import pytest

from vertexContactTests.caseTools import (DEFAULT, Tutorial, checkEnergies,
                                          relativeL1)

HAIRPIN = "selfContact"
SELF, NON_MATCHING, HALF = (
    Tutorial(HAIRPIN, options=(("SCENE", scene),), preset=DEFAULT)
    for scene in ("self", "nonMatching", "half"))

scenes = pytest.mark.scenes


def difference(case, half, point, field, end):
    """Relative L1 difference from the half, y component at a point until a
    time."""
    t, values = case.probe(point, field)
    t0, expected = half.probe(point, field)
    expected, t0 = expected[t0 <= end], t0[t0 <= end]
    return relativeL1(t0, np.interp(t0, t, values[:, 1]), expected[:, 1])


@scenes(SELF, NON_MATCHING, HALF)
@pytest.mark.parametrize("scene", (SELF, NON_MATCHING),
                         ids=("self", "nonMatching"))
def test_whole_does_as_the_half(run, figures, scene):
    """Both are equal except for the difference between a rigid plane at nodes
    and overlaps of faces: the tips bounce off each other about ten times."""
    case, half = run(scene), run(HALF)
    with figures(f"Self-contact, {dict(scene.options)['SCENE']}, and half"
                 ) as f:
        for field, tolerance in ("pointU", 0.12), ("pointD", 0.03):
            for point in "pointA", "pointB":
                for end in 0.01, 0.02:
                    f.atMost(f"{point}, {field} until {1e3*end:g} ms: "
                             "difference, relative L1",
                             difference(case, half, point, field, end),
                             tolerance)
        times = half.energies["Time"]
        times = times[times <= 0.01]
        for energy in "kinetic", "strain":
            name = f"total:{energy}"
            whole, part = (
                np.interp(times, c.energies["Time"], c.energies[name])
                for c in (case, half))
            f.atMost(f"{energy} energy until 10 ms: difference / initial total",
                     np.abs(whole - 2*part).max()/case.totalEnergy[0], 0.03)


@scenes(SELF, NON_MATCHING, HALF)
@pytest.mark.parametrize("scene", (SELF, NON_MATCHING, HALF),
                         ids=("self", "nonMatching", "half"))
def test_contact_keeps_momentum_and_takes_energy(run, figures, scene):
    case = run(scene)
    contact = case.contact("legs")
    touching, momentum = contact["area"] > 0, case.momentum
    with figures(f"Self-contact, {dict(scene.options)['SCENE']}") as f:
        f.within("first contact [ms]", 1e3*contact["Time"][touching][0],
                 2.5, 0.1)
        checkEnergies(f, case, "legs", balance=4e-3, own=1e-4,
                      penetration=0.05)
        if scene != HALF:
            # A leg: 4 mm x 40 mm at 0.8 m/s on average
            f.atMost("change of momentum / a leg's", max(
                np.abs(momentum[f"total:p{c}"]
                       - momentum[f"total:p{c}"][0]).max()
                for c in "xy")/0.128, 1e-12)
