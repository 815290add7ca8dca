"""Slow loading: mass scaling, damping, and relaxation, compared with theory
and static solutions."""

import re

import numpy as np
import pytest

from vertexContactTests.caseTools import (DEFAULT, checked, differingFiles,
                                          execute, rankFolders, runAgain,
                                          timeFolders)
from vertexContactTests.smallCases import (ELASTIC, RUBBER, Body, SmallCase,
                                           condition, interface, largest,
                                           polar, table)

HELD = condition("fixedVelocity", velocity=(0, 0, 0))
MIRROR = condition("symmetryPlane")


def make(folder, bodies, endTime, **control):
    more = {k: control.pop(k) for k in ("gravity", "interfaces", "probes",
                                        "functions") if k in control}
    return SmallCase(folder, bodies, endTime, preset=DEFAULT, control={
        "maxCo": 0.9, "timePrecision": 12, **control}, **more)


def finished(case, ranks=1):
    code, case.output = case.attempt(ranks)
    assert code == 0, case.output[-3000:]
    return case


def relaxing(tolerance=1e-3, **more):
    return {"type": "kinetic", "tolerance": tolerance, **more}


def ending(case):
    """The final residual and the number of peaks of a run."""
    found = re.search(r"Relaxation: residual (\S+) after (\d+) peaks, below",
                      case.output)
    assert found, case.output[-2000:]
    return float(found[1]), int(found[2])


# Scaled masses

@pytest.mark.parametrize("cells", ((20,), (8, 6), (5, 4, 3)),
                         ids=("1D", "2D", "3D"))
@pytest.mark.parametrize("nu", (0.3, 0.49))
def test_target_step(tmp_path, figures, cells, nu):
    """The stable step equals the given step. No more mass is added than this
    needs, and none if the step is stable already."""
    def stable(name, **control):
        body = Body(cells=cells, material={**RUBBER, "nu": nu})
        case = make(tmp_path/name, body, 10, **control)
        output = checked(["vertexContactFoam", "-dry-run"], case.path)
        factor = re.search(r"as if it had (\S+) times", output)
        return (float(re.search(r"stable step is (\S+) s", output)[1]),
                factor and float(factor[1]))

    own, _ = stable("own")
    step, factor = stable("scaled", massScaling={
        '"bo.*"': {"step": 2.5*own, "force": "yes"}})
    same, one = stable("enough", massScaling={"body": {"step": 0.5*own}})
    with figures(f"mass scaling by the step, {len(cells)}D, nu {nu}") as f:
        f.within("stable step / target", step/(2.5*own), 1, 1e-3)
        f.within("factor of the mass", factor, 2.5**2, 0.02)
        f.equal("where it is stable already", (same, one), (own, 1.0))


@pytest.mark.parametrize("preset", (DEFAULT, "paper"))
def test_weight(tmp_path, figures, preset):
    """Bodies with scaled mass fall more slowly under the same weight."""
    g, factor, time = 0.3, 9, 2.0
    body = Body(cells=(4, 4), velocity=(0.1, 0, 0))
    case = finished(make(
        tmp_path/"case", body, time, gravity=(0, -g, 0),
        massScaling={"body": {"factor": factor, "force": "yes"}}
    ) if preset == DEFAULT else SmallCase(
        tmp_path/"case", body, time, gravity=(0, -g, 0), control={
            "massScaling": {"body": {"factor": factor, "force": "yes"}}}))
    t = case.momentum["Time"]
    if preset == DEFAULT:
        t = t - np.diff(t, prepend=0)/2
    p = case.momentumOf("body")
    U = case.at("pointU")
    with figures(f"weight of a scaled mass, {preset}") as f:
        f.atMost("momentum by weight and time, largest error",
                 largest(p[:, 1] + g*t)/g, 1e-12)
        f.atMost("velocity", largest(U - (0.1, -g*time/factor, 0)), 1e-12)
        f.within("initial momentum / true mass", p[0, 0]/0.1, factor, 1e-9)
        f.equal("log says the added mass", "8 kg added, 800 % of its own, 800 "
                "% of all" in case.output, True)


