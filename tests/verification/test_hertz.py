"""Impact of an elastic sphere on a rigid plane and on a second sphere, against
the theory of Hertz; 6 elements over the radius of the largest contact."""

import numpy as np
import pytest

import hertzSolution
from caseTools import Tutorial
from test_rings import rise

HERTZ = "hertzContact"
PLANE = Tutorial(HERTZ)
SPHERES = Tutorial(HERTZ, options=(("SCENE", "spheres"),))
EDGE = 0.28e-3

scenes = pytest.mark.scenes


def force(case):
    """On the whole sphere; the model is a quarter."""
    return 4*case.contact("contact")["sphere1.surface:Fz"]


def duration(case):
    contact = case.contact("contact")
    touching = contact["Time"][contact["area"] > 0]
    return touching[-1] - touching[0]


@scenes(PLANE, SPHERES)
@pytest.mark.parametrize("scene", (PLANE, SPHERES), ids=("plane", "spheres"))
def test_impact(run, figures, scene):
    case = run(scene)
    contact, total = case.contact("contact"), case.totalEnergy
    first = contact["Time"][contact["area"] > 0][0]
    p = case.momentum["sphere1:pz"]
    name = dict(scene.options).get("SCENE", "plane")
    with figures(f"Hertz, {name}") as f:
        f.within("first contact [ms]", 1e3*first,
                 1e3*hertzSolution.FIRST_CONTACT, 0.005)
        f.within("peak force / Hertz", force(case).max()/hertzSolution.FORCE,
                 1, 0.05)
        f.within("duration / Hertz", duration(case)/hertzSolution.DURATION,
                 1, 0.05)
        f.atLeast("speed away / towards", -p[-1]/p[0], 0.9)
        f.atMost("largest rise of the total energy / initial", rise(total),
                 1e-6)
        f.atMost("largest penetration / edge",
                 contact["penetration"].max()/EDGE, 0.05)
        f.atMost("residual of the energy balance / initial",
                 np.abs(case.energies["total:balance"]).max()/total[0], 2e-3)


@scenes(PLANE)
def test_traction(run, figures):
    """Near the largest force, along the radius."""
    case = run(PLANE)
    contact = case.contact("contact")
    F = np.interp(0.0025, contact["Time"], force(case))
    a = hertzSolution.contactRadius(F)
    X = case.points("sphere1")
    x = X + case.field("0.0025", "sphere1", "pointD")
    t = case.field("0.0025", "sphere1", "contactTraction")[:, 2]
    r = np.hypot(x[:, 0], x[:, 1])
    touching = t > 0
    inside = touching & (r < 0.9*a)
    peak = hertzSolution.pressure(0, F)
    with figures("Hertz, traction at 2.5 ms") as f:
        f.atLeast("nodes within 0.9 radii", inside.sum(), 15)
        f.atMost("mean difference from Hertz / his largest pressure",
                 np.abs(t - hertzSolution.pressure(r, F))[inside].mean()/peak,
                 0.08)
        f.within("radius of the contact / Hertz", r[touching].max()/a, 1, 0.2)


@scenes(PLANE, SPHERES)
def test_spheres_as_plane(run, figures):
    """Spheres whose surface meshes do not match do what each does on a rigid
    plane."""
    plane, spheres = run(PLANE), run(SPHERES)
    momentum = spheres.momentum
    with figures("Hertz, spheres and plane") as f:
        f.within("peak force, spheres / plane",
                 force(spheres).max()/force(plane).max(), 1, 0.01)
        f.within("duration, spheres / plane",
                 duration(spheres)/duration(plane), 1, 0.01)
        f.atMost("change of total momentum / a sphere's",
                 np.abs(momentum["total:pz"] - momentum["total:pz"][0]).max()
                 / np.abs(momentum["sphere1:pz"][0]), 1e-12)
