"""Runs that do not start at rest and free of stress: stress by the field CpInv
of the start time, contact that this stress presses, earlier plastic flow, a
temperature, and the last time of another run. F0 is tested in
test_initial_stretch.py."""

import shutil

import numpy as np
import pytest

from vertexContactTests.caseTools import (DEFAULT, checked, contents,
                                          differingFiles)
from vertexContactTests.smallCases import (Body, SmallCase, condition,
                                           interface, largest)

E, NU, RHO = 1.0, 0.3, 1.0
MU = E/(2*(1 + NU))
KAPPA = E/(3*(1 - 2*NU))
SPEED = np.sqrt(E*(1 - NU)/((1 + NU)*(1 - 2*NU))/RHO)
ELASTIC = {"type": "HenckyVonMises", "rho": RHO, "E": E, "nu": NU,
           "tauY": 100.0}
LENGTH, HEIGHT = 1.0, 0.25
HELD = condition("fixedVelocity", velocity=(0, 0, 0))
MIRRORS = {"bottom": "symmetryPlane", "top": "symmetryPlane"}


def stress(stretch):
    """Stress along a bar with this stretch at constant volume."""
    return 2*MU*np.log(stretch)


def block(name="body", start=0.0, cells=16, material=ELASTIC, **sides):
    return Body(cells=(cells, 4), name=name, start=(start, 0, 0),
                size=(LENGTH, HEIGHT, 1), material=material,
                sides={**MIRRORS, "left": HELD, **sides})


def stretched(case, body, stretch):
    """Give a body the initial stretch by CpInv = F0 F0^T, as if it had been
    longer by this stretch before it was meshed."""
    F0 = (stretch**2, 0, 0, stretch**-2, 0, 1)      # xx xy xz yy yz zz
    X = case.points(body.name)
    case.writePointField(body, "CpInv", "[0 0 0 0 0 0 0]",
                         np.tile(F0, (len(X), 1)), "symmTensor")


def residual(case):
    """Largest residual of the energy balance, relative to the initial energy.
    The leapfrog conserves the energy to second order of the step."""
    return largest(case.energies["total:balance"]
                   / case.energies["total:strain"][0])


def bar(folder, stretch, right, endTime, **control):
    body = block(right=right)
    case = SmallCase(folder, body, endTime, preset=DEFAULT, control=control)
    stretched(case, body, stretch)
    return case


@pytest.mark.parametrize("stretch", (1.3, 0.8))
def test_held_bar_is_at_rest(tmp_path, figures, stretch):
    """A bar under tensile or compressive stress, held at both ends, stays at
    rest."""
    case = bar(tmp_path, stretch, HELD, 5.0).run()
    sigma = case.at("sigma")
    energies = case.energies
    strain = 2*MU*np.log(stretch)**2*LENGTH*HEIGHT
    with figures(f"held bar, stretch {stretch}") as f:
        f.atMost("velocity / speed of waves", largest(case.at("pointU"))/SPEED,
                 1e-14)
        f.atMost("stress along it less the closed form / that",
                 largest(sigma[:, 0] - stress(stretch))/abs(stress(stretch)),
                 1e-14)
        f.atMost("strain energy less the closed form / that",
                 largest(energies["total:strain"] - strain)/strain, 1e-13)
        f.atMost("balance / strain energy",
                 largest(energies["total:balance"])/strain, 1e-13)


def test_expression(tmp_path, figures):
    """An expression sets CpInv, as in the guide for F0. The initial stress is
    that of a stretch that varies along the bar."""
    case = bar(tmp_path, 1.0, HELD, 1e-9)
    case.write("system/body/setExprFieldsDict", "dictionary", """
expressions
(
    stretch
    {
        field CpInv;
        keepPatches yes;
        variables ("s = point(1) + point(0.2)*sin(point(3)*pts().x())");
        expression
        #{
            symmTensor
            (
                s*s, point(0), point(0), point(1)/(s*s), point(0), point(1)
            )
        #};
    }
);
""")
    checked(["setExprFields", "-region", "body"], case.path)
    case.run()
    expected = stress(1 + 0.2*np.sin(3*case.X()[:, 0]))
    sigma = case.at("sigma")
    with figures("CpInv by an expression") as f:
        f.atMost("stress along the bar less the closed form / largest",
                 largest(sigma[:, 0] - expected)/largest(expected), 1e-8)
        f.atMost("stress across it plus the closed form / largest",
                 largest(sigma[:, 3] + expected)/largest(expected), 1e-8)