def test_another_factor(tmp_path, figures):
    """A restarted run with another factor keeps its velocities."""
    body = Body(cells=(4, 4), velocity=(0.1, 0.2, 0))
    case = finished(make(tmp_path/"case", body, 1, massScaling={
        "body": {"factor": 4, "force": "yes"}}))
    case.set("system/controlDict", {"endTime": 2})
    case.replace("system/controlDict", r"factor 4;", "factor 2;")
    finished(case)
    with figures("restart with another factor") as f:
        f.atMost("velocity", largest(case.at("pointU") - (0.1, 0.2, 0)), 1e-13)


def test_scaled_contact(tmp_path, figures):
    """Impact of two equal bars. One has nine times its mass, by scaling or by
    its density: the results are equal to round-off."""
    def bars(name, rho, **control):
        bodies = [Body(cells=(20,), name=n, start=(x, 0, 0),
                       material={**ELASTIC, "rho": r}, velocity=(v, 0, 0),
                       sides={side: "contact"})
                  for n, x, r, v, side in (("a", 0, 1, 0.01, "right"),
                                           ("b", 1, rho, -0.01, "left"))]
        return finished(make(
            tmp_path/name, bodies, 3, interfaces={
                "bars": interface(("a", "right"), ("b", "left"))}, **control))

    one = bars("density", 9)
    own = bars("scaled", 1, massScaling={"b": {"factor": 9, "force": "yes"}})
    with figures("impact on a scaled mass, against the density") as f:
        for key in "total:kinetic", "total:strain", "b:contactWork":
            f.atMost(key, largest(one.energies[key] - own.energies[key])
                     / one.energies["total:kinetic"][0], 1e-12)


def test_scaled_energies(tmp_path, figures):
    """A block with scaled mass falls on a held block, with one step for both.
    The balance of all energies is that of the scaled mass. With the true mass
    almost all of the kinetic energy would be missing."""
    g, factor = 0.02, 9
    block = Body(cells=(6, 5), name="block", start=(0, 1.02, 0),
                 velocity=(0, -0.05, 0), sides={"bottom": "contact"})
    base = Body(cells=(5, 4), name="base", start=(-0.2, 0, 0),
                size=(1.4, 1, 1), sides={"top": "contact", "bottom": HELD})
    case = finished(make(
        tmp_path/"case", [block, base], 4, gravity=(0, -g, 0),
        interfaces={"c": interface(("block", "bottom"), ("base", "top"),
                                   pairing="nearestFace")},
        massScaling={"block": {"factor": factor, "force": "yes"}}))
    e = case.energies
    kinetic = factor*0.05**2/2
    with figures("block of scaled mass falls on another one") as f:
        f.within("initial kinetic energy / that of the scaled mass",
                 e["block:kinetic"][0]/kinetic, 1, 1e-9)
        f.atMost("balance / initial kinetic energy",
                 largest(e["total:balance"])/kinetic, 1e-3)
        f.atLeast("energy in the base / initial kinetic energy", (
            e["base:kinetic"] + e["base:strain"]).max()/kinetic, 0.2)
        f.atLeast("work of the weight / initial kinetic energy",
                  largest(e["total:externalWork"])/kinetic, 0.1)
        f.atLeast("range of the kinetic energy of the block / initial",
                  np.ptp(e["block:kinetic"])/kinetic, 0.5)


# Damping

def test_free_decay(tmp_path, figures):
    """The motion decays by exp(-c t), exactly for any step, and the energy
    balances."""
    c, time = 3.0, 2.0
    body = Body(cells=(3, 3), velocity=(0.1, 0.2, 0))
    case = finished(make(tmp_path/"case", body, time, damping={
        "body": {"coefficient": c}}))
    e = case.energies
    t = case.momentum["Time"]
    t = t - np.diff(t, prepend=0)/2
    p = case.momentumOf("body")[:, 0]
    with figures("damped free motion") as f:
        f.atMost("momentum, largest error", largest(p - 0.1*np.exp(-c*t)),
                 1e-14)
        f.atMost("velocity at the end", largest(
            case.at("pointU")/np.exp(-c*time) - (0.1, 0.2, 0)), 1e-12)
        f.atMost("balance / energy",
                 largest(e["body:balance"])/e["body:kinetic"][0], 1e-13)
        f.within("taken / energy", e["body:dampingDissipation"][-1]
                 / e["body:kinetic"][0], 1 - np.exp(-2*c*time), 1e-10)


