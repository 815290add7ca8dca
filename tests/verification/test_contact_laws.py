"""Contact of matching surfaces: laws, conservation, opening and closing."""

from dataclasses import replace
from math import erf

import numpy as np
import pytest

from vertexContactTests.smallCases import (ELASTIC, RUBBER, Body, SmallCase,
                                           condition, coulomb, distorted,
                                           interface, largest)

CLAMP = condition("fixedVelocity", velocity=(0, 0, 0))


def impulse(contact, side):
    return np.array([contact[f"{side}:I{c}"] for c in "xyz"]).T


# Tied

V, CENTRE, WIDTH = 0.01, 0.5, 0.1


def pulse(sign):
    """A velocity pulse D = f(x - c t) that moves to the right, with sigma =
    -rho c v. It is compressive for the sign +."""
    def velocity(X):
        return sign*V*np.exp(-((X[:, :1] - CENTRE)/WIDTH)**2)*(1, 0, 0)

    def displacement(X):
        behind = np.array([[1 - erf((x - CENTRE)/WIDTH)] for x in X[:, 0]])
        return sign*V*np.sqrt(np.pi)*WIDTH/2*behind*(1, 0, 0)
    return {"velocity": velocity, "displacement": displacement}


def twoBars(n, dimensions=1, right=ELASTIC, **more):
    """Two bars, from x = 0 to 1 and from 1 to 2."""
    cells = (n, n, n)[:dimensions]
    return (Body(cells=cells, name="left", material=ELASTIC,
                 sides={"right": "contact"}, **more),
            Body(cells=cells, name="right", start=(1, 0, 0), material=right,
                 sides={"left": "contact"}, **more))


def tied():
    return {"tie": interface(("left", "right"), ("right", "left"), "tied")}


@pytest.mark.parametrize("sign", (1, -1), ids=("compression", "tension"))
def test_tied_bars(tmp_path, figures, sign):
    """A pulse crosses the tie between two bars of one material as if they were
    one bar, in compression and in tension. Nothing is reflected."""
    n = 100
    whole = Body(cells=(2*n,), name="whole", size=(2, 1, 1),
                 material=ELASTIC, **pulse(sign))
    case = SmallCase(tmp_path, [*twoBars(n, **pulse(sign)), whole], endTime=1,
                     interfaces=tied()).run()
    left, right = (case.at("pointU", region=r) for r in ("left", "right"))
    x, one = case.X("whole")[:, 0], case.at("pointU", region="whole")

    def at(points, values):
        """Values at the points on one corner line of the bar, sorted by x."""
        order = np.argsort(points, kind="stable")
        return points[order][::4], values[order][::4]
    xl, vl = at(case.X("left")[:, 0], left[:, 0])
    xr, vr = at(case.X("right")[:, 0], right[:, 0])
    xw, vw = at(x, one[:, 0])
    both = np.concatenate((vl, vr))
    single = np.interp(np.concatenate((xl, xr)), xw, vw)
    with figures("tied bars, " + ("compression" if sign > 0 else "tension")
                 ) as f:
        f.atMost("v, largest difference to one bar / V",
                 largest(both - single)/V, 0.01)
        f.atMost("v reflected / V", largest(vl)/V, 0.01)
        f.within("v passed / that in one bar",
                 largest(vr)/largest(vw), 1, 0.01)
        p = case.momentumOf("left") + case.momentumOf("right")
        f.atMost("change of momentum / initial",
                 largest(p - p[0])/largest(p[0]), 1e-12)
        e = case.energies
        f.atMost("balance residual / initial energy",
                 largest(e["total:balance"])/case.totalEnergy[0], 1e-3)


