"""One body without contact, compared with exact solutions and invariants."""

import re
from dataclasses import replace

import numpy as np
import pytest

from vertexContactTests.caseTools import DEFAULT, timeFolders
from vertexContactTests.smallCases import (ELASTIC, Body, SmallCase, condition,
                                           distorted, largest, smooth, table)

CELLS = "simplicial", "simplicialSingle", "native"
LAWS = "linearElastic", "neoHookean", "MooneyRivlin"


def material(law, nu=0.3):
    values = {"type": law, "rho": 1, "E": 1, "nu": nu}
    if law == "MooneyRivlin":
        mu = 0.5/(1 + nu)
        values["xi"] = mu/(6*np.sqrt(3))
    return values


def block(dimensions, n, amplitude=0.3, **more):
    """A unit block of distorted cells."""
    return Body(cells=(n, n + 1, n + 2)[:dimensions],
                moved=distorted(amplitude, dimensions=dimensions), **more)


# Exact results

@pytest.mark.parametrize("dimensions", (2, 3))
def test_free_stream(tmp_path, figures, dimensions):
    """A uniform velocity on a distorted mesh stays uniform: D = v t, F = I,
    and there is no stress."""
    v = np.array((0.3, -0.2, 0.1))*(np.arange(3) < dimensions)
    bodies = [block(dimensions, 5, name=f"{cells}{law}", velocity=v,
                    material=material(law), scheme={"cells": cells})
              for cells in CELLS for law in LAWS]
    case = SmallCase(tmp_path, bodies, endTime=2).run()
    with figures(f"free stream, {dimensions}D, 9 bodies") as f:
        f.atLeast("steps", len(case.energies["Time"]), 50)
        for name, expected, scale in (
                ("pointU", v, 0.3), ("pointD", 2*v, 0.6),
                ("F", np.eye(3).ravel(), 1), ("sigma", 0, 1)):
            f.atMost(f"{name}: largest error / scale", max(
                largest(case.at(name, region=body.name) - expected)/scale
                for body in bodies), 1e-12)


@pytest.mark.parametrize("dimensions", (1, 2, 3))
def test_squeezed_metal(tmp_path, figures, dimensions):
    """Metal compressed between mirrors to 0.4 of its length is nine times as
    stiff, and the step must follow: sigma = M ln l/l, minus 2/3 of the excess
    of the deviator over the yield stress."""
    E, nu, tauY, length = 1, 0.3, 0.05, 0.4
    mu, kappa = E/(2*(1 + nu)), E/(3*(1 - 2*nu))
    T = 40
    sides = {side: "symmetryPlane"
             for side in ("left", "bottom", "top", "back", "front")}
    s = np.linspace(0, 1, 101)
    sides["right"] = condition("fixedDisplacement", displacement=table(
        *((T*a, ((length - 1)*b, 0, 0)) for a, b in zip(s, smooth(s)))))
    laws = {"elastic": 1e6, "flows": tauY}
    bodies = [Body((8, 3, 3)[:dimensions], name=name, sides=sides, material={
        "type": "HenckyVonMises", "rho": 1, "E": E, "nu": nu, "tauY": Y})
        for name, Y in laws.items()]
    case = SmallCase(tmp_path, bodies, T, preset=DEFAULT,
                     control={"maxCo": 0.9}).run()
    pressure = kappa*np.log(length)
    expected = {"elastic": (pressure + 4*mu/3*np.log(length))/length,
                "flows": (pressure - 2*tauY/3)/length}
    energies = case.energies
    with figures(f"squeezed metal, {dimensions}D") as f:
        for name, sigma in expected.items():
            f.atMost(f"{name}: error of sigma_xx / its own", largest(
                case.at("sigma", region=name)[:, 0]/sigma - 1), 1e-3)
        f.atMost("balance / largest strain energy",
                 largest(energies["total:balance"])
                 / max(energies["total:strain"]), 1e-4)