def test_function_of_time(tmp_path, figures):
    """The damping of one region grows with time; another region has none. The
    error has second order."""
    errors = []
    for n in 8, 16, 32:
        bodies = [Body(cells=(3,), name=name, start=(x, 0, 0),
                       velocity=(0.1, 0, 0))
                  for name, x in (("pad1", 0), ("block", 5))]
        case = finished(make(
            tmp_path/f"{n}", bodies, 1, adjustTimeStep="no", deltaT=1/n,
            damping={'"pad.*"': {"coefficient": "polynomial ((6 2))"}}))
        errors.append(largest(case.at("pointU", region="pad1")[:, 0]
                              - 0.1*np.exp(-2)))
        free = case.at("pointU", region="block")
    with figures("coefficient that grows with time") as f:
        f.falling("error of the velocity, 8 to 32 steps", errors)
        f.atLeast("order", np.log2(errors[1]/errors[2]), 1.8)
        f.equal("what is not damped", largest(free - (0.1, 0, 0)), 0.0)


def test_damped_vibration(tmp_path, figures):
    """The first mode of a bar that is held at its end: frequency and decay.
    The balance is as good as without damping."""
    c, n, time = 0.4, 40, 4.0
    w = np.pi/2

    def bar(name, **control):
        body = Body(cells=(n,), material=ELASTIC, sides={"left": HELD},
                    scheme={"dissipation": 0.01, "frontDissipation": 0.01},
                    velocity=lambda X: 1e-3*np.sin(w*X[:, :1])*(1, 0, 0))
        return finished(make(tmp_path/name, body, time,
                             probes={"tip": ("body", (1, 0.5, 0.5))},
                             **control))

    case = bar("damped", damping={"body": {"coefficient": c}})
    free = bar("free")
    t, u = case.probe("tip", "pointD")
    u = u[:, 0]
    wd = np.sqrt(w**2 - c**2/4)
    exact = 1e-3/wd*np.exp(-c*t/2)*np.sin(wd*t)
    balance = [largest(k.energies["body:balance"])
               / k.energies["body:kinetic"][0] for k in (case, free)]
    with figures("damped vibration of a bar") as f:
        f.atMost("displacement / largest", largest(u - exact)/largest(exact),
                 3e-3)
        f.atMost("balance, with damping", balance[0], 1e-3)
        f.atMost("balance, with damping / without", balance[0]/balance[1], 1.5)


def test_damped_supports(tmp_path, figures):
    """Nodes with a prescribed motion, complete or along a direction, are not
    damped: they move the body, and the reaction has its drag."""
    c, v = 0.5, 0.01
    body = Body(cells=(6, 4), material=ELASTIC, size=(1, 0.5, 1), sides={
        "left": condition("fixedVelocity", velocity=(v, 0, 0)),
        "right": condition("fixedVelocity", velocity=(v, 0, 0),
                           components="(x)")}, velocity=(v, 0, 0))
    case = finished(make(tmp_path/"case", body, 40, functions=(
        "reactionForces",), damping={"body": {"coefficient": c}}))
    e = case.energies
    U = case.at("pointU")
    ends = np.isclose(case.X()[:, 0], 0) | np.isclose(case.X()[:, 0], 1)
    work = e["body:externalWork"][-1]
    taken = e["body:dampingDissipation"][-1]
    with figures("a damped block that is drawn") as f:
        f.atMost("velocity of what is held", largest(U[ends, 0] - v)/v, 1e-12)
        f.atMost("balance / work", largest(e["body:balance"])/work, 1e-3)
        f.within("taken by damping / work", taken/work, 1, 0.05)


