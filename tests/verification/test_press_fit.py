"""A hub is pressed onto a shaft by kinetic relaxation; comparison with Lame's
rings."""

import numpy as np
import pytest

from vertexContactCases import lame
from vertexContactTests.caseTools import DEFAULT, Tutorial

MESHES = {mesh: Tutorial("pressFit", mesh, preset=DEFAULT)
          for mesh in ("I", "II")}
HOOP = {"I": 0.045, "II": 0.025}    # largest errors, relative to the pressure
RADIAL = {"I": 0.22, "II": 0.12}


@pytest.mark.scenes(*MESHES.values())
@pytest.mark.parametrize("mesh", MESHES)
def test_lame(run, figures, mesh):
    case = run(MESHES[mesh])
    time = case.times[-1]
    errors = {}
    for name in "shaft", "hub":
        X, sigma = case.points(name), case.field(time, name, "sigma")
        r = np.hypot(X[:, 0], X[:, 1])
        c, s = X[:, 0]/r, X[:, 1]/r
        xx, xy, _, yy, _, _ = sigma.T
        at = np.minimum(r, lame.B*(1 - 1e-9)) if name == "shaft" \
            else np.maximum(r, lame.B)
        radial, hoop = lame.stresses(at)
        errors[name] = (
            np.abs(c**2*xx + 2*c*s*xy + s**2*yy - radial).max()/lame.PRESSURE,
            np.abs(s**2*xx - 2*c*s*xy + c**2*yy - hoop).max()/lame.PRESSURE)
    moved = (case.field(time, "hub", "pointD")*X).sum(axis=1)/r
    growth = moved[np.isclose(r, lame.B)]/lame.BORE_GROWTH
    E = case.energies
    with figures(f"press-fit, Mesh {mesh}") as f:
        f.atMost("growth of the bore / Lame, largest error",
                 np.abs(growth - 1).max(), 1e-3)
        # p times the interference over half of the edge of the quarter model
        f.within("strain energy / Lame", E["total:strain"][-1]
                 / (lame.PRESSURE*lame.INTERFERENCE*np.pi*lame.B/4),
                 1, 2e-3)
        for name, (radial, hoop) in errors.items():
            f.atMost(f"{name}: radial stress, error / pressure", radial,
                     RADIAL[mesh])
            f.atMost(f"{name}: hoop stress, error / pressure", hoop,
                     HOOP[mesh])
        f.atMost("end of the run [s]", E["Time"][-1], 60e-6)
        f.atMost("kinetic energy at the end / strain energy",
                 E["total:kinetic"][-1]/E["total:strain"][-1], 1e-20)