def test_tied_dissimilar(tmp_path, figures):
    """A pulse at the tie to a bar of impedance z2 = 4 z1: v transmitted is 2
    z1/(z1 + z2) = 0.4 of the incident v, v reflected is (z1 - z2)/(z1 + z2) =
    -0.6 of it."""
    stiff = {**ELASTIC, "E": 16}
    left, right = twoBars(200, right=stiff, **pulse(1))
    case = SmallCase(tmp_path, (left, right), endTime=1, interfaces=tied(),
                     probes={"passed": ("right", (1.3, 0, 0)),
                             "back": ("left", (0.5, 0, 0))}).run()
    # Until the transmitted pulse returns from the other end
    t, passed = case.probe("passed", "pointU")
    passed = passed[t < 0.75]
    t, back = case.probe("back", "pointU")
    with figures("tied bars, impedances 1:4") as f:
        f.within("v passed / V", passed[:, 0].max()/V, 0.4, 0.01)
        f.within("v reflected / V", back[t > 0.5, 0].min()/V, -0.6, 0.015)


def test_tied_blocks(tmp_path, figures):
    """Two tied 2D blocks behave as one block of double length, up to the error
    of the mesh, which falls with the cell size."""
    def velocity(X):
        x, y = np.pi*X[:, 0]/2, np.pi*X[:, 1]
        return 0.1*np.stack((np.cos(x)*(1 + 0.3*np.cos(y)),
                             np.sin(x)*np.cos(y), 0*x), axis=1)

    differences = []
    for n in 8, 16, 32:
        parts = [replace(b, material=RUBBER, velocity=velocity)
                 for b in twoBars(n, dimensions=2)]
        whole = Body(cells=(2*n, n), name="whole", size=(2, 1, 1),
                     velocity=velocity)
        case = SmallCase(tmp_path/str(n), (*parts, whole), endTime=1,
                         interfaces=tied()).run()
        row = {tuple(x): i for i, x in enumerate(np.round(case.X("whole"), 9))}
        v = case.at("pointU", region="whole")
        errors, scale = 0, 0
        for side in "left", "right":
            rows = [row[tuple(x)] for x in np.round(case.X(side), 9)]
            d = case.at("pointU", region=side) - v[rows]
            errors += np.sum(d**2)
            scale += np.sum(v[rows]**2)
        differences.append(np.sqrt(errors/scale))
    with figures("tied blocks, 2D, meshes 8 16 32") as f:
        f.falling("v, relative L2 difference to one block", differences)
        f.atMost("v, relative L2 difference on the finest",
                 differences[-1], 0.02)


# A block on a base; its weight is in equilibrium from the start

HEIGHT, LENGTH, WEIGHT = 0.5, 2, 0.02


def stack(velocity=(0, 0, 0), settled=True, scheme=None):
    def settle(X):
        # sigma_yy = -rho g (2 h - y), from the clamped bottom to the top
        y = X[:, 1:2]
        return -WEIGHT*(2*HEIGHT*y - y**2/2)*(0, 1, 0)

    size = (LENGTH, HEIGHT, 1)
    base = Body(cells=(16, 4), name="base", size=size, material=ELASTIC,
                displacement=settle if settled else None,
                sides={"bottom": CLAMP, "top": "contact"},
                scheme=scheme or {})
    slider = replace(base, name="block", start=(0, HEIGHT, 0),
                     velocity=velocity, sides={"bottom": "contact"})
    return slider, base


def between(law):
    return {"contact": interface(("block", "bottom"), ("base", "top"), law)}


def slidWay(case):
    """Mean slip at the end between the nodes of both surfaces."""
    def meanShift(region):
        on = np.abs(case.X(region)[:, 1] - HEIGHT) < 1e-9
        return case.at("pointD", region=region)[on, 0].mean()
    return meanShift("block") - meanShift("base")


