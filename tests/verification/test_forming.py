"""A rigid stamp presses a block of metal with a given force. The block bears
as much as Prandtl's half space."""

import numpy as np
import pytest

from vertexContactCases import prandtl
from vertexContactCases.readResults import probe
from vertexContactTests.caseTools import DEFAULT, Tutorial


def impulse(times, F, at):
    """Integral of a force from the start to given times."""
    sums = np.append(0, np.cumsum(np.diff(times)*(F[1:] + F[:-1])/2))
    return np.interp(at, times, sums)


MESHES = tuple(Tutorial("formingTool", mesh, preset=DEFAULT)
               for mesh in ("I", "12"))


@pytest.mark.scenes(*MESHES)
@pytest.mark.parametrize("scene", MESHES, ids=("I", "12"))
def test_limit(run, figures, scene):
    case = run(scene)
    contact = case.contact("imprint")
    t, F = contact["Time"], contact["stamp.surface:Fy"]
    flows = (t > 140e-6) & (t < 175e-6)
    times, way = probe(case.path, "stamp", "pointD")
    depth = -way[:, 1]
    E = case.energies
    with figures(f"stamp on a block, Mesh {scene.mesh}") as f:
        # The edge of the stamp is within cells
        f.within("force while the block flows / Prandtl's limit",
                 F[flows].mean()/prandtl.LIMIT, *{
                     "I": (1.11, 0.02), "12": (1.055, 0.02)}[scene.mesh])
        f.atLeast("force on the stamp / that limit",
                  prandtl.force(t).max()/prandtl.LIMIT, 1.3)
        # The block takes up the impulse of the force
        v = np.gradient(depth, times)
        f.atMost("momentum of the stamp less impulses / largest impulse",
                 np.abs(impulse(t, prandtl.force(t) - F, times)
                        - prandtl.MASS*v)[2:-2].max()
                 / impulse(t, F, times).max(), 0.005)
        f.atMost("plastic work / work of the force",
                 E["total:plasticDissipation"][-1]
                 / E["total:externalWork"].max(), 1)
        f.atMost("residual of the energy balance / work of the force",
                 np.abs(E["total:balance"]).max()
                 / E["total:externalWork"].max(), 1e-4)
