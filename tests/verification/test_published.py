"""Contact with friction against published solutions of others."""

import numpy as np
import pytest

import published
from caseTools import DEFAULT, Tutorial

IRONING = {mesh: Tutorial("shallowIroning", mesh, preset=DEFAULT)
           for mesh in ("I", "II")}


def outside(values, theirs, kind):
    """How far values are beyond the least and the largest of the sources, of
    the latter."""
    theirs = np.array([theirs[f"{source}:{kind}"]
                       for source in published.SOURCES])
    low, high = theirs.min(axis=0), theirs.max(axis=0)
    return np.maximum(np.maximum(low - values, values - high), 0)/high


@pytest.mark.scenes(*IRONING.values())
@pytest.mark.parametrize("mesh", IRONING)
def test_shallow_ironing(run, figures, mesh):
    """Both forces lie between those of five sources, all the way."""
    case = run(IRONING[mesh])
    forces = published.forces(case.path)
    theirs = published.sources()
    # Pressing in, forces change fast with the way
    H, V = np.array([
        published.at(forces, down, along, 0.1 if along else 0.02)
        for down, along in zip(theirs["down"], theirs["along"])]).T
    e = {name: case.energies[f"total:{name}"] for name in
         ("externalWork", "contactWork", "frictionDissipation", "kinetic",
          "numericalDissipation", "balance")}
    work = e["externalWork"][-1]
    with figures(f"shallow ironing, Mesh {mesh}") as f:
        f.equal("places of the sources", len(H), 25)
        f.atMost("force along, beyond the sources / largest",
                 outside(H, theirs, "H").max(), 0)
        f.atMost("force downwards, beyond the sources / largest",
                 outside(V, theirs, "V").max(), 0)
        # 0.30 to 0.53 in the literature
        middle = theirs["along"] == 5
        f.within("along / downwards at 5 mm", (H/V)[middle][0], 0.31, 0.05)
        f.within("friction / work of the top",
                 e["frictionDissipation"][-1]/work, 0.9, 0.03)
        f.atMost("energy that contact gives / work of the top",
                 (e["contactWork"] + e["frictionDissipation"])[-1]/work, 0.03)
        f.atMost("kinetic energy / work of the top",
                 e["kinetic"].max()/work, 0.01)
        f.atMost("numerical dissipation / work of the top",
                 e["numericalDissipation"][-1]/work, 0.003)
        f.atMost("residual of the energy balance / work of the top",
                 np.abs(e["balance"]).max()/work, 1e-5)