@pytest.mark.parametrize("own", ("no", "yes"))
def test_damped_contact(tmp_path, figures, own):
    """A plate falls on a column and comes to rest, with one step and with
    subCycling: the compression is exact."""
    g, c = 0.01, 2.0
    column = Body(cells=(10,), name="column", material=ELASTIC,
                  sides={"left": HELD, "right": "contact"})
    plate = Body(cells=(3,), name="plate", start=(1, 0, 0), size=(0.3, 1, 1),
                 material={**ELASTIC, "E": 100}, sides={"left": "contact"})
    case = finished(make(
        tmp_path/"case", (column, plate), 40, gravity=(-g, 0, 0),
        interfaces={"a": interface(("column", "right"), ("plate", "left"))},
        subCycling=own, damping={'".*"': {"coefficient": c}}))
    e = case.energies
    X = case.X("column")[:, 0]
    exact = -g*(X - X**2/2) - 0.3*g*X
    with figures(f"a plate comes to rest, subCycling {own}") as f:
        f.atMost("displacement of the column / largest", largest(
            case.at("pointD", region="column")[:, 0] - exact)/largest(exact),
            0.01)
        f.atMost("balance / work", abs(e["total:balance"][-1])
                 / e["total:externalWork"][-1], 0.02)


# Relaxation

def reportedPeriods(f, case, period, balance=None):
    """Record the end of a run. Its energy balance is at most 1e-5 of the
    strain energy, or as given."""
    residual, peaks = ending(case)
    e = case.energies
    energy = largest(e["total:strain"])
    f.atMost("residual", residual, 1e-3)
    f.atMost("periods of the lowest mode", e["Time"][-1]/period, 20)
    f.atLeast("peaks", peaks, 1)
    f.atMost("balance / strain energy", abs(e["total:balance"][-1])/energy,
             1e-5 if balance is None else balance/energy)
    f.atMost("kinetic energy at the end / the same",
             e["total:kinetic"][-1]/energy, 1e-20)


def test_sag(tmp_path, figures):
    """A block hangs from its top: u = rho g/E (L y - y^2/2)."""
    g = 0.01
    body = Body(cells=(6, 12), size=(0.5, 1, 1), material=ELASTIC,
                sides={"bottom": HELD})
    case = finished(make(tmp_path/"case", body, 1000, gravity=(0, -g, 0),
                         relaxation=relaxing()))
    y = case.X()[:, 1]
    exact = -g*(y - y**2/2)
    with figures("sag of a block") as f:
        f.atMost("displacement / largest", largest(
            case.at("pointD")[:, 1] - exact)/largest(exact), 0.01)
        f.equal("the run says that it ends", "The bodies are in balance" in
                case.output, True)
        reportedPeriods(f, case, 4)


def test_bent_beam(tmp_path, figures):
    """A cantilever under a shear force at its end, in plane stress: theory of
    beams with shear, and the static state of the same mesh."""
    height, force = 0.2, 2e-6
    sides = {"left": HELD, "right": condition(
        "traction", traction=(0, -force/height, 0))}

    def beam(name, tolerance):
        body = Body(cells=(40, 8), size=(1, height, 1), material=ELASTIC,
                    sides=sides)
        return finished(make(tmp_path/name, body, 10000,
                             relaxation=relaxing(tolerance)))

    case, statics = beam("case", 1e-3), beam("statics", 1e-7)
    u, exact = (c.at("pointD")[:, 1] for c in (case, statics))
    theory = -force*(1/(3*height**3/12) + 1.2/(0.5*height))
    period = 2*np.pi/(1.8751**2*np.sqrt(height**2/12))
    with figures("a bent beam") as f:
        f.atMost("deflection against its statics / largest",
                 largest(u - exact)/largest(exact), 0.01)
        f.within("deflection of the end / theory",
                 min(u)/theory, 1, 0.03)
        reportedPeriods(f, case, period)