def test_free_fall(tmp_path, figures):
    """Only a body force acts: v = g t, D = g t^2/2. The momentum is weight x
    time, and the work of the weight is the kinetic energy."""
    g = np.array((0.05, -0.1, 0.02))
    bodies = [block(d, 4, name=f"body{d}", material=material(law))
              for d, law in ((1, "neoHookean"), (2, "MooneyRivlin"),
                             (3, "neoHookean"))]
    T = 2.0
    case = SmallCase(tmp_path, bodies, endTime=T, gravity=g).run()
    scale = np.linalg.norm(g)
    with figures("free fall, 1D 2D 3D") as f:
        for d, body in enumerate(bodies, start=1):
            fall = g*(np.arange(3) < d)
            name = body.name
            p = case.momentumOf(name)
            t = case.momentum["Time"]
            work = case.energies[f"{name}:externalWork"]
            kinetic = case.energies[f"{name}:kinetic"]
            f.atMost(f"{d}D, v - g t / scale", largest(
                case.at("pointU", region=name) - fall*T)/(scale*T), 1e-10)
            f.atMost(f"{d}D, D - g t^2/2 / scale", largest(
                case.at("pointD", region=name) - fall*T**2/2)
                / (scale*T**2/2), 1e-10)
            f.atMost(f"{d}D, momentum - weight time / scale",
                     largest(p - np.outer(t, fall))/(scale*T), 1e-10)
            f.atMost(f"{d}D, work - kinetic energy / kinetic energy",
                     largest(work - kinetic)/kinetic[-1], 1e-10)


# Body forces

def shaken(**more):
    """A distorted block on a rigid base between two mirrors, with an initial
    velocity."""
    mirror = "symmetryPlane"
    sides = {"back": condition("fixedVelocity", velocity=(0, 0, 0)),
             "left": mirror, "bottom": mirror}
    return block(3, 4, sides=sides, material=material("neoHookean"),
                 velocity=lambda X: 0.1*X[:, 2:]*(X*(1, 0.5, 0)), **more)


@pytest.mark.parametrize("control", (
    {"maxCo": 0.9}, {"maxCo": 0.9, "massScaling": {"body": {
        "factor": 4, "force": "yes"}}}), ids=("free", "scaled"))
def test_probe_tells_the_field(tmp_path, figures, control):
    """The velocity of a probe belongs to the time of the state. It is not the
    leapfrog velocity half a step earlier."""
    g, end = 100, 0.1
    case = SmallCase(
        tmp_path, Body((10,), velocity=(1, 0, 0), material=material(LAWS[1])),
        end, gravity=(g, 0, 0), preset=DEFAULT, control=control,
        probes={"tip": ("body", (1, 0, 0))}).run()
    _, u = case.probe("tip", "pointU")
    tip = np.argmax(case.X()[:, 0])
    with figures(f"velocity of a probe, {list(control)}") as f:
        f.within("that of the field", u.reshape(len(u), -1)[-1, 0],
                 case.at("pointU")[tip, 0], 1e-12)
        if "massScaling" not in control:
            f.within("that of free fall", u.reshape(len(u), -1)[-1, 0],
                     1 + g*end, 1e-9)


def test_uniform_body_force(tmp_path, figures):
    """A uniform body force equals the gravity of constant/g bit by bit. So do
    two forces of half the size."""
    g = np.array((0.1, 0.05, -0.2))
    forces = {"weight": {"type": "uniform", "acceleration": g}}
    halves = {name: {"type": "uniform", "acceleration": g/2}
              for name in ("half", "otherHalf")}
    gravity = SmallCase(tmp_path/"g", (shaken(), shaken(name="other")),
                        endTime=1, gravity=g).run()
    force = SmallCase(tmp_path/"force",
                      (shaken(forces=forces), shaken(name="other",
                                                     forces=halves)), endTime=1)
    code, log = force.attempt()
    work = [case.energies["body:externalWork"] for case in (gravity, force)]
    with figures("uniform body force") as f:
        f.equal("exit code", code, 0)
        f.equal("body forces reported", re.findall(
            r"gravity (\w+), body forces (.*), contact", log),
            [("off", "weight (uniform)"),
             ("off", "half (uniform) otherHalf (uniform)")])
        for region in "body", "other":
            for name in "pointU", "pointD", "F", "J", "sigma":
                f.atMost(f"{region}, {name}: difference to gravity", largest(
                    gravity.at(name, region=region)
                    - force.at(name, region=region)), 0)
        f.atLeast("|D|", largest(gravity.at("pointD")), 0.05)
        f.atMost("work: difference / work",
                 largest(work[0] - work[1])/largest(work[0]), 1e-12)