def test_sliding_stops_as_friction_says(tmp_path, figures):
    """A block slides on a base with friction k. Its momentum falls by k times
    its weight per time, until it stops at t = v/(k g). The energy that contact
    dissipates is the friction force times the slip (pressure and slip are not
    uniform, which accounts for 5 % of it). The energy minus the work of the
    weight never grows."""
    k, speed = 0.3, 0.06
    case = SmallCase(
        tmp_path, stack((speed, 0, 0)), endTime=14, gravity=(0, -WEIGHT, 0),
        interfaces=between(coulomb(k)), functions=("contactForces",)).run()
    t = case.momentum["Time"]
    mass = HEIGHT*LENGTH
    p = case.momentumOf("block")[:, 0]
    contact = case.contact("contact")
    sliding = t < 8
    slope = np.polyfit(t[sliding], p[sliding], 1)[0]
    way = np.trapezoid(p/mass, t)
    taken = -(case.energies["block:contactWork"]
              + case.energies["base:contactWork"])
    total = case.totalEnergy - case.energies["total:externalWork"]
    start = 0.5*mass*speed**2
    stopped = t > 12
    slip = slidWay(case)
    with figures("block slides on a base, k = 0.3") as f:
        f.within("deceleration / (k g)", -slope/mass/(k*WEIGHT), 1, 0.02)
        f.within("way / (v^2/(2 k g))", way/(speed**2/(2*k*WEIGHT)), 1, 0.03)
        f.atMost("velocity after the stop / initial",
                 largest(p[stopped])/(mass*speed), 0.05)
        f.within("work taken by contact / (friction x slip)",
                 taken[-1]/(k*WEIGHT*mass*slip), 1, 0.06)
        f.atMost("largest gain of energy in a step / initial",
                 np.diff(total).max()/start, 1e-6)
        f.equal("open, stick, slip at t = 5", tuple(
            int(contact[s][np.searchsorted(contact["Time"], 5)])
            for s in ("open", "stick", "slip")), (0, 0, 32))
        f.atLeast("stick at the end, of 32", contact["stick"][-1], 16)
        f.atMost("balance residual / initial kinetic energy",
                 largest(case.energies["total:balance"])/start, 5e-3)


@pytest.mark.parametrize("tilt", (0.1, 0.5))
def test_slope_of_the_angle_of_friction(tmp_path, figures, tilt):
    """Gravity with a component of tilt x g along the base: below k the block
    stays where it is, above k it slides with the acceleration (tilt - k) g."""
    k, T = 0.3, 12
    case = SmallCase(
        tmp_path, stack(), endTime=T, gravity=(tilt*WEIGHT, -WEIGHT, 0),
        interfaces=between(coulomb(k)), functions=("contactForces",)).run()
    p = case.momentumOf("block")[:, 0]
    t = case.momentum["Time"]
    contact = case.contact("contact")
    slid = slidWay(case)
    with figures(f"block on a slope of {tilt:g}, k = {k:g}") as f:
        if tilt < k:
            f.atMost("way / that without friction",
                     abs(slid)/(tilt*WEIGHT*T**2/2), 1e-3)
            f.equal("slip at the end", contact["slip"][-1], 0)
        else:
            slope = np.polyfit(t[t > 2], p[t > 2], 1)[0]
            f.within("acceleration / ((tilt - k) g)",
                     slope/(HEIGHT*LENGTH)/((tilt - k)*WEIGHT), 1, 0.03)


