"""Bodies that were stretched before they had the shape of their mesh, by the
field F0: stress in closed form, springing back, waves, the same body meshed
before and after the stretch, restart and ranks, and refused input."""

import shutil

import numpy as np
import pytest

from vertexContactTests.caseTools import (DEFAULT, checked, contents,
                                          differingFiles)
from vertexContactTests.smallCases import (Body, SmallCase, condition,
                                           interface, largest)

E, NU, RHO = 1.0, 0.3, 1.0
MU, KAPPA = E/(2*(1 + NU)), E/(3*(1 - 2*NU))
XI = 0.05
SPEED = np.sqrt((KAPPA + 4*MU/3)/RHO)
LAWS = {"linearElastic": {}, "neoHookean": {}, "MooneyRivlin": {"xi": XI},
        "HenckyVonMises": {"tauY": 100}}
HELD = condition("fixedVelocity", velocity=(0, 0, 0))
SIDES = ("left", "right", "bottom", "top", "back", "front")


def law(kind, **more):
    return {"type": kind, "rho": RHO, "E": E, "nu": NU, **LAWS[kind], **more}


def energy(kind, F):
    """Energy per volume of the natural state."""
    if kind == "linearElastic":
        e = (F + F.T)/2 - np.eye(3)
        return MU*np.sum(e*e) + (KAPPA - 2*MU/3)/2*np.trace(e)**2
    J, I1 = np.linalg.det(F), np.sum(F*F)
    if kind == "HenckyVonMises":
        deviator = np.log(np.linalg.eigvalsh(F @ F.T))/2 - np.log(J)/3
        return MU*np.sum(deviator**2) + KAPPA/2*np.log(J)**2
    W = KAPPA/2*(J - 1)**2
    if kind == "neoHookean":
        return W + MU/2*(I1*J**(-2/3) - 3)
    H = J*np.linalg.inv(F).T
    zeta = (MU - 3*np.sqrt(3)*XI)/2
    return (W + zeta*(I1*J**(-2/3) - 3)
            + XI*(np.sum(H*H)**1.5/J**2 - 3*np.sqrt(3)))


def cauchy(kind, F):
    """Cauchy stress of a deformation from the natural state."""
    one = np.eye(3)
    if kind == "linearElastic":
        e = (F + F.T)/2 - one
        return 2*MU*e + (KAPPA - 2*MU/3)*np.trace(e)*one
    b, J = F @ F.T, np.linalg.det(F)
    I1 = np.trace(b)
    if kind == "HenckyVonMises":
        squares, n = np.linalg.eigh(b)
        return (n*(MU*np.log(squares) + (KAPPA - 2*MU/3)*np.log(J))) @ n.T/J
    p = KAPPA*(J - 1)*one
    deviator = b - I1/3*one
    if kind == "neoHookean":
        return p + MU*J**(-5/3)*deviator
    I2 = (I1**2 - np.trace(b @ b))/2
    zeta = (MU - 3*np.sqrt(3)*XI)/2
    return (p + 2*zeta*J**(-5/3)*deviator + XI*np.sqrt(I2)/J**3*(
        3*(I1*b - b @ b) - 2*I2*one))


def components(S):
    """A symmetric tensor as OpenFOAM writes it."""
    return S[[0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]]


def stretch(case, body, F0):
    """Give a body F0, one value for all points or one for each point."""
    X = case.points(body.name)
    F = np.array([F0(x) for x in X]) if callable(F0) else np.tile(
        np.asarray(F0, dtype=float), (len(X), 1, 1))
    case.writePointField(body, "F0", "[0 0 0 0 0 0 0]", F.reshape(-1, 9),
                         "tensor")


def make(folder, body, F0, endTime, **control):
    case = SmallCase(folder, body, endTime, preset=DEFAULT, control=control)
    stretch(case, body, F0)
    return case


STRETCHES = {
    1: ((1.3, 0, 0), (0, 0.9, 0), (0, 0, 0.9)),
    2: ((1.3, 0.2, 0), (-0.1, 0.8, 0), (0, 0, 1.1)),
    3: ((1.3, 0.2, 0.1), (-0.1, 0.8, 0.05), (0.15, -0.2, 1.1))}