def test_body_force_in_time(tmp_path, figures):
    """A uniform body force that changes in time gives a free body its impulse,
    by the trapezoidal rule of the two stages, and causes no stress. A body
    between mirrors does not leave them, and the power of the force closes the
    energy balance."""
    times, a = (0, 0.7, 1.1, 3), np.array(
        ((0, 0, 0), (0.1, -0.2, 0.05), (-0.3, 0.1, 0.2), (0, 0.2, -0.1)))
    forces = {"shaking": {"type": "uniform",
                          "acceleration": table(*zip(times, a))}}
    free = [block(d, 4, name=f"free{d}", forces=forces,
                  material=material("neoHookean")) for d in (1, 2, 3)]
    case = SmallCase(tmp_path, (*free, shaken(forces=forces)),
                     endTime=times[-1]).run()

    t = case.energies["Time"]
    rate = np.stack([np.interp(t, times, a[:, i]) for i in range(3)], axis=1)
    steps = np.diff(t)[:, None]*(rate[1:] + rate[:-1])/2
    impulse = np.vstack((np.zeros(3), np.cumsum(steps, axis=0)))
    scale = largest(impulse)
    X, v = case.X("body"), case.at("pointU", region="body")
    with figures("body force in time") as f:
        f.atLeast("steps", len(t), 50)
        for d, body in enumerate(free, start=1):
            inside = np.arange(3) < d
            f.atMost(f"{d}D, momentum - impulse / largest impulse", largest(
                case.momentumOf(body.name) - impulse*inside)/scale, 1e-12)
            f.atMost(f"{d}D, largest stress / E", largest(
                case.at("sigma", region=body.name)), 1e-12)
            work = case.energies[f"{body.name}:externalWork"]
            kinetic = case.energies[f"{body.name}:kinetic"]
            f.atMost(f"{d}D, work - kinetic energy / largest", largest(
                work - kinetic)/largest(kinetic), 1e-4)
        for i, side in enumerate(("left", "bottom")):
            f.atMost(f"between mirrors, velocity through the {side}",
                     largest(v[np.abs(X[:, i]) < 1e-9, i]), 0)
        total = case.energies["body:kinetic"] + case.energies["body:strain"]
        f.atLeast("between mirrors, work / largest energy", largest(
            case.energies["body:externalWork"])/largest(total), 0.5)
        f.atMost("between mirrors, balance residual / largest energy", largest(
            case.energies["body:balance"])/largest(total), 1e-3)


@pytest.mark.parametrize("dimensions", (1, 2, 3))
def test_linear_displacement(tmp_path, figures, dimensions):
    """An initial displacement D = A X gives F = I + A at every node, including
    corners, and the stress of the law: for neo-Hookean J sigma = mu J^(-2/3)
    dev(F F^T) + kappa (J - 1) J I."""
    A = np.array(((0.1, 0.05, -0.03), (-0.2, 0.15, 0.04), (0.02, 0.1, -0.1)))
    A[dimensions:] = 0
    A[:, dimensions:] = 0
    bodies = [
        block(dimensions, 4, name=cells, displacement=lambda X: X @ A.T,
              amplitude=0 if cells == "native" else 0.2,
              scheme={"cells": cells}) for cells in CELLS]
    case = SmallCase(tmp_path, bodies, endTime=1e-12).run()

    F = np.eye(3) + A
    J = np.linalg.det(F)
    mu, kappa = 0.5/1.3, 1/(3*0.4)
    b = F @ F.T
    sigma = (mu*J**(-5/3)*(b - np.trace(b)/3*np.eye(3))
             + kappa*(J - 1)*np.eye(3))
    expected = {"F": F.ravel(), "J": J, "sigma": sigma[np.triu_indices(3)],
                "H": (J*np.linalg.inv(F).T).ravel()}
    if dimensions == 1:
        del expected["H"]
    with figures(f"linear displacement, {dimensions}D") as f:
        for body in bodies:
            for name, value in expected.items():
                f.atMost(f"{name}, {body.name}: largest error", largest(
                    case.at(name, region=body.name) - value), 1e-11)


# Waves in a bar: length 1, c = 1, rho = 1

def bar(n=200, **more):
    return Body(cells=(n,), material=ELASTIC, **more)


def waveErrors(case, at, exact):
    """Relative L1 errors in time of v and sigma at a probe; exact returns both
    for a time."""
    t, u = case.probe(at, "pointU")
    _, s = case.probe(at, "sigma")
    v, sigma = np.array([exact(time) for time in t]).T
    errors = []
    for values, wanted in ((u, v), (s, sigma)):
        errors.append(np.trapezoid(np.abs(values[:, 0] - wanted), t)
                      / np.trapezoid(np.abs(wanted), t))
    return errors


def worked(case):
    return case.energies["total:externalWork"]