def test_stick_slip_wave(tmp_path, figures):
    """A plane shear wave meets the interface of two equal layers under the
    pressure p. In the exact solution it passes unchanged while its traction
    rho c_s v is below k p. Above, the surfaces slip and transmit k p; they
    stick again as the traction falls. So the transmitted wave is the incident
    one cut off at k p/(rho c_s). The layers are so wide that their free ends
    have no effect in the middle."""
    k, V, width, centre, pressure = 0.3, 0.01, 0.08, -0.4, 0.01
    cs = np.sqrt(0.5)
    cut = k*pressure/cs                 # 0.42 V

    def wave(X):
        return np.exp(-((X[:, 1:2] - centre)/width)**2)

    def displacement(X):
        # The pressure, and a wave that moves up: D = f(y - c_s t)
        behind = np.array([[1 - erf((y - centre)/width)] for y in X[:, 1]])
        return (-pressure*X*(0, 1, 0)
                + V/cs*np.sqrt(np.pi)*width/2*behind*(1, 0, 0))

    load = condition("traction", traction=(0, -pressure, 0))
    rise = condition("traction", traction=(0, pressure, 0))
    layers = [Body(cells=(24, 80), name=name, start=(-1.8, y, 0),
                   size=(3.6, 0.8, 1), material=ELASTIC,
                   displacement=displacement,
                   velocity=lambda X: V*wave(X)*(1, 0, 0), sides=sides)
              for name, y, sides in (
                  ("lower", -0.8, {"bottom": rise, "top": "contact"}),
                  ("upper", 0.0, {"bottom": "contact", "top": load}))]
    case = SmallCase(
        tmp_path, layers, endTime=1.15, functions=("contactForces",),
        interfaces={"contact": interface(
            ("lower", "top"), ("upper", "bottom"), coulomb(k))},
        probes={"above": ("upper", (0, 0.2, 0)),
                "below": ("lower", (0, -0.2, 0))}).run()
    t, v = case.probe("above", "pointU")
    incident = V*np.exp(-((0.2 - cs*t - centre)/width)**2)
    passed = np.minimum(incident, cut)
    tb, vb = case.probe("below", "pointU")
    arriving = V*np.exp(-((-0.2 - cs*tb - centre)/width)**2)
    back = V*np.exp(-((0.2 - cs*tb - centre)/width)**2)
    back -= np.minimum(back, cut)
    contact = case.contact("contact")
    # In the middle third, of 24 faces
    slips = contact["slip"] > 8
    start = contact["Time"][slips]
    with figures("shear wave at an interface with friction") as f:
        f.atMost("v above, relative L1 error",
                 np.trapezoid(abs(v[:, 0] - passed), t)
                 / np.trapezoid(passed, t), 0.05)
        f.atMost("v below, relative L1 error",
                 np.trapezoid(abs(vb[:, 0] - arriving - back), tb)
                 / np.trapezoid(arriving + back, tb), 0.05)
        f.within("largest v above / (k p/(rho c_s))",
                 v[:, 0].max()/cut, 1, 0.06)
        # exp(-s^2) = cut/V
        half = width*np.sqrt(-np.log(cut/V))/cs
        f.within("slip begins [s]", start[0], -centre/cs - half, 0.03)
        f.within("slip ends [s]", start[-1], -centre/cs + half, 0.05)
        f.atMost("work of contact / energy of the wave",
                 case.energies["total:contactWork"][-1], 0)


def test_rest_under_gravity(tmp_path, figures):
    """Gravity acts suddenly: the block vibrates but does not sink in, and the
    mean force is its weight."""
    case = SmallCase(
        tmp_path, stack(settled=False), endTime=24,
        gravity=(0, -WEIGHT, 0), interfaces=between("frictionless"),
        functions=("contactForces",)).run()
    contact = case.contact("contact")
    t = contact["Time"]
    total = impulse(contact, "block.bottom")[:, 1]
    half = np.searchsorted(t, 12)
    mean = (total[-1] - total[half])/(t[-1] - t[half])
    with figures("block rests on a base") as f:
        f.atMost("largest penetration / cell",
                 contact["penetration"].max()/(HEIGHT/4), 0.05)
        f.within("mean force / weight", mean/(WEIGHT*HEIGHT*LENGTH), 1, 0.02)
        f.atMost("tangential momentum / (weight x time)",
                 largest(case.momentumOf("block")[:, 0])/(24*WEIGHT), 1e-12)


# Oblique impact of two free blocks

def blocks(dimensions, n=5, gap=0.0, amplitude=0.3,
           speeds=((0.2, 0.06, -0.03), (-0.1, 0, 0))):
    inside = np.arange(3) < dimensions
    out = []
    for name, x, side, v in (("left", 0, "right", speeds[0]),
                             ("right", 1 + gap, "left", speeds[1])):
        start = (x, 0, 0)
        out.append(Body(
            cells=dimensions*(n,), name=name, start=start,
            moved=distorted(amplitude, dimensions=dimensions, start=start),
            velocity=np.array(v)*inside, sides={side: "contact"},
            material={**RUBBER, "E": 4 if name == "right" else 1}))
    return out


