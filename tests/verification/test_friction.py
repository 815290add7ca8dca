"""Coulomb friction: sticking points do not move, slip begins at the right
force, and friction slows and dissipates correctly."""

import shutil

import numpy as np
import pytest

from vertexContactTests.caseTools import DEFAULT, checked
from vertexContactTests.smallCases import (ELASTIC, FLOOR, RUBBER, Body,
                                           SmallCase, condition, coulomb,
                                           interface, largest, slowly)

CLAMP = condition("fixedVelocity", velocity=(0, 0, 0))
HEIGHT, WEIGHT = 0.5, 0.02


def settled(X):
    """sigma_yy = -rho g (h - y)."""
    y = X[:, 1:2]
    return -WEIGHT*(HEIGHT*y - y**2/2)*(0, 1, 0)


def block(forces, speed=0):
    return Body(cells=(8, 3), name="block", size=(2, HEIGHT, 1),
                material=ELASTIC, velocity=(speed, 0, 0), forces=forces,
                displacement=settled if speed else None,
                sides={"bottom": "contact"})


def base():
    return Body(cells=(24, 3), name="base", start=(-2, -HEIGHT, 0),
                size=(6, HEIGHT, 1), material=ELASTIC,
                sides={"bottom": CLAMP, "top": "contact"})


def law(k, static=None, decay=None):
    given = {"staticFrictionCoeff": static, "frictionDecay": decay}
    return {**coulomb(k), **{name: v for name, v in given.items() if v}}


def sliding(folder, on, friction, time, tilt=0, speed=0, **how):
    """A block with an initial speed; or a block whose weight rises in the
    first third of the time, and the slope in the second third. It lies on a
    plane or on a deformable base."""
    weight = np.array((0, -WEIGHT, 0))
    slope = weight + (tilt*WEIGHT, 0, 0)
    forces = (slowly(time, slope, slope) if speed
              else slowly(time/3, 0*weight, weight, slope))
    touch = {"law": friction, "side": ("block", "bottom"), "obstacle": FLOOR}
    if on == "base":
        touch = interface(("block", "bottom"), ("base", "top"), friction,
                          pairing="nearestFace")
    return SmallCase(
        folder, [block(forces, speed), *([base()] if on == "base" else [])],
        endTime=time, interfaces={"contact": touch},
        functions=("contactForces",), preset=DEFAULT, **how).run()


def velocity(case):
    return case.momentumOf("block")[:, 0]/(2*HEIGHT)


@pytest.mark.parametrize("on, excess", (
    ("plane", -1e-3), ("plane", 1e-3), ("base", -0.1), ("base", 0.1)))
def test_angle_of_friction(tmp_path, figures, on, excess):
    """On a slope of tan(alpha) = 0.999 k a block comes to rest. At 1.001 k it
    accelerates by the difference. A soft base gives way more below the lower
    edge of the block, which tilts: there the slope is known less exactly."""
    k, T = 0.3, 1200
    case = sliding(tmp_path, on, coulomb(k), T, (1 + excess)*k,
                   control={"writeInterval": T/2})
    t, v = case.momentum["Time"], velocity(case)
    late = t > 3*T/4
    with figures(f"slope of {1 + excess} k, on a {on}") as f:
        if excess < 0:
            f.atMost("largest velocity in the last quarter / (k g T)",
                     largest(v[late])/(k*WEIGHT*T), 1e-6)
            if on == "plane":
                f.equal("slip at the end",
                        case.contact("contact")["slip"][-1], 0)
        elif on == "base":
            f.atLeast("acceleration, then it falls / ((tan(alpha) - k) g)",
                      np.polyfit(t[late], v[late], 1)[0]
                      / (excess*k*WEIGHT), 0.85)
        else:
            f.within("acceleration / ((tan(alpha) - k) g)",
                     np.polyfit(t[late], v[late], 1)[0]
                     / (excess*k*WEIGHT), 1, 0.15)