def balance(case):
    """Largest residual of the energy balance relative to the work."""
    return largest(case.energies["total:balance"])/largest(worked(case))


@pytest.mark.parametrize("fixed", (False, True))
def test_traction_step(tmp_path, figures, fixed):
    """A traction s at the end x = 1 from t = 0 on sends a wave with sigma = s,
    v = s/(rho c). At x = 0 it is reflected. Free end: sigma = 0, v = 2s/(rho
    c); fixed end: sigma = 2s, v = 0. The work is s^2 t/(rho c) until the wave
    returns at t = 2."""
    s = -0.01
    sides = {"right": condition("traction", traction=(s, 0, 0))}
    if fixed:
        sides["left"] = condition("fixedVelocity", velocity=(0, 0, 0))
    case = SmallCase(tmp_path, bar(sides=sides), endTime=2,
                     probes={"middle": ("body", (0.5, 0, 0))}).run()

    def exact(t):
        back = (t > 0.5) + 0
        again = (t > 1.5) + 0
        sign = -1 if fixed else 1
        return s*(back + sign*again), s*(back - sign*again)

    ev, es = waveErrors(case, "middle", exact)
    t, u = case.probe("middle", "pointU")
    arrival = t[np.argmax(np.abs(u[:, 0]) > 0.5*abs(s))]
    _, sigma = case.probe("middle", "sigma")
    plateau = (t > 0.7) & (t < 1.3)
    late = t > 1.7
    with figures("traction step, " + ("fixed" if fixed else "free")) as f:
        f.within("arrival at the middle", arrival, 0.5, 0.005)
        f.atMost("v at the middle, relative L1 error", ev, 0.03)
        f.atMost("sigma at the middle, relative L1 error", es, 0.03)
        f.atMost("plateau: error of v",
                 largest(u[plateau, 0]/s - 1), 0.01)
        f.atMost("plateau: error of sigma",
                 largest(sigma[plateau, 0]/s - 1), 0.01)
        wanted = (0, 2) if fixed else (2, 0)
        f.atMost("after the reflection: error of v",
                 largest(u[late, 0]/s - wanted[0]), 0.02)
        f.atMost("after the reflection: error of sigma",
                 largest(sigma[late, 0]/s - wanted[1]), 0.02)
        done = worked(case)
        exactWork = s**2*case.energies["Time"]
        f.atMost("work: largest error / final",
                 largest(done - exactWork)/exactWork[-1], 0.01)
        f.atMost("balance residual / work", balance(case), 1e-3)


@pytest.mark.parametrize("kind", ("traction", "fixedVelocity"))
def test_ramp_travels_unchanged(tmp_path, figures, kind):
    """A load rises linearly to its value at T = 0.5, from a table of times. At
    distance x the same rise appears in v and sigma = +-rho c v, later by x/c.
    The work is s^2 T/3 + s^2 (t - T), for s = rho c V."""
    s, T = 0.01, 0.5
    name = {"traction": "traction", "fixedVelocity": "velocity"}[kind]
    load = table((0, (0, 0, 0)), (T, (s, 0, 0)), (9, (s, 0, 0)))
    case = SmallCase(
        tmp_path, bar(sides={"right": condition(kind, **{name: load})}),
        endTime=1, probes={"middle": ("body", (0.5, 0, 0))}).run()

    def exact(t):
        return 2*(s*np.clip((t - 0.5)/T, 0, 1),)

    ev, es = waveErrors(case, "middle", exact)
    t = case.energies["Time"]
    exactWork = s**2*np.where(t < T, t**3/(3*T**2), T/3 + t - T)
    with figures(f"ramp, {kind}") as f:
        f.atMost("v at the middle, relative L1 error", ev, 0.005)
        f.atMost("sigma at the middle, relative L1 error", es, 0.005)
        f.atMost("work: largest error / final",
                 largest(worked(case) - exactWork)/exactWork[-1], 0.005)
        f.atMost("balance residual / work", balance(case), 1e-3)


@pytest.mark.parametrize("reconstruction, least", (
    ("none", 0.8), ("linear", 1.7), ("full", 1.7)))