def collision(law):
    return {"contact": interface(("left", "right"), ("right", "left"), law)}


LAWS = {"frictionless": "frictionless", "friction": coulomb(0.3),
        "sticking": coulomb(1e6)}


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS.keys())
@pytest.mark.parametrize("dimensions", (1, 2, 3))
def test_impulses_are_opposite(tmp_path, figures, dimensions, law):
    """Oblique impact of two free blocks with an initial gap: total linear
    momentum is conserved. The impulses of contact are opposite, and each
    equals the change of momentum of its body. Contact does not increase the
    energy."""
    case = SmallCase(
        tmp_path, blocks(dimensions, gap=0.01), endTime=6,
        interfaces=collision(law), functions=("contactForces",)).run()
    p = case.momentumOf()
    scale = largest(p[0])
    contact = case.contact("contact")
    onLeft = impulse(contact, "left.right")
    onRight = impulse(contact, "right.left")
    gained = [case.momentumOf(body)[-1] - case.momentumOf(body)[0]
              for body in ("left", "right")]
    taken = np.diff(case.energies["total:contactWork"])
    name = next(key for key, value in LAWS.items() if value == law)
    start = case.totalEnergy[0]
    with figures(f"oblique impact, {dimensions}D, {name}") as f:
        f.atLeast("impulse / initial momentum", largest(onLeft[-1])/scale, 0.1)
        f.atMost("change of total momentum / initial",
                 largest(p - p[0])/scale, 1e-12)
        f.atMost("impulses of both sides: sum / initial momentum",
                 largest(onLeft + onRight)/scale, 1e-12)
        f.atMost("impulse - change of momentum / initial",
                 max(largest(gained[0] - onLeft[-1]),
                     largest(gained[1] - onRight[-1]))/scale, 1e-12)
        f.equal("open at the end", contact["area"][-1], 0.0)
        f.atMost("largest gain by contact in a step / initial energy",
                 taken.max()/start, 1e-4)
        f.atMost("energy at the end / initial",
                 case.totalEnergy[-1]/start, 1)
        f.atMost("balance residual / initial energy",
                 largest(case.energies["total:balance"])/start, 5e-3)
        f.atMost("largest penetration / cell",
                 contact["penetration"].max()*5, 0.13)


def test_zero_friction_is_frictionless(tmp_path, figures):
    """Coulomb's law with k = 0 gives the same fields as frictionless, to the
    round-off of the summed dissipation."""
    cases = [SmallCase(tmp_path/name, blocks(2), endTime=2,
                       interfaces=collision(law)).run()
             for name, law in (("zero", coulomb(0)),
                               ("frictionless", "frictionless"))]
    with figures("friction coefficient 0") as f:
        for name in "pointU", "pointD", "sigma", "F":
            for region in "left", "right":
                a, b = (case.at(name, region=region) for case in cases)
                f.atMost(f"{name}, {region}: difference / scale",
                         largest(a - b)/largest(b), 1e-12)


# When contact acts

SPEEDS = {"parting": ((-0.2, 0, 0), (0.1, 0, 0)),
          "passing": ((0, 0.3, 0), (0, -0.3, 0)),
          "not there yet": ((0.2, 0, 0), (0.1, 0, 0))}


@pytest.mark.parametrize("dimensions", (1, 2, 3))
@pytest.mark.parametrize("motion", SPEEDS)
def test_no_contact(tmp_path, figures, dimensions, motion):
    """Bodies that separate from a zero gap, pass each other at a distance of a
    hundredth of a cell, or approach without touching: no contact acts."""
    gap = {"parting": 0, "passing": 0.002, "not there yet": 0.11}[motion]
    bodies = blocks(dimensions, gap=gap, speeds=SPEEDS[motion])
    case = SmallCase(tmp_path, bodies, endTime=1,
                     interfaces=collision(coulomb(0.5)),
                     functions=("contactForces",)).run()
    contact = case.contact("contact")
    with figures(f"no contact, {dimensions}D, {motion}") as f:
        f.equal("largest area", contact["area"].max(), 0.0)
        f.atMost("change of velocity / 0.3 m/s", max(
            largest(case.at("pointU", region=b.name) - b.velocity)
            for b in bodies)/0.3, 1e-12)


