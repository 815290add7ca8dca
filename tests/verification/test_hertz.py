"""Impact of an elastic sphere on a rigid plane and on a second sphere,
compared with the theory of Hertz. The mesh has 3 or 6 (Mesh I) elements over
the radius of the largest contact.

A finite sphere is stiffer than the half space of Hertz: finite() has the
changes of his peak force and duration, from the series of Legendre of
newtonsCradle. Numerical dissipation has an additional effect."""

from functools import cache

import numpy as np
import pytest

from vertexContactCases import hertzChain, hertzSolution
from vertexContactTests.caseTools import DEFAULT, Tutorial, checkEnergies

HERTZ = "hertzContact"
TWO = (("SCENE", "spheres"),)
COARSE_PLANE, PLANE = (
    Tutorial(HERTZ, mesh, preset=DEFAULT) for mesh in ("3", "I"))
COARSE_SPHERES, SPHERES = (
    Tutorial(HERTZ, mesh, options=TWO, preset=DEFAULT) for mesh in ("3", "I"))

scenes = pytest.mark.scenes


@cache
def finite():
    """Peak force and duration of a finite sphere / Hertz. Two spheres that fly
    at each other are, in the frame of one of them, an impact on a sphere at
    rest."""
    h, c = hertzSolution, hertzChain
    assert (h.RADIUS, h.RHO, h.E, h.NU) == (c.RADIUS, c.RHO, c.E, c.NU)
    times, _, F = c.chain(1.1*h.DURATION, 0, True, 2, 2*h.SPEED,
                          h.contactRadius(h.FORCE))
    return F.max()/h.FORCE, times[F[:, 0] > 0][-1]/h.DURATION


def force(case):
    """Force on the whole sphere; the model is a quarter."""
    return 4*case.contact("contact")["sphere1.surface:Fz"]


def duration(case):
    contact = case.contact("contact")
    touching = contact["Time"][contact["area"] > 0]
    return touching[-1] - touching[0]


def rebound(case):
    p = case.momentum["sphere1:pz"]
    return -p[-1]/p[0]


def checkImpact(f, scene, run, peak, time, back):
    """The limits are tolerances of peak force and duration, and the least
    ratio of the speeds after and before."""
    case = run(scene)
    contact = case.contact("contact")
    spheres = scene in (COARSE_SPHERES, SPHERES)
    # Corners of spheres touch at the centroids of their parts, behind the
    # poles. Surfaces are slowed from a cell's transit time and a step before
    # they touch
    f.within("first contact [ms]",
             1e3*contact["Time"][contact["area"] > 0][0],
             1e3*hertzSolution.FIRST_CONTACT, 0.03 if spheres else 0.012)
    f.within("peak force / finite sphere",
             force(case).max()/hertzSolution.FORCE/finite()[0], 1, peak)
    f.within("duration / finite sphere",
             duration(case)/hertzSolution.DURATION/finite()[1], 1, time)
    f.atLeast("speed away / towards", rebound(case), back)
    checkEnergies(f, case, "contact", balance=5e-4, total=5e-3, own=1e-4,
                  penetration=0.05)


def checkSpheres(f, plane, spheres):
    momentum = spheres.momentum
    f.within("peak force, spheres / plane",
             force(spheres).max()/force(plane).max(), 1, 0.02)
    f.within("duration, spheres / plane", duration(spheres)/duration(plane), 1,
             0.01)
    f.within("speed away, spheres / plane", rebound(spheres)/rebound(plane), 1,
             0.02)
    f.atMost("change of total momentum / a sphere's",
             np.abs(momentum["total:pz"] - momentum["total:pz"][0]).max()
             / np.abs(momentum["sphere1:pz"][0]), 1e-12)


@scenes(COARSE_PLANE, COARSE_SPHERES)
@pytest.mark.parametrize("scene", (COARSE_PLANE, COARSE_SPHERES),
                         ids=("plane", "spheres"))
def test_force_and_duration_of_hertz(run, figures, scene):
    with figures(f"Hertz, 3 elements, {dict(scene.options) or 'plane'}") as f:
        checkImpact(f, scene, run, 0.04, 0.03, 0.75)


@scenes(COARSE_PLANE, COARSE_SPHERES)
def test_spheres_as_plane(run, figures):
    """Spheres whose surface meshes do not match behave as each sphere does on
    a rigid plane."""
    with figures("Hertz, 3 elements, spheres and plane") as f:
        checkSpheres(f, run(COARSE_PLANE), run(COARSE_SPHERES))


@scenes(PLANE, SPHERES, COARSE_PLANE)
def test_force_and_duration_on_mesh_I(run, figures):
    with figures("Hertz, Mesh I") as f:
        for scene in PLANE, SPHERES:
            checkImpact(f, scene, run, 0.04, 0.03, 0.9)
        checkSpheres(f, run(PLANE), run(SPHERES))
        f.falling("1 - speed away / towards, plane, 3 and 6 elements",
                  [1 - rebound(run(scene)) for scene in (COARSE_PLANE, PLANE)])


@scenes(PLANE)
def test_traction_along_the_radius(run, figures):
    """Traction near the time of the largest force, along the radius."""
    case = run(PLANE)
    contact = case.contact("contact")
    F = np.interp(0.0025, contact["Time"], force(case))
    a = hertzSolution.contactRadius(F)
    X = case.points("sphere1")
    x = X + case.field("0.0025", "sphere1", "pointD")
    t = np.abs(case.field("0.0025", "sphere1", "contactTraction")[:, 2])
    r = np.hypot(x[:, 0], x[:, 1])
    touching = t > 0
    inside = touching & (r < 0.9*a)
    peak = hertzSolution.pressure(0, F)
    with figures("Hertz, traction at 2.5 ms") as f:
        f.atLeast("nodes within 0.9 radii", inside.sum(), 15)
        f.atMost("mean difference from Hertz / his largest pressure",
                 np.abs(t - hertzSolution.pressure(r, F))[inside].mean()/peak,
                 0.1)
        f.within("radius of the contact / Hertz", r[touching].max()/a, 1, 0.25)