def test_order_in_space(tmp_path, figures, reconstruction, least):
    """Standing wave between free ends, v = V cos(pi x) cos(pi t), sigma = -rho
    c V sin(pi x) sin(pi t): order of the L2 errors at t = 0.75 on 32, 64 and
    128 elements, without limiter."""
    V, T = 0.01, 0.75
    errors = []
    for n in 32, 64, 128:
        case = SmallCase(tmp_path/str(n), bar(
            n, scheme={"reconstruction": reconstruction, "limiter": "none"},
            velocity=lambda X: V*np.cos(np.pi*X[:, :1])*(1, 0, 0)),
            endTime=T).run()
        x = case.X()[:, 0]
        v = V*np.cos(np.pi*x)*np.cos(np.pi*T)
        sigma = -V*np.sin(np.pi*x)*np.sin(np.pi*T)
        errors.append([
            np.linalg.norm(case.at(name)[:, 0] - wanted)
            / np.linalg.norm(wanted)
            for name, wanted in (("pointU", v), ("sigma", sigma))])
    errors = np.array(errors)
    orders = np.log2(errors[:-1]/errors[1:])
    with figures(f"order of accuracy, {reconstruction}") as f:
        for i, name in enumerate(("v", "sigma")):
            f.falling(f"{name}: relative L2 errors", errors[:, i])
            f.atLeast(f"{name}: order, 32 to 64", orders[0, i], least)
            f.atLeast(f"{name}: order, 64 to 128", orders[1, i], least)


# Invariants

def pressureRatio(dimensions, p, nu=0.3):
    """Pressure over J for a neo-Hookean body under pressure from all sides. In
    plane strain sigma = mu J^(-5/3) (J - 1)/3 + kappa (J - 1) in the plane."""
    mu, kappa = 0.5/(1 + nu), 1/(3*(1 - 2*nu))
    J = 1.0
    for _ in range(100):
        plane = mu*J**(-5/3)/3 if dimensions == 2 else 0
        J = 1 - p/(kappa + plane)
    return J


@pytest.mark.parametrize("dimensions", (2, 3))
def test_pressure_on_all_sides(tmp_path, figures, dimensions):
    """Pressure from all sides that rises during many wave transits: the body
    takes the volume of static equilibrium, kappa (1 - J) = p in 3D, and its
    momentum stays zero."""
    p, T = 0.1, 30
    load = condition("pressure", pressure=table((0, 0), (T, p), (99, p)))
    sides = {side: load for side in
             ("left", "right", "bottom", "top", "back", "front")}
    n = 8 if dimensions == 2 else 5
    case = SmallCase(tmp_path, block(dimensions, n, amplitude=0, sides=sides),
                     endTime=T).run()
    J = case.at("J")
    P = case.momentumOf("body")
    expected = pressureRatio(dimensions, p)
    with figures(f"pressure on all sides, {dimensions}D") as f:
        f.within("mean change of volume / expected",
                 (1 - J.mean())/(1 - expected), 1, 0.02)
        f.within("mean pressure in the plane / p",
                 -case.at("sigma")[:, 0].mean()/p, 1, 0.02)
        f.atMost("momentum / (p L^2 time)", largest(P)/(p*T), 1e-12)


def currentVolume(case, body):
    """Area of a deformed 2D block from its outline."""
    X = case.X(body)
    x = (X + case.at("pointD", region=body))[:, :2]
    X = X[:, :2]
    front = case.X(body)[:, 2] < 0.5
    X, x = X[front], x[front]
    lo, hi = X.min(axis=0), X.max(axis=0)
    sides = []
    for on, by, sign in ((X[:, 1] - lo[1], X[:, 0], 1),
                         (X[:, 0] - hi[0], X[:, 1], 1),
                         (X[:, 1] - hi[1], X[:, 0], -1),
                         (X[:, 0] - lo[0], X[:, 1], -1)):
        points = np.flatnonzero(np.abs(on) < 1e-9)
        sides.append(points[np.argsort(sign*by[points])][:-1])
    outline = x[np.concatenate(sides)]
    a, b = outline, np.roll(outline, -1, axis=0)
    return 0.5*np.sum(a[:, 0]*b[:, 1] - a[:, 1]*b[:, 0])


def spin(omega, centre=(0.5, 0.5, 0.5), axis=2):
    w = omega*np.eye(3)[axis]
    return lambda X: np.cross(w, X - np.array(centre))


@pytest.mark.parametrize("reconstruction, limiter, drift", (
    ("linear", "BarthJespersen", 0.06), ("full", "none", 0.002),
    ("full", "BarthJespersen", 0.15)))