def test_few_cells_over_a_beam(tmp_path, figures):
    """A cantilever of square cells is too stiff with few of them over its
    thickness, and converges."""
    height, force, nu = 0.1, 1e-8, 0.3
    stiffness = 1/(1 - nu**2)       # plane strain
    theory = force*(1/(3*stiffness*height**3/12)
                    + 1.2*2*(1 + nu)/height)
    ratio = {}
    for cells in (1, 2, 4, 8):
        body = Body(cells=(10*cells, cells), size=(1, height, 1),
                    material={**ELASTIC, "nu": nu}, sides={
                        "left": HELD, "right": condition(
                            "traction", traction=(0, force/height, 0))})
        case = finished(make(tmp_path/str(cells), body, 1000,
                             relaxation=relaxing(1e-4)))
        ratio[cells] = max(case.at("pointD")[:, 1])/theory
    with figures("deflection of a cantilever / theory") as f:
        for cells, expected in zip(ratio, (0.62, 0.86, 0.96, 0.99)):
            f.within(f"with {cells} cells over the thickness", ratio[cells],
                     expected, 0.01)


def rings(folder, interference=1e-3, relaxes=True, **control):
    """A quarter of two rings, one pressed onto the other."""
    a, b, c = 0.6, 0.8, 1.0
    sides = {"bottom": MIRROR, "top": MIRROR}
    bodies = [
        Body(cells=(6, 14), name="inner", start=(a, 0, 0), moved=polar,
             size=(b - a + interference, np.pi/2, 1),
             material={**ELASTIC, "nu": 0.3},
             sides={**sides, "right": "contact"}),
        Body(cells=(6, 14), name="outer", start=(b, 0, 0), moved=polar,
             size=(c - b, np.pi/2, 1), material={**ELASTIC, "nu": 0.3},
             sides={**sides, "left": "contact"})]
    return make(folder, bodies, control.pop("endTime", 100), interfaces={
        "fit": interface(("inner", "right"), ("outer", "left"),
                         pairing="nearestFace")},
        functions=("contactForces",),
        **({"relaxation": relaxing()} if relaxes else {}), **control)


def test_press_fit(tmp_path, figures):
    """Lame's pressure between two rings, in plane strain."""
    delta = 1e-3
    a, b, c = 0.6, 0.8, 1.0
    E, nu = 1/(1 - 0.3**2), 0.3/0.7
    outer = b/E*((c**2 + b**2)/(c**2 - b**2) + nu)
    inner = b/E*((b**2 + a**2)/(b**2 - a**2) - nu)
    pressure = delta/(outer + inner)
    case = finished(rings(tmp_path/"case", delta))

    # Bodies that start inside each other are pushed apart within a few steps,
    # with the shortest waves: the balance closes to a tenth, with relaxation
    # or without
    free = finished(rings(tmp_path/"free", delta, False, endTime=1))
    moved = case.at("pointD", region="outer")
    X = case.X("outer")
    r = np.hypot(X[:, 0], X[:, 1])
    at = np.isclose(r, b)
    radial = np.sum(moved*X, axis=1)[at]/r[at]
    outward = (moved*X).sum(axis=1)[np.isclose(r, c)]/c
    with figures("press-fit of two rings") as f:
        f.atMost("growth of the bore / theory, largest error",
                 largest(radial/(pressure*outer) - 1), 0.01)
        f.atMost("of the outer surface", largest(
            outward/(2*pressure*b**2*c/(E*(c**2 - b**2))) - 1), 0.01)
        # The slowest mode of a quarter of a ring: oval
        h, R = c - a, 0.5*(a + c)
        oval = 6/np.sqrt(5)*np.sqrt(E*h**2/12)/R**2
        reportedPeriods(f, case, 2*np.pi/oval,
                        2*largest(free.energies["total:balance"]))


def test_ramp(tmp_path, figures):
    """The run does not end while a prescribed motion goes on. Relaxation
    begins at the given start time."""
    body = Body(cells=(10,), material=ELASTIC, sides={
        "left": HELD, "right": condition(
            "fixedDisplacement", displacement=table(
                (0, (0, 0, 0)), (6, (0.01, 0, 0)), (1000, (0.01, 0, 0))))})
    for start in 0, 8:
        case = finished(make(tmp_path/f"{start}", body, 100,
                             relaxation=relaxing(start=start)))
        e = case.energies
        end = e["Time"][-1]
        early = e["Time"] <= start
        with figures(f"a bar that is drawn until 6 s, start {start} s") as f:
            f.atLeast("end of the run", end, 6)
            f.atMost("end of the run", end, 40)
            f.atMost("taken before the start",
                     largest(e["total:relaxationDissipation"][early]), 0)
            f.atMost("displacement / largest", largest(
                case.at("pointD")[:, 0] - 0.01*case.X()[:, 0])/0.01, 2e-3)