@pytest.mark.parametrize("dimensions", STRETCHES)
@pytest.mark.parametrize("kind", LAWS)
def test_clamped_block(tmp_path, figures, kind, dimensions):
    """The clamped block is at rest, with the stress and the energy of the
    closed form."""
    F0 = np.array(STRETCHES[dimensions])
    body = Body(cells=(4, 3, 3)[:dimensions], material=law(kind),
                size=(1, 0.75, 0.75)[:dimensions] + (1,)*(3 - dimensions),
                sides=dict.fromkeys(SIDES[:2*dimensions], HELD))
    case = make(tmp_path, body, F0, 3.0, maxCo=0.9).run()
    sigma = cauchy(kind, F0)
    sigma = (sigma + sigma.T)/2
    J0 = 1 if kind == "linearElastic" else np.linalg.det(F0)
    W = energy(kind, F0)/J0*np.prod(body.size)
    e = case.energies
    with figures(f"clamped block, {kind}, {dimensions}D") as f:
        f.atMost("stress less the closed form / largest", largest(
            case.at("sigma") - components(sigma))/largest(sigma), 1e-13)
        f.atMost("strain energy / closed form less 1",
                 largest(e["total:strain"]/W - 1), 1e-13)
        f.atMost("velocity / speed of waves", largest(case.at("pointU"))/SPEED,
                 1e-13)
        f.atMost("F - I", largest(case.at("F") - np.eye(3).ravel()), 1e-13)
        f.atMost("F0 as it is written, less F0", largest(
            case.at("F0") - F0.ravel()), 0)


@pytest.mark.parametrize("kind", LAWS)
def test_springs_back(tmp_path, figures, kind):
    """A damped free block comes to rest free of stress: F F0 is a rotation, or
    F + F0 - I = I."""
    F0 = np.array(((1.25, 0.1, 0), (0.1, 0.85, 0), (0, 0, 1)))
    body = Body(cells=(6, 6), material=law(kind))
    case = make(tmp_path, body, F0, 40.0, maxCo=0.9, damping={
        "body": {"coefficient": 1.5}}).run()
    F = case.at("F").reshape(-1, 3, 3)
    left = F @ F0
    if kind == "linearElastic":
        left = F + F0 - np.eye(3)
    with figures(f"free block springs back, {kind}") as f:
        f.atMost("Cauchy-Green tensor from the natural state, less I",
                 largest(left.transpose(0, 2, 1) @ left - np.eye(3)), 1e-8)
        f.atLeast("F - I", largest(F - np.eye(3)), 0.1)
        f.atMost("stress / at first", largest(case.at("sigma"))
                 / largest(cauchy(kind, F0)), 1e-8)
        f.atMost("strain energy / at first", case.energies["total:strain"][-1]
                 / case.energies["total:strain"][0], 1e-14)


@pytest.mark.parametrize("s", (0.7, 1.5))
@pytest.mark.parametrize("kind", LAWS)
def test_waves_of_a_stretched_bar(tmp_path, figures, kind, s):
    """The standing wave of a bar that is held at both ends. With the length of
    the mesh c^2 = d2W/dl^2 s^2/(J0 rho), and the density is that of the
    mesh."""
    lateral = 0.9
    l = s if kind != "linearElastic" else 1
    J0 = s*lateral**2 if kind != "linearElastic" else 1
    h = 1e-3

    def W(x):
        return energy(kind, np.diag((x, lateral, lateral)))
    modulus = (W(s + h) - 2*W(s) + W(s - h))/h**2
    c = np.sqrt(modulus*l**2/J0/RHO)
    v = 1e-6
    body = Body(cells=(40,), material=law(kind),
                velocity=lambda X: v*np.sin(np.pi*X[:, :1])*(1, 0, 0),
                sides={"left": HELD, "right": HELD})
    time = 2.25*2/c
    case = make(tmp_path, body, np.diag((s, lateral, lateral)), time,
                maxCo=0.3).run()
    X, U = case.X()[:, 0], case.at("pointU")[:, 0]
    mode = np.sin(np.pi*X)
    amplitude = np.sum(mode*U)/np.sum(mode*mode)
    with figures(f"standing wave, {kind}, stretch {s}") as f:
        # v cos(pi c t) is 0 there
        f.within("speed / theory", 1 + amplitude/v/(np.pi*c*time), 1, 1e-3)
        f.atLeast("displacement / theory",
                  largest(case.at("pointD"))/(v/np.pi/c), 0.98)