def test_pressure_on_a_rotating_body(tmp_path, figures, reconstruction,
                                     limiter, drift):
    """A body rotates and vibrates under pressure from all sides; the load
    follows the rotation. Its resultant and moment vanish and its work is -p
    (volume change), for any deformation, up to errors of the mesh. The limiter
    acts on each component of the velocity jumps at extrema. This disturbs the
    rotation and slows it: the drifts with a limiter show how much."""
    p, omega, T = 0.1, 0.2, 5
    load = condition("pressure", pressure=p)
    sides = {side: load for side in ("left", "right", "bottom", "top")}

    def velocity(X):
        # not symmetric about the centre
        return (spin(omega)(X)
                + 0.1*np.sin(2*X[:, 1:2] + X[:, :1])*(1, -0.5, 0))

    body = block(2, 20, sides=sides, velocity=velocity, scheme={
        "reconstruction": reconstruction, "limiter": limiter})
    case = SmallCase(tmp_path, body, endTime=T).run()
    momentum = case.momentumOf("body")
    L = case.momentum["body:Lz"]
    change = currentVolume(case, "body") - 1
    total = case.totalEnergy - worked(case)
    with figures(f"pressure on a rotating body, {reconstruction} {limiter}"
                 ) as f:
        f.atMost("change of momentum / (p L^2 time)",
                 largest(momentum - momentum[0])/(p*T), 1e-3)
        f.atMost("change of angular momentum / initial",
                 largest(L/L[0] - 1), drift)
        f.within("work / -p (volume change)",
                 worked(case)[-1]/(-p*change), 1, 0.1)
        f.within("energy less work at the end / initial",
                 total[-1]/total[0], 0.8, 0.2)
        f.atMost("balance residual / initial energy",
                 largest(case.energies["total:balance"])/total[0], 5e-3)


def mirrored(function):
    """A field of a quarter or eighth, extended by mirror symmetry to negative
    coordinates."""
    def whole(X):
        sign = np.where(X < 0, -1, 1)
        return sign*function(np.abs(X))
    return whole


@pytest.mark.parametrize("limiter", ("none", "BarthJespersen"))
@pytest.mark.parametrize("dimensions", (2, 3))
def test_symmetry(tmp_path, figures, dimensions, limiter):
    """A quarter (2D) or eighth (3D) with symmetryPlane or slip equals the
    whole body, which is compressed by a traction, an initial displacement and
    an initial velocity."""
    n = 6 if dimensions == 2 else 3
    d = dimensions
    inside = np.arange(3) < d
    distort = distorted(0.3, dimensions=d)

    def velocity(X):
        x, y, z = X.T
        return np.stack((-0.2*np.sin(np.pi*x/2)*np.cos(y),
                         0.1*np.sin(np.pi*y/2)*(1 + 0.3*np.cos(np.pi*x)),
                         0.1*np.sin(z)*np.cos(x)), axis=1)*inside

    def stretchWhole(X):
        return np.where(inside, mirrored(distort)(X), X)

    def velocityWhole(X):
        return np.where(inside, mirrored(velocity)(X), 0)

    load = 0.05
    scheme = {"limiter": limiter}
    whole = Body(
        cells=d*(2*n,), start=np.where(inside, -1, 0),
        size=np.where(inside, 2, 1), moved=stretchWhole,
        velocity=velocityWhole, name="whole", scheme=scheme,
        displacement=lambda X: 0.5*velocityWhole(X),
        sides={"left": condition("traction", traction=(load, 0, 0)),
               "right": condition("traction", traction=(-load, 0, 0))})
    part = Body(cells=d*(n,), moved=distort, velocity=velocity,
                displacement=lambda X: 0.5*velocity(X),
                scheme=scheme, name="mirror", sides={
                    "left": "symmetryPlane", "bottom": "symmetryPlane",
                    "back": "symmetryPlane",
                    "right": whole.sides["right"]})
    slip = replace(part, name="slip", sides={
        **part.sides, **{side: "slip" for side in ("left", "bottom", "back")}})

    # In one run, so that both have the same steps
    case = SmallCase(tmp_path, [whole, part, slip], endTime=3).run()
    X = case.X("whole")
    row = {tuple(x): i for i, x in enumerate(np.round(X, 9) + 0.0)}
    with figures(f"mirror symmetry, {d}D, limiter {limiter}") as f:
        for body in part, slip:
            x = np.round(case.X(body.name), 9) + 0.0
            rows = [row[tuple(point)] for point in x]
            for name, scale in (("pointU", 0.2), ("pointD", 0.2),
                                ("sigma", 0.2)):
                a = case.at(name, region="whole")[rows]
                b = case.at(name, region=body.name)
                f.atMost(f"{name}, {body.name}: difference / scale",
                         largest(a - b)/scale, 1e-9)
            v = case.at("pointU", region=body.name)
            f.equal(f"normal velocity on the mirrors, {body.name}", max(
                largest(v[np.abs(x[:, i]) < 1e-9, i]) for i in range(d)), 0.0)
        f.atMost("momentum of the whole / scale",
                 largest(case.momentumOf("whole"))/0.2, 1e-12)