def test_row_of_bars(tmp_path, figures):
    """Three equal bars touch, and the last two are at rest: the velocity of
    the first bar goes to the last one, through the two interfaces of the
    middle one. The last bar leaves at 3 L/c; the first two remain at rest."""
    n = 200
    bars = [Body(cells=(n,), name=f"bar{i}", start=(i, 0, 0),
                 material=ELASTIC, velocity=(V*(i == 0), 0, 0),
                 sides={"left": "contact" if i > 0 else "tractionFree",
                        "right": "contact" if i < 2 else "tractionFree"})
            for i in range(3)]
    interfaces = {
        f"pair{i}": interface((f"bar{i}", "right"), (f"bar{i + 1}", "left"))
        for i in range(2)}
    case = SmallCase(tmp_path, bars, endTime=6, interfaces=interfaces,
                     functions=("contactForces",)).run()
    p = np.array([case.momentumOf(bar.name)[:, 0] for bar in bars])
    pair = case.contact("pair1")
    release = pair["Time"][pair["area"] > 0][-1]
    with figures("row of three bars") as f:
        for i, wanted in enumerate((0, 0, 1)):
            f.within(f"momentum of bar {i} at the end / initial",
                     p[i, -1]/V, wanted, 0.01)
        f.atMost("change of total momentum / initial",
                 largest(p.sum(axis=0)/V - 1), 1e-12)
        f.within("last contact of bars 1 and 2", release, 3, 0.02)


def test_curved_surfaces(tmp_path, figures):
    """Matching curved surfaces: a cap moves into its hollow along x. All
    corners are paired, and the impact stays symmetric about the axis."""
    n, bulge, gap = 8, 0.15, 0.01

    right, left = ([(x + bulge, 0.5, z) for z in (0, 1)]
                   for x in (1.0, 1.0 + gap))
    bodies = [
        Body(cells=(n, n), name="cap", velocity=(0.2, 0, 0),
             sides={"right": "contact"},
             edges=("arc", 1, 2, right[0], "arc", 5, 6, right[1])),
        Body(cells=(n, n), name="hollow", start=(1 + gap, 0, 0),
             sides={"left": "contact"},
             edges=("arc", 0, 3, left[0], "arc", 4, 7, left[1]))]
    case = SmallCase(
        tmp_path, bodies, endTime=4, functions=("contactForces",),
        interfaces={"contact": interface(
            ("cap", "right"), ("hollow", "left"))})
    code, log = case.attempt()
    contact = case.contact("contact")
    p = case.momentumOf()

    def mirrorError(region, name, signs):
        X = case.X(region)
        U = case.at(name, region=region)
        row = {tuple(x): i for i, x in enumerate(np.round(X, 8) + 0.0)}
        other = [row[tuple(x)]
                 for x in np.round(X*(1, -1, 1) + (0, 1, 0), 8) + 0.0]
        return largest(U[other]*signs - U)

    closed = contact["area"] > 0
    with figures("cap into its hollow, 2D") as f:
        f.equal("exit code", code, 0)
        f.equal("corners paired", f"{2*n} of {2*n} and {2*n}" in log, True)
        f.equal("closed at some time, open at the end",
                (bool(closed.any()), bool(closed[-1])), (True, False))
        f.atMost("change of momentum / initial",
                 largest(p - p[0])/largest(p[0]), 1e-12)
        for region in "cap", "hollow":
            f.atMost(f"asymmetry of v at the end, {region} / 0.2 m/s",
                     mirrorError(region, "pointU", (1, -1, 1))/0.2, 1e-9)
        f.atMost("impulse along y / along x",
                 largest(impulse(contact, "cap.right")[-1, 1])
                 / largest(impulse(contact, "cap.right")[-1, 0]), 1e-9)
        f.atMost("largest penetration / cell",
                 contact["penetration"].max()*n, 0.15)