@pytest.mark.parametrize("kind", ("neoHookean", "MooneyRivlin",
                                  "HenckyVonMises"))
def test_meshed_before_and_after(tmp_path, figures, kind):
    """A block is released in a stretched state. It is meshed without stress
    and displaced; or it is meshed as it is released, with F0 and the density
    of this state. Both have the same nodes and cells."""
    A = np.array((1.3, 0.9, 1.0))
    J0 = np.prod(A)
    sides = {"left": "symmetryPlane", "bottom": "symmetryPlane"}
    time, e, place, step = 2.0, {}, {}, {}
    for name in "before", "after":
        after = name == "after"
        body = Body(cells=(12, 12), size=tuple(A) if after else (1, 1, 1),
                    material=law(kind, rho=RHO/J0 if after else RHO),
                    sides=sides, displacement=None if after else
                    lambda X: X*(A - 1))
        case = SmallCase(tmp_path/name, body, time, preset=DEFAULT,
                         control={"maxCo": 0.45})
        if after:
            stretch(case, body, np.diag(A))
        case.run()
        e[name] = case.energies
        x = case.X() + case.at("pointD")
        place[name] = x[case.X()[:, 2] < 0.5]
        step[name] = np.diff(case.energies["Time"]).max()
    moved = largest(place["before"] - case.X()[case.X()[:, 2] < 0.5])
    with figures(f"meshed before and after the stretch, {kind}") as f:
        f.within("strain energy at first", e["after"]["total:strain"][0]
                 / e["before"]["total:strain"][0], 1, 1e-12)
        f.within("kinetic energy at the end", e["after"]["total:kinetic"][-1]
                 / e["before"]["total:kinetic"][-1], 1, 0.01)
        f.atLeast("largest displacement", moved, 0.2)
        f.atMost("largest difference of the places / that",
                 largest(place["after"] - place["before"])/moved, 0.01)


LET_GO = [(kind, nu, s) for kind, nu in (
    ("neoHookean", 0.3), ("neoHookean", 0.49), ("MooneyRivlin", 0.3))
    for s in (0.6, 2.0)] + [("HenckyVonMises", 0.3, s) for s in (0.7, 1.4)]


@pytest.mark.parametrize("kind, nu, s", LET_GO)
def test_released_at_once(tmp_path, figures, kind, nu, s):
    """Strongly stretched blocks are released, with the default share of the
    stable step. The bound of the step is safe, and the energy is conserved to
    second order of the step; for HenckyVonMises as well as with a displacement
    instead of F0."""
    body = Body(cells=(4, 4, 4), material={**law(kind), "nu": nu})
    case = make(tmp_path, body, np.diag((s, s**-0.5, s**-0.5)), 8.0,
                maxCo=0.9).run()
    e = case.energies
    first = e["total:strain"][0]
    total = case.totalEnergy + e["total:numericalDissipation"]
    with figures(f"let go, {kind}, nu {nu}, stretch {s}") as f:
        f.atLeast("largest kinetic energy / strain energy at first",
                  e["total:kinetic"].max()/first, 0.3)
        f.atMost("energy and dissipation, largest change / at first",
                 largest(total - first)/first,
                 0.07 if kind == "HenckyVonMises" else 0.03)
        f.atMost("momentum", largest(case.momentumOf()), 1e-12)


EXPRESSION = """
expressions
(
    stretch
    {
        field F0;
        keepPatches yes;
        variables ("s = point(1) + point(0.2)*sin(point(3)*pts().x())");
        expression
        #{
            tensor
            (
                s, point(0.1)*pts().y(), point(0),
                point(0), point(1)/s, point(0),
                point(0), point(0), point(1.05)
            )
        #};
    }
);
"""


#: These yield above the stresses of EXPRESSION with the other constants
METAL = {"tauY": 0.26, "Hardening": 0.1}


def expressed(folder, kind, nu):
    """A block whose F0 is not the gradient of a motion, set by
    setExprFields."""
    metal = kind == "HenckyVonMises"
    body = Body(cells=(8, 8), material=law(
        kind, nu=nu, **METAL if metal else {}), sides={"left": HELD},
        velocity=lambda X: 0.2*metal*X[:, :1]*(1, 0, 0))
    case = make(folder, body, np.eye(3), 2.0, writeInterval=1.0, maxCo=0.9)
    case.write("system/body/setExprFieldsDict", "dictionary", EXPRESSION)
    checked(["setExprFields", "-region", "body"], case.path)
    return case