# Options that must agree

def vibration(dimensions, n, scale, **scheme):
    """A block with a smooth vibration."""
    def velocity(X):
        x, y, z = np.pi*X.T
        v = scale*np.stack((np.cos(x)*np.cos(y), np.cos(x)*np.cos(y),
                            np.cos(z)*np.cos(y)), axis=1)
        return v*(np.arange(3) < dimensions)
    return block(dimensions, n, amplitude=0.2, velocity=velocity,
                 scheme=scheme, name="".join(scheme.values()))


def difference(case, name, one, other):
    """Relative L2 difference of a field of two bodies."""
    a, b = (case.at(name, region=region) for region in (one, other))
    return np.linalg.norm(a - b)/np.linalg.norm(b)


KINEMATICS = "F", "FJ", "FHJ"
FORMS = "volumetric", "literal"


@pytest.mark.parametrize("dimensions", (2, 3))
def test_small_strain_kinematics_agree(tmp_path, figures, dimensions):
    """At strains of 1e-6, solving H or deriving it from F gives the same
    result up to second-order terms. Where J is det F, both forms of the
    Jacobian agree as well."""
    bodies = [vibration(dimensions, 6, 1e-6, kinematics=k, jacobian=j)
              for k in KINEMATICS for j in FORMS]
    case = SmallCase(tmp_path, bodies, endTime=1).run()
    with figures(f"small strain, {dimensions}D, relative difference") as f:
        for one, other in (("FJvolumetric", "FHJvolumetric"),
                           ("FJliteral", "FHJliteral"),
                           ("Fliteral", "Fvolumetric")):
            for name in "pointU", "sigma":
                f.atMost(f"{name}: {one} - {other}",
                         difference(case, name, one, other), 1e-5)


def test_small_strain_dissipation(tmp_path, figures):
    """At strains of 1e-6, smooth solutions with and without solved J, and with
    both forms of the Jacobian, differ only by numerical dissipation, which
    falls with the cell size."""
    pairs = (("Fvolumetric", "FHJvolumetric"), ("FHJliteral", "FHJvolumetric"))
    found = {pair: [] for pair in pairs}
    for n in 8, 16, 32:
        bodies = [vibration(2, n, 1e-6, kinematics=k, jacobian=j)
                  for k, j in (("F", "volumetric"), ("FHJ", "volumetric"),
                               ("FHJ", "literal"))]
        case = SmallCase(tmp_path/str(n), bodies, endTime=0.5).run()
        for pair in pairs:
            found[pair].append([difference(case, name, *pair)
                                for name in ("pointU", "sigma")])
    with figures("small strain, 2D, meshes 8 16 32") as f:
        for pair, values in found.items():
            for name, v in zip(("pointU", "sigma"), np.array(values).T):
                f.falling(f"{name}: {pair[0]} - {pair[1]}", v)
                f.atMost(f"{name}: {pair[0]} - {pair[1]}, finest", v[-1],
                         0.02)


def test_near_incompressible(tmp_path, figures):
    """nu = 0.4999: a 2D block hits a rigid base. There is no pressure
    checkerboard: the alternating part from node to node stays small."""
    n = 16
    law = material("neoHookean", 0.4999)
    clamp = condition("fixedVelocity", velocity=(0, 0, 0))
    bodies = [
        Body(cells=(n, n), name=kinematics, material=law,
             velocity=(0, -0.1, 0), sides={"bottom": clamp},
             scheme={"kinematics": kinematics})
        for kinematics in ("F", "FHJ")]
    case = SmallCase(tmp_path, bodies, endTime=0.6).run()

    def checkerboard(region):
        X = case.X(region)
        front = X[:, 2] < 0.5
        order = np.lexsort((X[front, 0], X[front, 1]))
        p = case.at("pressure", region=region)[front, 0][order]
        p = p.reshape(n + 1, n + 1)
        smooth = 0.25*(p[2:, 1:-1] + p[:-2, 1:-1] + p[1:-1, 2:] + p[1:-1, :-2])
        return np.linalg.norm(p[1:-1, 1:-1] - smooth)/np.linalg.norm(
            p[1:-1, 1:-1])

    total = case.energies["FHJ:kinetic"] + case.energies["FHJ:strain"]
    J = case.at("J", region="FHJ")
    with figures("nu = 0.4999, 2D impact on a base") as f:
        f.equal("finite values", bool(np.all(np.isfinite(total))), True)
        f.atMost("largest energy / initial", total.max()/total[0], 1.001)
        f.atMost("largest |J - 1|", largest(J - 1), 0.01)
        f.atMost("checkerboard of pressure, FHJ", checkerboard("FHJ"), 0.3)
        f.atLeast("checkerboard of pressure, F / FHJ",
                  checkerboard("F")/checkerboard("FHJ"), 1)