def test_released_bar(tmp_path, figures):
    """One end is free: the bar springs back with the wave of the closed form,
    which has passed half of the bar here."""
    stretch = 1 + 1e-5
    time = 0.5*LENGTH/SPEED
    case, finer = (
        bar(tmp_path/name, stretch, "tractionFree", time, maxCo=maxCo).run()
        for name, maxCo in (("case", 0.3), ("finer", 0.15)))
    U = case.at("pointU")[:, 0]
    X = case.X()[:, 0]
    v = stress(stretch)/(RHO*SPEED)
    energies = case.energies
    with figures("released bar, 16 cells") as f:
        f.within("velocity of its free end / closed form",
                 U[X > LENGTH*(1 - 1e-6)].mean()/-v, 1, 0.02)
        f.atMost("velocity at its held end / closed form of the free one",
                 largest(U[X < 0.1*LENGTH])/v, 0.01)
        # rho v^2/2 where the wave has passed
        f.within("kinetic energy / closed form", energies["total:kinetic"][-1]
                 / (0.5*RHO*v**2*SPEED*time*HEIGHT), 1, 0.05)
        f.atMost("balance / strain energy at first", residual(case), 5e-4)
        f.within("the same / with half the step, second order",
                 residual(case)/residual(finer), 4, 0.5)


def test_ranks_and_restart(tmp_path, figures):
    """Two ranks differ by round-off. A restarted run is equal to the last
    bit."""
    release = (1.2, "tractionFree", 2.0)
    one = bar(tmp_path/"one", *release, writeInterval=1.0).run()
    two = bar(tmp_path/"two", *release, writeInterval=1.0).runParallel(2)
    expected = [contents(one/"2")]
    shutil.copytree(one.path, tmp_path/"again")
    shutil.rmtree(tmp_path/"again"/"2")
    checked(["vertexContactFoam"], tmp_path/"again")
    a, b = (c.energies["total:kinetic"][-1] for c in (one, two))
    with figures("released bar, ranks and restart") as f:
        f.atMost("kinetic energy, two ranks / one", abs(b/a - 1), 1e-10)
        f.equal("files that differ after a restart", differingFiles(
            expected, [contents(tmp_path/"again"/"2")]), [])


def test_pressed_blocks_are_at_rest(tmp_path, figures):
    """Two blocks with coincident surfaces, which press each other."""
    stretch = 0.9
    bodies = (block("left", right="contact"),
              block("right", LENGTH, left="contact", right=HELD))
    case = SmallCase(
        tmp_path, bodies, 5.0, preset=DEFAULT, functions=("contactForces",),
        interfaces={"between": interface(("left", "right"), ("right", "left"))})
    for body in bodies:
        stretched(case, body, stretch)
    case.run()
    U = [largest(case.at("pointU", region=b.name)) for b in bodies]
    sigma = np.concatenate([case.at("sigma", region=b.name)[:, 0]
                            for b in bodies])
    area = case.contact("between")["area"]
    with figures("blocks that press each other from the start") as f:
        f.atMost("velocity / speed of waves", max(U)/SPEED, 1e-13)
        f.atMost("stress less the closed form / that",
                 largest(sigma/stress(stretch) - 1), 1e-12)
        f.within("least area of contact / all", area.min()/HEIGHT, 1, 1e-12)


METAL = {"type": "HenckyVonMises", "rho": RHO, "E": E, "nu": NU,
         "tauY": 0.02, "Hardening": 0.1}
PULLED = condition("fixedVelocity", velocity=(0.05, 0, 0), components=("x",))


def pulled(folder, endTime, right=PULLED, **control):
    return SmallCase(folder, block(right=right, material=METAL), endTime,
                     preset=DEFAULT, control=control)