@pytest.mark.parametrize("kind, nu", (
    ("neoHookean", 0.3), ("neoHookean", 0.49), ("HenckyVonMises", 0.3)))
def test_expression_ranks_and_restart(tmp_path, figures, kind, nu):
    """Two ranks differ by round-off. A restarted run is equal to the last bit,
    with the F0 of its start time, also with plastic flow."""
    one = expressed(tmp_path/"one", kind, nu).run()
    two = expressed(tmp_path/"two", kind, nu).runParallel(2)
    x, y = one.X()[:, 0], one.X()[:, 1]
    s, o = 1 + 0.2*np.sin(3*x), np.zeros_like(x)
    F0 = np.stack((s, 0.1*y, o, o, 1/s, o, o, o, o + 1.05), axis=1)
    expected = [contents(one/"2")]
    shutil.copytree(one.path, tmp_path/"again")
    for time in "0", "2":
        shutil.rmtree(tmp_path/"again"/time)
    checked(["vertexContactFoam"], tmp_path/"again")
    with figures(f"F0 by an expression, {kind}, {nu}: ranks, restart") as f:
        if kind == "HenckyVonMises":
            flow = one.at("epsilonPEq", "1"), one.at("epsilonPEq")
            f.atLeast("plastic strain before the restart", largest(flow[0]),
                      1e-3)
            f.atLeast("after it, more by", largest(flow[1] - flow[0]), 1e-3)
        f.atMost("F0 that is written less the expression",
                 largest(one.at("F0") - F0), 1e-15)
        f.atLeast("displacement", largest(one.at("pointD")), 0.05)
        f.atMost("displacement, two ranks less one",
                 largest(two.at("pointD") - one.at("pointD")), 1e-12)
        f.atMost("F0, two ranks less one",
                 largest(two.at("F0") - one.at("F0")), 0)
        f.equal("files that differ after a restart", differingFiles(
            expected, [contents(tmp_path/"again"/"2")]), [])
        f.atLeast("files compared", len(expected[0]), 8)


@pytest.mark.parametrize("kind", ("neoHookean", "HenckyVonMises"))
def test_scaled_to_a_step(tmp_path, figures, kind):
    """massScaling to a step takes the wave speeds of the stretched state into
    account."""
    body = Body(cells=(6, 6), material=law(kind),
                sides=dict.fromkeys(SIDES[:4], HELD))
    step = 0.2
    case = make(tmp_path, body, np.diag((1.6, 1, 1)), 18.0, maxCo=0.9,
                massScaling={"body": {"step": step, "force": "yes"}}).run()
    steps = np.diff(case.energies["Time"])
    with figures(f"massScaling by the step, with F0, {kind}") as f:
        f.within("step / maxCo of what is asked for",
                 np.median(steps)/(0.9*step), 1, 0.02)


@pytest.mark.parametrize("mean", (-0.06, 0.06))
def test_flow_under_mean_stress(tmp_path, figures, mean):
    """A metal with a mean stress at the start is strained uniformly until it
    flows. It agrees with the closed form, and the energy balance closes with
    the work of the flow."""
    F0, s, H = np.exp(mean)*np.eye(3), 0.1, 0.3
    tauY, J0 = 0.04, np.exp(3*mean)
    body = Body(cells=(6, 6, 6), material=law(
        "HenckyVonMises", tauY=tauY, Hardening=H),
        velocity=lambda X: s*X[:, :1]*(1, 0, 0), sides={
            **dict.fromkeys(SIDES, "symmetryPlane"),
            "right": condition("fixedVelocity", velocity=(s, 0, 0))})
    case = make(tmp_path, body, F0, 2.0, maxCo=0.3).run()
    l = 1 + 2*s
    # Deviator of the logarithm along the bar, and the part that the flow
    # leaves
    q = 2*MU*np.log(l)
    flow = (q - tauY)/(3*MU + H)
    q -= 3*MU*flow
    J = l*J0
    sigma = (np.array((2, -1, -1))*q/3 + KAPPA*np.log(J))/J
    e = case.energies
    with figures(f"flow under a mean strain of {mean}") as f:
        f.atMost("plastic strain less closed form / that", largest(
            case.at("epsilonPEq")/flow - 1), 1e-12)
        f.atMost("stress less the closed form / yield stress", largest(
            case.at("sigma")[:, (0, 3, 5)] - sigma)/tauY, 1e-12)
        f.within("plastic dissipation / closed form", e[
            "total:plasticDissipation"][-1]/((tauY*flow + H*flow**2/2)/J0), 1,
            1e-12)
        f.atMost("balance / plastic dissipation", largest(
            e["total:balance"])/e["total:plasticDissipation"][-1], 1e-3)