# Decomposed and interrupted runs

FIELDS = "pointU", "pointD", "lm", "F", "H", "J", "sigma", "pressure"


def column(**more):
    """A twisted neo-Hookean column, clamped at z = 0."""
    size = (1, 1, 3)

    def velocity(X):
        return (0.2*np.sin(np.pi*X[:, 2:]/6)
                * np.cross((0, 0, 1), X - (0.5, 0.5, 0)))
    return Body(cells=(4, 4, 10), size=size, velocity=velocity,
                moved=distorted(0.2, size),
                material=material("neoHookean", 0.45), sides={
                    "back": condition("fixedVelocity", velocity=(0, 0, 0))},
                **more)


@pytest.mark.parametrize("method", ("metis", "random"))
def test_parallel(tmp_path, figures, method):
    """Three ranks, by METIS or with random cells, give the serial result."""
    serial = SmallCase(tmp_path/"serial", column(), endTime=4).run()
    parallel = SmallCase(tmp_path/"parallel", column(), endTime=4)
    parallel.runParallel(3, method)
    steps = len(serial.energies["Time"])
    with figures(f"3 ranks, {method}") as f:
        f.atLeast("steps", steps, 200)
        f.equal("steps of both", len(parallel.energies["Time"]), steps)
        for name in FIELDS:
            a, b = serial.at(name), parallel.at(name)
            f.atMost(f"{name}: largest difference / scale",
                     largest(a - b)/largest(a), 1e-10)


def test_restart(tmp_path, figures):
    """A run in two parts equals the run in one part, bit by bit."""
    control = {"writeInterval": 1}
    straight = SmallCase(tmp_path/"straight", column(), endTime=2,
                         control=control).run()
    split = SmallCase(tmp_path/"split", column(), endTime=2, control=control)
    split.set("system/controlDict", {"endTime": 1})
    split.run()
    split.set("system/controlDict", {"endTime": 2})
    split.run()
    names = sorted(file.name for file in (straight/"2"/"body").iterdir())
    different = [name for name in names if
                 (straight/"2"/"body"/name).read_bytes()
                 != (split/"2"/"body"/name).read_bytes()]
    with figures("restart, 3D") as f:
        f.equal("fields there", set(FIELDS) <= set(names), True)
        f.equal("fields that differ", different, [])


@pytest.mark.parametrize("ranks", (1, 2))
def test_inverted_body_ends_the_run(tmp_path, figures, ranks):
    """If a body is turned inside out, the run ends with the place and the
    time, and writes the last good state."""
    body = block(2, 6, velocity=lambda X: -30*(X - 0.5)*(1, 1, 0))
    case = SmallCase(tmp_path, body, endTime=1)
    code, output = case.attempt(ranks)
    found = re.search(r"region body, node at \(.*\) \(reference\)", output)
    when = re.search(r"in the step to time (\S+) s", output)
    folder = tmp_path/"processor0" if ranks > 1 else tmp_path
    written = [t for t in timeFolders(folder) if float(t) > 0]
    with figures(f"inverted body, {ranks} rank(s)") as f:
        f.atLeast("exit code", code, 1)
        f.equal("region and place are named", bool(found), True)
        f.equal("time is named", bool(when), True)
        f.equal("times written", len(written), 1)
        if written and when:
            f.atMost("time of the state written / of failure",
                     float(written[0])/float(when[1]), 1)
    if ranks == 1:
        F = case.at("F").reshape(-1, 3, 3)
        with figures("inverted body, state written") as f:
            f.atLeast("smallest det F", np.linalg.det(F).min(), 1e-300)
            f.equal("velocity is finite", bool(
                np.all(np.isfinite(case.at("pointU")))), True)