def test_earlier_flow(tmp_path, figures):
    """A metal with earlier plastic flow (epsilonPEq at the start) is equal to
    a metal with the hardened yield stress."""
    before, right = 0.2, PULLED
    runs = {}
    for name in "flowed", "harder":
        flowed = name == "flowed"
        tauY = METAL["tauY"] + (0 if flowed else before*METAL["Hardening"])
        body = block(right=right, material={**METAL, "tauY": tauY})
        runs[name] = SmallCase(tmp_path/name, body, 2.0, preset=DEFAULT)
        if flowed:
            n = len(runs[name].points("body"))
            runs[name].writePointField(
                body, "epsilonPEq", "[0 0 0 0 0 0 0]",
                np.full((n, 1), before), "scalar")
        runs[name].run()
    flowed, harder = runs["flowed"], runs["harder"]
    new = harder.at("epsilonPEq")
    with figures("epsilonPEq at the start") as f:
        f.atLeast("new flow, largest", new.max(), 1e-3)
        f.atMost("equivalent plastic strain less the earlier and the new",
                 largest(flowed.at("epsilonPEq") - before - new), 1e-13)
        f.atMost("stress, of flowed less that of harder / yield stress",
                 largest(flowed.at("sigma") - harder.at("sigma"))
                 / METAL["tauY"], 1e-11)
        f.atMost("von Mises stress / yield stress, largest", np.max(
            flowed.at("sigmaEq")/(METAL["tauY"] + METAL["Hardening"]
                                  * flowed.at("epsilonPEq"))), 1 + 1e-12)


def test_initial_temperature(tmp_path, figures):
    """pointT at the start replaces T0, to the last bit, and hot metal yields
    earlier."""
    hot = 800
    heat = {"cp": 1e-4, "beta": 0.9}

    def metal(T0):
        return {"type": "HenckyVonMises", "rho": RHO, "E": E, "nu": NU,
                "JohnsonCook": {"A": 0.02, "B": 0.1, "n": 1, "C": 0, "m": 1,
                                "Tmelt": 1300, "Troom": 293},
                "adiabaticHeating": {**heat, "T0": T0}}
    runs = {}
    for name, T0 in (("cold", 293), ("field", 293), ("keyword", hot)):
        body = block(right=PULLED, material=metal(T0))
        case = SmallCase(tmp_path/name, body, 1.5, preset=DEFAULT)
        if name == "field":
            n = len(case.points("body"))
            case.writePointField(body, "pointT", "[0 0 0 1 0 0 0]",
                                 np.full((n, 1), hot), "scalar")
        runs[name] = case.run()
    end = runs["field"].last
    with figures("pointT at the start") as f:
        f.equal("files that differ from those of T0", differingFiles(
            [contents(runs["keyword"]/end)], [contents(runs["field"]/end)]), [])
        f.atLeast("temperature, least", runs["field"].at("pointT").min(), hot)
        f.atLeast("heat by the flow, largest [K]",
                  runs["field"].at("pointT").max() - hot, 1)
        f.atMost("von Mises stress, largest, hot / cold",
                 runs["field"].at("sigmaEq").max()
                 / runs["cold"].at("sigmaEq").max(), 0.8)


@pytest.mark.parametrize("what, CpInv, named", (
    ("volume", (1.1, 0, 0, 1, 0, 1), ("CpInv", "determinant", "F0")),
    ("sign", (-1, 0, 0, -1, 0, 1), ("CpInv", "positive definite")),
    ("yield", (1.2**2, 0, 0, 1.2**-2, 0, 1), (
        "CpInv", "yield stress", "at most 0.02 Pa", "epsilonPEq"))))
def test_states_that_none_can_have(tmp_path, what, CpInv, named):
    case = pulled(tmp_path/"case", 1.0)
    n = len(case.points("body"))
    case.writePointField(block(material=METAL, right=PULLED), "CpInv",
                         "[0 0 0 0 0 0 0]", np.tile(CpInv, (n, 1)),
                         "symmTensor")
    code, output = case.attempt()
    assert code != 0, output
    message = output[output.index("--> FOAM FATAL IO ERROR"):]
    for name in named:
        assert name in message, message


@pytest.mark.parametrize("with_", ("nothing", "displacement", "F0"))
def test_elastic_strain(tmp_path, figures, with_):
    """elasticStrain replaces CpInv, which the run computes from it for any
    deformation, and gives the volume. A displacement or F0 only says how the
    mesh lies to the stress-free state."""
    body = block(right=HELD, cells=6)
    body.sides = {side: "symmetryPlane" for side in MIRRORS}
    if with_ == "displacement":
        body.displacement = lambda X: 0.02*X*(1, 1, 0)
    case = SmallCase(tmp_path, body, 1e-3, preset=DEFAULT)
    n = len(case.points("body"))
    strain = (0.25, 0.05, 0, -0.15, 0, -0.1)        # xx xy xz yy yz zz
    added = 0.07*np.array((1, 0, 0, 1, 0, 1))
    case.writePointField(body, "elasticStrain", "[0 0 0 0 0 0 0]",
                         np.tile(strain + added, (n, 1)), "symmTensor")
    if with_ == "F0":
        case.writePointField(body, "F0", "[0 0 0 0 0 0 0]", np.tile(
            (0.97, 0.2, 0, 0, 1, 0, 0, 0, 1), (n, 1)), "tensor")
    case.run()
    trace = 3*0.07
    volume = np.exp(trace)
    q = 2*MU*np.sqrt(1.5*(0.25**2 + 0.15**2 + 0.1**2 + 2*0.05**2))/volume
    p = -KAPPA*trace/volume
    inside = case.X()[:, 0] == 0.5
    with figures(f"elastic strain, with {with_}") as f:
        f.atMost("stress of von Mises less the closed form, inside / that",
                 largest(case.at("sigmaEq")[inside] - q)/q, 1e-3)
        f.atMost("pressure less the closed form, inside / that",
                 largest(case.at("pressure")[inside]/p - 1), 1e-3)


