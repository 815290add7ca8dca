"""Rebound of an elastic torus from a rigid wall (Section 7.4), Mesh I."""

import numpy as np
import pytest

from caseTools import Tutorial
from test_rings import rise

TORUS = "torusImpact"
FULL = Tutorial(TORUS)
COARSE = Tutorial(TORUS, "3")
EDGE = 2.75e-3                  # of Mesh I

scenes = pytest.mark.scenes


@scenes(FULL, COARSE)
def test_default(run, figures):
    case = run(FULL)
    contact, total, momentum = case.contact("wall"), case.totalEnergy, \
        case.momentum
    time, touching = contact["Time"], contact["area"] > 0
    p0 = momentum["torus:px"][0]
    with figures("3.7 torus") as f:
        f.within("first contact [ms]", 1e3*time[touching][0], 3.4, 0.1)
        f.within("last contact [ms]", 1e3*time[touching][-1], 30, 3)
        f.atMost("largest rise of the total energy / initial", rise(total),
                 1e-6)
        f.atLeast("least strain energy / initial",
                  case.energies["torus:strain"].min()/total[0], -1e-9)
        end = total[-1]/total[0]
        f.atLeast("energy at 50 ms / initial", end, 0.7)
        coarse = run(COARSE).totalEnergy
        f.atLeast("the same less that of edges of 3.3 mm",
                  end - coarse[-1]/coarse[0], 0)
        f.atMost("largest penetration / edge",
                 contact["penetration"].max()/EDGE, 0.05)
        f.atMost("momentum - impulse of the wall / initial", np.abs(
            momentum["torus:px"][-1] - p0
            - contact["torus.outer:Ix"][-1])/p0, 1e-9)
        f.atLeast("speed away / towards", -momentum["torus:px"][-1]/p0, 0.3)
        f.atMost("momentum across / initial", max(
            np.abs(momentum[f"torus:p{c}"]).max() for c in "yz")/p0, 0.01)
        f.atMost("residual of the energy balance / initial",
                 np.abs(case.energies["total:balance"]).max()/total[0], 2e-3)
