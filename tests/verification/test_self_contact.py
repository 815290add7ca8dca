"""A hairpin of which the legs clap together, Mesh I, against its upper half on
a rigid plane."""

import numpy as np
import pytest

from caseTools import Tutorial, relativeL1
from test_rings import rise

HAIRPIN = "selfContact"
SELF, NON_MATCHING, HALF = (
    Tutorial(HAIRPIN, options=(("SCENE", scene),))
    for scene in ("self", "nonMatching", "half"))
ELEMENT = 1e-3

scenes = pytest.mark.scenes


def difference(case, half, point, field):
    """From the half, relative L1, y component at a point."""
    t, values = case.probe(point, field)
    t0, expected = half.probe(point, field)
    return relativeL1(t0, np.interp(t0, t, values[:, 1]), expected[:, 1])


@scenes(SELF, NON_MATCHING, HALF)
@pytest.mark.parametrize("scene, tolerance", (
    (SELF, 1e-6), (NON_MATCHING, 0.02)), ids=("self", "nonMatching"))
def test_half(run, figures, scene, tolerance):
    case, half = run(scene), run(HALF)
    with figures(f"Self-contact, {dict(scene.options)['SCENE']}, and half"
                 ) as f:
        for point in "pointA", "pointB":
            for field in "pointU", "pointD":
                f.atMost(f"{point}, {field}: difference, relative L1",
                         difference(case, half, point, field), tolerance)
        times = half.energies["Time"]
        for energy in "kinetic", "strain":
            whole = np.interp(times, case.energies["Time"],
                              case.energies[f"total:{energy}"])
            f.atMost(f"{energy} energy: difference / initial total",
                     np.abs(whole - 2*half.energies[f"total:{energy}"]).max()
                     / case.totalEnergy[0], tolerance)


@scenes(SELF, NON_MATCHING, HALF)
@pytest.mark.parametrize("scene", (SELF, NON_MATCHING, HALF),
                         ids=("self", "nonMatching", "half"))
def test_contact(run, figures, scene):
    case = run(scene)
    contact, total = case.contact("legs"), case.totalEnergy
    touching, momentum = contact["area"] > 0, case.momentum
    with figures(f"Self-contact, {dict(scene.options)['SCENE']}") as f:
        f.within("first contact [ms]", 1e3*contact["Time"][touching][0], 2,
                 0.1)
        f.atMost("largest rise of the total energy / initial", rise(total),
                 1e-6)
        f.atMost("largest penetration / element",
                 contact["penetration"].max()/ELEMENT, 0.05)
        f.atMost("residual of the energy balance / initial",
                 np.abs(case.energies["total:balance"]).max()/total[0], 2e-3)
        if scene != HALF:
            # A leg: 4 mm x 40 mm at 1 m/s on average
            f.atMost("change of momentum / a leg's", max(
                np.abs(momentum[f"total:p{c}"]
                       - momentum[f"total:p{c}"][0]).max()
                for c in "xy")/0.16, 1e-12)