def test_rest_on_a_slope(tmp_path, figures):
    """A block of 2 x 2 x 2 cells stays at rest on a body with the same cells.
    The slope is a fifth of the angle of friction, and the pressure 5 % of its
    modulus."""
    T = 6000
    rubber = dict(material=RUBBER, forces=slowly(
        T/20, np.zeros(3), np.array((0, -0.05, 0)),
        np.array((0.0045, -0.05, 0.0022))))
    bodies = [Body((2, 2, 2), name="block", sides={"bottom": "contact"},
                   **rubber),
              Body((4, 2, 4), name="base", start=(-0.5, -1, -0.5),
                   size=(2, 1, 2), sides={"bottom": CLAMP, "top": "contact"},
                   **rubber)]
    case = SmallCase(
        tmp_path, bodies, endTime=T, preset=DEFAULT,
        control={"writeInterval": T/5}, interfaces={"contact": interface(
            ("block", "bottom"), ("base", "top"), coulomb(0.5),
            pairing="nearestFace")}).run()
    D = [case.at("pointD", time, "block") for time in case.times]
    kinetic = case.energies["total:kinetic"]
    with figures("3D block on a body, at a fifth of the angle of friction") as f:
        # Each pairing, here at each written time, finds new areas and normals
        f.atMost("drift in the last fifth / cell",
                 2*largest(D[-1] - D[-2]), 1e-9)
        f.atMost("kinetic energy at the end / largest",
                 kinetic[-1]/kinetic.max(), 1e-18)


@pytest.mark.parametrize("first", ("base", "blocks"))
def test_two_on_one_node(tmp_path, figures, first):
    """Two small blocks stand on the same node of a coarse base and are pulled
    apart by two fifths of the friction limit. Both stay, whichever side of the
    interface they are on."""
    T, damped = 120, {"coefficient": 0.5}

    def pulled(name, x, way):
        rest, weight = np.zeros(3), np.array((0, -WEIGHT, 0))
        return Body(
            (3, 3), name=name, start=(x, 0, 0), size=(0.3, 0.3, 1),
            material=ELASTIC, sides={"bottom": "contact"}, forces=slowly(
                T/6, rest, weight, weight + (0.2*way*WEIGHT, 0, 0)))
    blocks = [pulled("left", -0.4, -1), pulled("right", 0.1, 1)]
    below = Body((2, 1), name="base", start=(-1.5, -1, 0), size=(3, 1, 1),
                 material=ELASTIC, sides={"bottom": CLAMP, "top": "contact"})
    case = SmallCase(
        tmp_path, [below, *blocks] if first == "base" else [*blocks, below],
        endTime=T, preset=DEFAULT,
        interfaces={"all": {"surfaces": "all", "self": "no",
                            "law": coulomb(0.5)}},
        control={"maxCo": 0.9, "writeInterval": T/6,
                 "functions": {}, "damping": {'".*"': damped}}).run()
    half, end = (case.at("pointD", time, "left")
                 for time in (case.times[2], case.times[-1]))
    with figures(f"two blocks on one node, {first} first") as f:
        f.atMost("way in the second half / cell", 10*largest(end - half), 1e-4)


def test_static_and_dynamic(tmp_path, figures):
    """With a slope between both coefficients, a block at rest stays, and a
    moving block goes on and is slowed by the dynamic friction."""
    tilt, both = 0.15, law(0.1, 0.3)
    rests = sliding(tmp_path/"rests", "plane", both, 600, tilt)
    moves = sliding(tmp_path/"moves", "plane", both, 10, tilt, 0.02)
    t, v = moves.momentum["Time"], velocity(moves)
    with figures("slope of 0.15, k = 0.1, k_s = 0.3") as f:
        f.atMost("at rest: velocity at the end / (g T)",
                 abs(velocity(rests)[-1])/(WEIGHT*600), 1e-9)
        f.within("moving: acceleration / ((tan(alpha) - k) g)",
                 np.polyfit(t, v, 1)[0]/((tilt - 0.1)*WEIGHT), 1, 0.02)


def test_friction_falls_with_the_speed(tmp_path, figures):
    """If friction decays with the speed, a block stops as the equation v' = -g
    (k + (k_s - k) exp(-decay v)) predicts."""
    k, static, decay, speed, T = 0.1, 0.4, 20, 0.1, 20
    case = sliding(tmp_path, "plane", law(k, static, decay), T, speed=speed)
    t, v = case.momentum["Time"], velocity(case)
    fine = np.linspace(0, T, 40001)
    exact = [speed]
    for dt in np.diff(fine):
        u = max(exact[-1], 0)
        exact.append(u - dt*WEIGHT*(k + (static - k)*np.exp(-decay*u)))
    exact = np.interp(t, fine, np.maximum(exact, 0))
    with figures("block stopped by friction that decays with speed") as f:
        f.atMost("error of the velocity / initial",
                 largest(v - exact)/speed, 0.02)
        f.atLeast("what constant friction k would leave / initial",
                  largest(np.maximum(speed - k*WEIGHT*t, 0) - exact)/speed,
                  0.2)