def test_elastic_strain_that_has_no_place(tmp_path):
    """elasticStrain is refused together with CpInv, and with a law without
    plastic flow."""
    for name, material, fields in (
            ("both", ELASTIC, ("CpInv", "elasticStrain")),
            ("rubber", {"type": "neoHookean", "rho": 1, "E": 1, "nu": 0.3},
             ("elasticStrain",))):
        body = block(material=material)
        case = SmallCase(tmp_path/name, body, 1.0, preset=DEFAULT)
        n = len(case.points("body"))
        for field in fields:
            case.writePointField(
                body, field, "[0 0 0 0 0 0 0]", np.tile(
                    np.array((1, 0, 0, 1, 0, 1))*(field == "CpInv"), (n, 1)),
                "symmTensor")
        code, output = case.attempt()
        assert code != 0, output
        message = output[output.index("--> FOAM FATAL IO ERROR"):]
        for word in ("elasticStrain", *(
                ("CpInv",) if name == "both" else ("neoHookean", "F0"))):
            assert word in message, message


def test_beyond_yield_by_a_displacement(tmp_path, figures):
    """With a displacement, as mapState gives it, the stress beyond the yield
    stress flows in the first step."""
    body = block(material=METAL)
    body.displacement = lambda X: 0.1*X*(1, 0, 0)
    case = SmallCase(tmp_path, body, 0.01, preset=DEFAULT).run()
    with figures("a displacement beyond yield") as f:
        f.atLeast("plastic strain, least", case.at("epsilonPEq").min(), 0.01)
        f.atMost("von Mises stress / yield stress, largest", np.max(
            case.at("sigmaEq")/(METAL["tauY"] + METAL["Hardening"]
                                * case.at("epsilonPEq"))), 1 + 1e-12)


def takeOver(case, first, time):
    """Start a case with a time of another run on the same mesh: copy its
    folder, but keep the boundary conditions (pointU) of the case."""
    shutil.copytree(first/time, case/time)
    shutil.copy(case/"0"/"body"/"pointU", case/time/"body")


def test_last_time_of_another_run(tmp_path, figures):
    """A bar is pulled until it yields. A run that takes over from the middle
    time equals the rest of the run to the last bit. A run that releases the
    bar starts with the same state."""
    whole = pulled(tmp_path/"whole", 2.0, writeInterval=1.0).run()
    rest = pulled(tmp_path/"rest", 2.0, writeInterval=1.0)
    free = {"right": "tractionFree", "writeInterval": 1.0}
    let = pulled(tmp_path/"let", 2.0, **free)
    half = pulled(tmp_path/"half", 1.0, maxCo=0.15).run()
    finer = pulled(tmp_path/"finer", 2.0, **free, maxCo=0.15)
    for case, first in (rest, whole), (let, whole), (finer, half):
        takeOver(case, first, "1")
        case.run()
    energies = let.energies
    middle = np.abs(whole.energies["Time"] - 1).argmin()
    first = whole.energies["total:strain"][middle]
    with figures("from the last time of another run") as f:
        f.atLeast("plastic strain", whole.at("epsilonPEq").min(), 1e-3)
        f.equal("files that differ from those of the whole run", differingFiles(
            [contents(whole/"2")], [contents(rest/"2")]), [])
        f.within("strain energy at the start / of the other run",
                 energies["total:strain"][0]/first, 1, 1e-12)
        f.atMost("balance after letting go / strain energy", residual(let),
                 2e-3)
        f.atLeast("the same / with half the step, second order",
                  residual(let)/residual(finer), 3.3)
        f.atMost("strain energy after letting go / before",
                 energies["total:strain"].min()/first, 0.95)