SHEARED = ((1, 0, 0.1), (0, 1, 0), (0, 0, 1))
BAD = {
    "paper": ({"preset": "paper"}, {}, np.eye(3), ("F0", "paper")),
    "beyond yield": ({}, {"material": law("HenckyVonMises", tauY=0.1)},
                     np.diag((1.2, 1.1, 1)), ("F0", "internalField",
                                              "yield stress", "0.1 Pa")),
    "rigid": ({}, {"material": {"type": "rigid", "rho": 1}}, np.eye(3),
              ("F0", "rigid")),
    "turned inside out": ({}, {}, np.diag((-1, 1, 1)),
                          ("F0", "internalField", "positive")),
    "out of the plane": ({}, {}, SHEARED,
                         ("F0", "internalField", "leaves out")),
    "one direction": ({}, {"cells": (3,)}, np.diag((1, 1, 1.1)),
                      ("F0", "internalField", "same stretch"))}


@pytest.mark.parametrize("what", BAD)
def test_bad_input(tmp_path, what):
    control, of, F0, named = BAD[what]
    of = {"cells": (3, 3), "material": law("neoHookean"), **of}
    case = make(tmp_path, Body(**of), F0, 1.0, **control)
    code, output = case.attempt()
    assert code != 0, output
    message = output[output.index("--> FOAM FATAL IO ERROR"):]
    for name in named:
        assert name in message, message
    assert case.last == "0"


def test_bad_dimensions(tmp_path):
    case = make(tmp_path, Body(cells=(3, 3)), np.eye(3), 1.0)
    case.replace("0/body/F0", r"dimensions \[0 0 0", "dimensions [0 1 0")
    code, output = case.attempt()
    assert code != 0, output
    message = output[output.index("--> FOAM FATAL IO ERROR"):]
    assert "F0" in message and "dimensions" in message, message


def test_stretched_surface_in_contact(tmp_path, figures):
    """A plate without stress is meshed as it is; or as it was before it became
    three times as wide at a third of the height. A heavier block hits it. Its
    nodes have the mass of their present area: contact takes energy, and the
    plate is as stiff."""
    A, size, e = np.array((3, 1/3, 1)), np.array((1.2, 0.4, 1)), {}
    for name in "before", "after":
        before = name == "before"
        height = size[1]/A[1] if before else size[1]
        plate = Body(
            (12, 4), "plate", (0, -height, 0), size/A if before else size,
            dict(left="symmetryPlane", bottom="slip", top="contact"),
            law("neoHookean"),
            displacement=(lambda X: X*(A - 1)) if before else None)
        block = Body(
            (5, 5), "block", (0, 0, 0), (0.5, 0.5, 1),
            dict(left="symmetryPlane", bottom="contact"),
            {**law("neoHookean"), "rho": 20, "E": 20}, velocity=(0, -0.05, 0))
        case = SmallCase(
            tmp_path/name, (plate, block), 4, preset=DEFAULT,
            control={"maxCo": 0.9},
            interfaces={"hit": interface(("plate", "top"), ("block", "bottom"),
                                         pairing="nearestFace")})
        if before:
            stretch(case, plate, np.diag(1/A))
        e[name] = case.run().energies
    first = e["after"]["total:kinetic"][0]
    with figures("a plate meshed before and after a stretch, in contact") as f:
        f.within("largest strain energy, before / after",
                 e["before"]["total:strain"].max()
                 / e["after"]["total:strain"].max(), 1, 0.02)
        for name, its in e.items():
            f.atMost(f"{name}: work of contact / energy",
                     its["total:contactWork"].max()/first, 1e-3)
            f.atLeast(f"{name}: the same at the end",
                      its["total:contactWork"][-1]/first, -0.05)