def test_rigid_weight(tmp_path, figures):
    """A rigid weight on a column comes to rest and is included in the
    residual."""
    g, mass = 0.01, 0.5
    column = Body(cells=(6, 6), name="column", material=ELASTIC, sides={
        "bottom": HELD, "top": "contact", "left": MIRROR, "right": MIRROR})
    weight = Body(cells=(6, 2), name="weight", start=(0, 1, 0),
                  size=(1, 0.2, 1), sides={"bottom": "contact"}, material={
                      "type": "rigid", "mass": mass, "freeTranslation": "(y)",
                      "freeRotation": "()"})
    case = finished(make(
        tmp_path/"case", (column, weight), 500, gravity=(0, -g, 0),
        interfaces={"a": interface(("column", "top"), ("weight", "bottom"))},
        relaxation=relaxing()))
    residual, _ = ending(case)
    y = case.X("column")[:, 1]
    exact = -g*(y - y**2/2) - mass*g*y
    with figures("a rigid weight on a column") as f:
        f.atMost("residual", residual, 1e-3)
        f.atMost("displacement / largest", largest(
            case.at("pointD", region="column")[:, 1] - exact)/largest(exact),
            0.01)


# Restart and list of keywords

def everything(folder, **more):
    return rings(folder, 2e-3, damping={"inner": {"coefficient": 0.2}},
                 massScaling={"outer": {"step": 0.03, "force": "yes"}},
                 writeInterval=1, **more)


@pytest.mark.parametrize("ranks", (1, 2))
def test_restart(tmp_path, figures, ranks):
    """A restarted run is equal bit by bit, with scaled mass, damping,
    relaxation and contact."""
    case = everything(tmp_path/"case")

    def look(case, output):
        times = timeFolders(case/rankFolders(ranks)[0])
        assert len(times) > 4
        return (times[-1], case.energies,
                re.search(r"Relaxation: residual .*", output)[0])

    (expected, first), (found, second) = runAgain(case, ranks, look)
    (end, energies, said), (endAgain, e, saidAgain) = first, second
    with figures(f"slow loading, {ranks} ranks: restart") as f:
        f.equal("last time", endAgain, end)
        f.equal("files that differ", differingFiles(expected, found), [])
        f.equal("what the log ends with", saidAgain, said)
        f.atLeast("files compared", len(expected[0]), 8)
        f.atMost("largest difference of the last energies / largest", max(
            abs(energies[key][-1] - e[key][-1]) for key in energies)
            / max(energies["total:strain"]), 0 if ranks == 1 else 1e-13)


def test_ranks(tmp_path, figures):
    one = finished(everything(tmp_path/"one"))
    two = finished(everything(tmp_path/"two"), 2)
    checked(["reconstructPar", "-allRegions", "-latestTime"], two.path)
    with figures("slow loading, 2 ranks against 1") as f:
        f.equal("peaks", ending(two)[1], ending(one)[1])
        for region in "inner", "outer":
            a, b = (c.at("pointD", region=region) for c in (one, two))
            f.atMost(f"{region} pointD, largest difference / largest",
                     largest(a - b)/largest(a), 1e-9)


def test_list(tmp_path):
    """-listControls has all keywords, with units and meanings."""
    output = execute(["vertexContactFoam", "-listControls"], tmp_path).stdout
    for word in ("preset", "subCycling", "massScaling", "relaxation",
                 "massScaling/<region>/factor", "damping/<region>/coefficient",
                 "relaxation/tolerance"):
        assert re.search(rf"(?m)^    {word} .*\S  +\S", output), word
