"""Newton's cradle against a chain of point masses and contacts of finite
spheres."""

import numpy as np
import pytest

from vertexContactCases import hertzChain
from vertexContactTests.caseTools import DEFAULT, Tutorial, rise

CRADLE = {mesh: Tutorial("newtonsCradle", mesh, preset=DEFAULT)
          for mesh in ("2", "I")}


def checkCradle(case, figures, title, late, atEnd, peak, release):
    """Limits: for velocities at any time and at the end, for peak forces, and
    for the time of the last release."""
    times, v = hertzChain.velocities(case.path)
    forces = hertzChain.contactForces(case.path)
    t, chain, F = hertzChain.chain(times[-1], finite=True)
    theirs = np.array([np.interp(times, t, u) for u in chain.T]).T
    E, p = case.totalEnergy, case.momentum["total:px"]
    with figures(f"Newton's cradle, {title}") as f:
        f.equal("contacts", list(forces), [1, 2, 3, 4])
        f.atMost("velocities at the end, largest difference / first",
                 np.abs(v - theirs)[-1].max(), atEnd)
        f.atMost("the same at any time", np.abs(v - theirs).max(), late)
        for i, (_, ours) in forces.items():
            f.within(f"peak force {i}, {i + 1} / chain",
                     ours.max()/F[:, i - 1].max(), 1, peak)
        f.within("last release / chain",
                 forces[4][0][-1]/t[F[:, 3] > 0][-1], 1, release)
        # With Hertz's half spaces it keeps more of the velocity
        f.atMost("velocity of the fourth / chain of Hertz",
                 v[-1, 3]/hertzChain.chain(times[-1])[1][-1, 3], 0.85)
        f.atMost("energy lost / initial", 1 - E[-1]/E[0], 0.01)
        f.atMost("largest energy / initial - 1", E.max()/E[0] - 1, 1e-6)
        f.atMost("largest rise of the energy less works / initial",
                 rise(case.ownEnergy), 1e-5)
        f.atMost("change of the momentum / initial",
                 np.abs(p - p[0]).max()/p[0], 1e-12)


@pytest.mark.scenes(CRADLE["2"])
def test_velocities_of_a_chain_of_spheres(run, figures):
    checkCradle(run(CRADLE["2"]), figures, "2 elements",
                0.07, 0.008, 0.015, 0.025)


@pytest.mark.scenes(*CRADLE.values())
def test_velocities_on_a_finer_mesh(run, figures):
    case = run(CRADLE["I"])
    checkCradle(case, figures, "Mesh I", 0.045, 0.003, 0.006, 0.018)