@pytest.mark.parametrize("on", ("plane", "base"))
def test_what_friction_takes(tmp_path, figures, on):
    """A block slides until it stops. Friction has dissipated its kinetic
    energy, except for the part that its waves lost."""
    speed = 0.06
    case = sliding(tmp_path, on, coulomb(0.3), 20, speed=speed)
    start = HEIGHT*speed**2
    e, contact = case.energies, case.contact("contact")
    friction = e["total:frictionDissipation"]
    normal = -e["total:contactWork"] - friction
    p = velocity(case)
    way = np.trapezoid(p, case.momentum["Time"])
    with figures(f"block slides on a {on} until it stops") as f:
        if on == "plane":
            f.within("friction / (k x weight x way)",
                     friction[-1]/(0.3*WEIGHT*2*HEIGHT*way), 1, 0.01)
        f.within("friction / kinetic energy at the start",
                 friction[-1]/start, 1, 0.01 if on == "plane" else 0.06)
        f.atMost("work of the pressure / kinetic energy at the start",
                 largest(normal)/start, 0.02)
        f.atLeast("least growth in a step / kinetic energy at the start",
                  np.diff(friction).min()/start, -1e-6)
        f.atMost("contactForces against energies.dat",
                 abs(contact["frictionDissipation"][-1] - friction[-1])/start,
                 1e-9)


def pressed(folder, ranks=1, T=8, **control):
    """A block is pushed along a base with less than the friction limit, under
    an uneven load."""
    rubber = dict(material=RUBBER)
    block = Body((2, 2, 2), name="block", sides={
        "bottom": "contact",
        "top": condition("traction", traction=(0.006, -0.05, 0.003))}, **rubber)
    base = Body((5, 2, 5), name="base", start=(-0.4, -1, -0.4),
                size=(2, 1, 2), sides={"bottom": CLAMP, "top": "contact"},
                **rubber)
    case = SmallCase(
        folder, [block, base], endTime=T, control=control, preset=DEFAULT,
        functions=("contactForces",), interfaces={"contact": interface(
            ("block", "bottom"), ("base", "top"), coulomb(0.4),
            pairing="nearestFace")})
    return case.run() if ranks == 1 else case.runParallel(ranks)


def test_restart(tmp_path):
    """Sticking points remember their positions: a restarted run is equal to
    the last bit."""
    whole = pressed(tmp_path/"whole", writeInterval=4)
    half = tmp_path/"half"
    shutil.copytree(whole.path, half)
    shutil.rmtree(half/"8")
    shutil.rmtree(half/"postProcessing")
    checked(["vertexContactFoam"], half)
    for field in "pointD", "contactSlide":
        a, b = ((p/"8/block"/field).read_bytes() for p in (whole.path, half))
        assert a == b
    slide = whole.at("contactSlide", region="block")
    assert largest(slide) > 1e-6
    a, b = ((p/"8/uniform/solidSystem").read_text()
            for p in (whole.path, half))
    assert a == b and "friction" in a


def test_two_ranks(tmp_path, figures):
    """Decomposed runs remember them in the same way."""
    serial, parallel = (pressed(tmp_path/str(n), n) for n in (1, 2))
    a, b = (c.energies["total:frictionDissipation"] for c in
            (serial, parallel))
    e, p = (c.totalEnergy for c in (serial, parallel))
    with figures("block pushed along a base, two ranks") as f:
        f.atMost("difference of energies / largest",
                 largest(e - p)/largest(e), 1e-9)
        f.atMost("difference of friction / largest",
                 largest(a - b)/largest(a), 1e-7)


def test_frictionless_remembers_nothing(tmp_path):
    """Without friction nothing is stored."""
    case = sliding(tmp_path, "base", coulomb(0), 1)
    assert not (case.path/"1/block/contactSlide").exists()


@pytest.mark.parametrize("entry, words", (
    ({"staticFrictionCoeff": 0.1}, ("staticFrictionCoeff", "0.1",
                                    "at least frictionCoeff")),
    ({"frictionDecay": 0}, ("frictionDecay", "more than 0")),
    ({"staticFriction": 0.4}, ("staticFriction", "staticFrictionCoeff"))))
def test_refused(tmp_path, entry, words):
    case = SmallCase(
        tmp_path, block({}), endTime=1, preset=DEFAULT, interfaces={"contact": {
            "law": {**coulomb(0.3), **entry}, "side": ("block", "bottom"),
            "obstacle": FLOOR}})
    code, log = case.attempt()
    assert code and "FOAM FATAL IO ERROR" in log
    for word in words:
        assert word in log
