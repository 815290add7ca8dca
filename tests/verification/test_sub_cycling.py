"""subCycling: a soft and a stiff body with wave speeds of 1:20, compared with
the exact solution and with one step for both, and the properties that must not
change."""

import re
import shutil

import numpy as np
import pytest

from vertexContactTests.caseTools import (DEFAULT, checked, contents,
                                          differingFiles, rise, runAgain,
                                          timeFolders)
from vertexContactTests.contactScenes import boxOnBumper, released
from vertexContactTests.smallCases import (Body, SmallCase, condition, coulomb,
                                           interface, largest)

RATIO = 20          # ratio of the wave speeds
SPEED = 0.01
THICKNESS = 0.1     # of the stiff body
FLOOR = {"type": "plane", "planeType": "pointAndNormal",
         "pointAndNormalDict": {"point": (0, 0, 0), "normal": (0, 1, 0)}}


def elastic(E, kind="linearElastic", nu=0):
    return {"type": kind, "rho": 1, "E": E, "nu": nu}


def bars(folder, own, n=100, law="frictionless", endTime=0.6, **control):
    """A soft bar that hits a stiff one; the stiff bar has a tenth of the
    nodes."""
    soft = Body(cells=(n,), name="soft", material=elastic(1),
                velocity=(SPEED, 0, 0), sides={"right": "contact"})
    stiff = Body(cells=(n//10,), name="stiff", start=(1, 0, 0),
                 size=(THICKNESS, 1, 1), material=elastic(RATIO**2),
                 sides={"left": "contact"})
    case = SmallCase(
        folder, (soft, stiff), endTime,
        {"bars": interface(("soft", "right"), ("stiff", "left"), law)},
        preset=DEFAULT, functions=("contactForces",), control={
            "maxCo": 0.9, "timePrecision": 12,
            "subCycling": "yes" if own else "no", **control})
    return finished(case)


def finished(case):
    code, case.output = case.attempt()
    assert code == 0, case.output[-3000:]
    return case


def evaluations(case):
    """The number of node evaluations, and the number with one step."""
    found = re.search(r"so far (\S+) evaluations of nodes, \S+ of the (\S+) "
                      "that", case.output)
    return float(found[1]), float(found[2])


def impulse(t):
    """Exact impulse of the stiff bar. The pressure falls by the same factor
    each time that waves have travelled there and back in it."""
    z = RATIO
    q, back = (z - 1)/(z + 1), 2*THICKNESS/RATIO
    first = SPEED*z/(1 + z)
    turns = np.floor(np.maximum(t, 0)/back)
    return first*(back*(1 - q**turns)/(1 - q) + (t - turns*back)*q**turns)


def momentum(case):
    """Momentum of the stiff bar, which belongs to the middle of each step."""
    t = case.momentum["Time"]
    return t - np.diff(t, prepend=0)/2, case.momentumOf("stiff")[:, 0]


def test_impact_of_the_exact_solution(tmp_path, figures):
    errors, differences = [], []
    every = np.linspace(0.05, 0.59, 200)
    for n in 50, 100, 200:
        one, own = (bars(tmp_path/f"{n}{is_}", is_, n) for is_ in (False, True))
        t, p = momentum(own)
        errors.append(np.mean(abs(p - impulse(t)))/impulse(t[-1]))
        differences.append(max(abs(
            np.interp(every, t, p) - np.interp(every, *momentum(one))))
            / impulse(t[-1]))
    total = own.momentumOf()[:, 0]
    done, ofOne = evaluations(own)
    courant = [float(x) for x in re.findall(r"  Co (\S+)", own.output)]
    e, e1 = own.energies, one.energies
    start = e["total:kinetic"][0]
    with figures("bars 1:20, 50 to 200 cells") as f:
        f.falling("mean error of the impulse", errors)
        f.atMost("on the finest", errors[-1], 0.01)
        f.falling("largest difference from one step", differences)
        f.atMost("on the finest", differences[-1], 0.01)
        f.atMost("momentum, largest change",
                 max(abs(total - total[0]))/total[0], 1e-14)
        f.atLeast("evaluations of one step / own", ofOne/done, 5)
        f.within("largest Courant number of the log / maxCo",
                 max(courant)/0.9, 0.97, 0.03 + 1e-9)
        f.within("kinetic energy of the stiff bar / one step",
                 e["stiff:kinetic"][-1]/e1["stiff:kinetic"][-1], 1, 0.01)
        f.atMost("rise of the energy", rise(own.keptEnergy, start), 0.01)
        f.atMost("balance at the end", abs(e["total:balance"][-1])/start, 1e-3)


@pytest.mark.parametrize("law, change", (("tied", 0), ("frictionless", 0),
                                         ("frictionless", 2e-12)))
def test_sudden_load_for_long(tmp_path, figures, law, change):
    """A stiff plate on a soft column that is held below, 10^5 common steps
    after the weight was suddenly applied. Vibrations are hardly damped, and
    nothing may feed them energy. When contact believed to have taken more
    energy than it had, the plate bounced for ever, with some weights."""
    g, step = 0.01*(1 + change), 0.05
    soft = Body(cells=(10,), name="soft", material=elastic(1),
                sides={"left": condition("fixedVelocity", velocity=(0, 0, 0)),
                       "right": "contact"})
    stiff = Body(cells=(3,), name="stiff", start=(1, 0, 0), size=(0.3, 1, 1),
                 material=elastic(RATIO**2), sides={"left": "contact"})
    case = finished(SmallCase(
        tmp_path/"case", (soft, stiff), 1e5*step, gravity=(-g, 0, 0),
        interfaces={"bars": interface(("soft", "right"), ("stiff", "left"),
                                      law)},
        preset=DEFAULT, functions=("contactForces",), control={
            "adjustTimeStep": "no", "deltaT": step, "subCycling": "yes",
            "maxCo": 0.9, "logInterval": 1000000}))
    e = case.energies
    own = e["total:kinetic"] + e["total:strain"] - e["total:externalWork"]
    half = len(own)//2
    weight = g*0.3
    carried = weight + g*(1 - np.linspace(0.05, 0.95, 10))
    strain = 0.5*np.mean(carried**2)
    least = np.minimum.accumulate(own)
    force = -case.contact("bars")["soft.right:Fx"][half:]
    work = e["total:contactWork"]
    record = (case/case.last/"uniform"/"solidSystem").read_text()
    taken, given = (
        sum(float(x) for x in re.findall(rf"\b{name}\s+(\S+);", record))
        for name in ("taken", "contactWork"))
    with figures(f"plate on a column, {law}, 1e5 common steps") as f:
        f.atLeast("short steps in a common one", float(re.search(
            r"now: soft 1 stiff (\d+)", case.output)[1]), 10)
        # The energies of the bodies belong to different instants
        f.atMost("rise of energy less works / strain energy at rest",
                 max(own - least)/strain, 0.1)
        f.atMost("energy less works, second half / strain energy at rest",
                 max(own[half:])/strain, -0.8)
        f.atMost("work of contact in the second half / strain energy",
                 (work[-1] - work[half])/strain, 0)
        f.atMost("energy that contact believes to have taken, error",
                 abs(taken + given)/strain, 1e-9)
        f.within("force, mean of the second half / weight",
                 np.mean(force)/weight, 1, 0.01)
        f.atMost("scatter of the force at the end / weight",
                 np.std(force[-len(force)//4:])/weight, 0.2)
        f.atMost("balance at the end / strain energy",
                 abs(e["total:balance"][-1])/strain, 0.01)


@pytest.mark.parametrize("speeds", (1.5, 2, 3, 4))
def test_tied_bars_do_not_feed_each_other(tmp_path, figures, speeds):
    """Tied pairs of bars of 1, 3 and 10 cells move with all waves of the
    meshes, with the longest steps. Nothing grows, not even if a bar has one
    cell, whose waves nothing damps."""
    random = np.random.default_rng(1)

    def shaken(X):
        return SPEED*random.standard_normal((len(X), 1))*np.array((1, 0, 0))

    grown = {}
    for n in 1, 3, 10:
        for m in 1, 3, 10:
            for maxCo in 0.7, 0.95:
                soft = Body(cells=(n,), name="soft", material=elastic(1),
                            velocity=shaken, sides={"right": "contact"})
                stiff = Body(cells=(m,), name="stiff", start=(1, 0, 0),
                             size=(m/n, 1, 1), material=elastic(speeds**2),
                             velocity=shaken, sides={"left": "contact"})
                case = finished(SmallCase(
                    tmp_path/f"{n}{m}{maxCo}", (soft, stiff), 400/n, {
                        "bars": interface(("soft", "right"), ("stiff", "left"),
                                          "tied")}, preset=DEFAULT, control={
                        "maxCo": maxCo, "subCycling": "yes",
                        "logInterval": 1000000}))
                E = case.energies["total:kinetic"]
                E = E + case.energies["total:strain"]
                k = len(E)//4
                grown[n, m, maxCo] = max(E[3*k:])/max(E[k:2*k])
    with figures(f"tied bars, speeds of waves 1:{speeds}") as f:
        f.atMost("largest growth of the energy, 18 pairs, some 400 steps",
                 max(grown.values()), 1.01)


def turning(folder, E=100, pairing="AMI", time=63, **control):
    """A soft body rotates with a stiff body that is tied to it; one turn takes
    63."""
    def spin(X):
        return 0.1*np.cross((0, 0, 1), X - (0.5, 0.6, 0))

    soft = Body(cells=(6, 6), name="soft", velocity=spin,
                material=elastic(1, "neoHookean", 0.3),
                sides={"top": "contact"})
    stiff = Body(cells=(3, 2), name="stiff", start=(0.3, 1, 0),
                 size=(0.4, 0.2, 1), velocity=spin,
                 material=elastic(E, "neoHookean", 0.3),
                 sides={"bottom": "contact"})
    return finished(SmallCase(
        folder, (stiff, soft), time, {
            "bond": interface(("stiff", "bottom"), ("soft", "top"), "tied",
                              pairing=pairing)},
        preset=DEFAULT, functions=("contactForces",), control={
            "subCycling": "yes", "maxCo": 0.9, **control}))


@pytest.mark.parametrize("pairing", ("nearestFace", "AMI"))
@pytest.mark.parametrize("E, most", ((4, 64), (100, 64), (100, 2)))
def test_tied_bodies_that_turn(tmp_path, figures, E, most, pairing):
    """The tie adds no energy and holds the bodies together."""
    case = turning(tmp_path/"case", E, pairing, maxSubCycles=most)
    e = case.energies
    own = e["total:kinetic"] + e["total:strain"]
    top, bottom = (
        np.mean((X + case.at("pointD", region=name))[
            np.abs(X[:, 1] - 1) < 1e-9], axis=0)
        for name, X in ((name, case.X(name)) for name in ("soft", "stiff")))
    with figures(f"turn, tied, 1:{E}, at most {most} steps, {pairing}") as f:
        f.atMost("rise of the energy / initial", rise(own), 0.003)
        f.within("energy left / initial", own[-1]/own[0], 1, 0.005)
        f.atMost("middle of the bond from the other side / cell",
                 6*np.linalg.norm(top - bottom), 0.1)


def test_angular_momentum(tmp_path, figures):
    """A force on the body with the longer step acts at the position in the
    middle of its step. So its moment is exact to first order in the step."""
    drifts = []
    for maxCo in 0.9, 0.45:
        L = turning(tmp_path/f"{maxCo}", time=20,
                    maxCo=maxCo).angularMomentumOf()[:, 2]
        drifts.append(max(abs(L/L[0] - 1)))
    with figures("turn, tied, angular momentum, a third of a turn") as f:
        f.atMost("drift", drifts[0], 2e-4)
        f.atMost("with half of the step / with the whole",
                 drifts[1]/drifts[0], 0.6)


def block(folder, own, law, material="neoHookean", cells=(6, 6), speed=0.1,
          **control):
    """A stiff block slides into a soft block, which stands on a floor."""
    soft = Body(cells=cells, name="soft",
                material=elastic(1, "neoHookean", 0.3),
                sides={"top": "contact", "bottom": "contact"})
    hard = {**elastic(100, material, 0.3), "tauY": 0.5, "Hardening": 10}
    if material != "HenckyVonMises":
        hard = elastic(100, material, 0.3)
    stiff = Body(cells=(3, 2), name="stiff", start=(0.3, 1.001, 0),
                 size=(0.4, 0.2, 1), material=hard,
                 velocity=(speed, -speed, 0), sides={"bottom": "contact"})
    return SmallCase(
        folder, (stiff, soft), 1.2, {
            "blocks": interface(("stiff", "bottom"), ("soft", "top"), law,
                                pairing="nearestFace"),
            "floor": {"side": ("soft", "bottom"), "obstacle": FLOOR,
                      "law": coulomb(0.5)}},
        preset=DEFAULT, functions=("contactForces",), control={
            "subCycling": "yes" if own else "no", "writeInterval": 0.3,
            "maxCo": 0.9, "timePrecision": 12, **control})


@pytest.mark.parametrize("ranks", (1, 2))
def test_restart(tmp_path, figures, ranks):
    """A restarted run is equal bit by bit, with friction and plastic flow."""
    case = block(tmp_path/"case", True, coulomb(0.3), "HenckyVonMises")
    (expected, _), (found, touched) = runAgain(
        case, ranks, lambda case, _: case.contact("blocks")["area"])
    with figures(f"steps of their own, {ranks} ranks: restart") as f:
        f.equal("files that differ", differingFiles(expected, found), [])
        f.atLeast("files compared", len(expected[0]), 8)
        f.atLeast("largest area of contact", max(touched), 0.1)


def test_no_way_back(tmp_path, figures):
    """A run with subCycling cannot continue without it."""
    case = bars(tmp_path/"case", True, 50, endTime=0.1)
    case.set("system/controlDict", {"subCycling": "no", "endTime": 0.2})
    code, output = case.attempt()
    case.set("system/controlDict", {"subCycling": "yes", "maxSubCycles": 1})
    again = finished(case)
    with figures("steps of their own, then none") as f:
        f.equal("exit code", code, 1)
        for word in "subCycling", "must be yes", "maxSubCycles 1":
            f.equal(f"message says {word}", word in output, True)
        f.equal("with one step for all", "now: soft 1 stiff 1 " in
                again.output, True)


def test_bad_state(tmp_path, figures):
    """A bad state within a common step ends the run. The state at the start of
    the step is written, and equals that of a run that ends there."""
    case = block(tmp_path/"case", True, coulomb(0.3), cells=(10, 10), maxCo=2.3)
    code, output = case.attempt()
    straight = block(tmp_path/"straight", True, coulomb(0.3), cells=(10, 10),
                     maxCo=2.3, writeInterval=float(case.last),
                     endTime=float(case.last))
    checked(["vertexContactFoam"], straight.path)
    with figures("steps of their own, a state that goes wrong") as f:
        f.equal("exit code", code, 1)
        f.equal("message says where", "region stiff, node at" in output, True)
        f.equal("message says what was written", "start of this step was "
                f"written to time {case.last}" in output, True)
        for name in "pointD", "lm", "contactTraction":
            a, b = (c.at(name, region="stiff") for c in (case, straight))
            f.atMost(f"{name} from a run that ends there / largest",
                     largest(a - b)/largest(b), 1e-12)


def test_dry_run(tmp_path, figures):
    """The dry run tells how much subCycling would save, or saves."""
    said = {}
    for own in "no", "yes":
        case = bars(tmp_path/own, own == "yes", endTime=0.1)
        for time in timeFolders(case.path)[1:]:
            shutil.rmtree(case/time)
        said[own] = checked(["vertexContactFoam", "-dry-run"], case.path)
    would = float(re.search(
        r"soft 1 stiff 20 in \S+ s times maxCo, nodes would be evaluated (\S+) "
        "times", said["no"])[1])
    with figures("-dry-run") as f:
        f.within("share of the evaluations", would, 0.1433, 0.0001)
        f.equal("ratios", "now: soft 1 stiff 20 " in said["yes"], True)


def test_ranks(tmp_path, figures):
    one = finished(block(tmp_path/"one", True, coulomb(0.3)))
    two = block(tmp_path/"two", True, coulomb(0.3))
    code, output = two.attempt(2)
    assert code == 0, output[-3000:]
    checked(["reconstructPar", "-allRegions", "-latestTime"], two.path)
    with figures("steps of their own, 2 ranks against 1") as f:
        for region in "stiff", "soft":
            for name in "pointU", "pointD":
                a, b = (c.at(name, region=region) for c in (one, two))
                f.atMost(f"{region} {name}, largest difference / largest",
                         abs(a - b).max()/abs(a).max(), 1e-10)


def apart(own, one):
    """Relative differences of the final momentum (by its change), of the
    largest strain energy and of the final energy."""
    end, end1 = (c.momentumOf("stiff")[-1] for c in (own, one))
    return (np.linalg.norm(end - end1)
            / np.linalg.norm(end1 - one.momentumOf("stiff")[0]),
            1 - max(own.energies["soft:strain"])
            / max(one.energies["soft:strain"]),
            1 - own.totalEnergy[-1]/one.totalEnergy[-1])


def test_oblique_impact_as_with_one_step(tmp_path, figures):
    """An oblique impact with friction, in two dimensions, at a tenth of the
    wave speed. The difference falls with the cell size and with the step of
    the soft block."""
    differences = []
    for n in 10, 20, 40:
        one, own = (finished(block(tmp_path/f"{n}{is_}", is_, coulomb(0.3),
                                   cells=(n, n))) for is_ in (False, True))
        differences.append(apart(own, one))
    p, strain, energy = np.transpose(differences)
    e = own.energies
    start = e["total:kinetic"][0]
    short = finished(block(tmp_path/"short", True, coulomb(0.3), cells=(40, 40),
                           maxCo=0.3))
    with figures("blocks of 10 to 40 cells, own steps against one") as f:
        f.falling("difference of the momentum / its change", p)
        f.atMost("on the finest", p[-1], 0.01)
        f.falling("largest strain energy, less by", strain)
        f.atMost("on the finest", strain[-1], 0.03)
        f.falling("energy at the end, less by", energy)
        f.atMost("on the finest", energy[-1], 0.03)
        for what, is_ in zip(("momentum", "strain energy", "energy"),
                             apart(short, one)):
            f.atMost(f"{what}, with a third of the step", abs(is_), 0.01)
        f.atMost("balance at the end", abs(e["total:balance"][-1])/start, 2e-3)


def meanForce(case, time=1e-4):
    """Largest mean of the floor's force within a time. The force of an instant
    contains waves of the mesh."""
    contact = case.contact("floor")
    t = np.append(0, contact["Time"])
    impulse = np.append(0, contact["bumper.bottom:Iy"])
    start = np.linspace(0, t[-1] - time, 2000)
    return max(np.interp(start + time, t, impulse)
               - np.interp(start, t, impulse))/time


@pytest.mark.parametrize("joint", ("tied", "frictionless"))
def test_box_on_bumper_as_with_one_step(tmp_path, figures, joint):
    """A box falls on its bumper: force, release, speed and energies agree with
    those of one step to 1 %, and the difference falls with the mesh. If the
    box slides on the bumper, release and speed are already as close as they
    get with 8 elements. The force of an instant has waves of the mesh, of
    which a common step misses most."""
    found = {}
    for n in 8, 16:
        one, own = (finished(boxOnBumper(
            tmp_path/f"{n}{steps}", joint, every=1, n=n, subCycling=steps))
            for steps in ("no", "yes"))
        for name, value in (
                ("largest mean force in 0.1 ms", meanForce),
                ("time of the release", released),
                ("speed away", lambda c: -c.momentum["total:py"][-1]),
                ("largest strain energy",
                 lambda c: max(c.energies["total:strain"])),
                ("energy at the end", lambda c: c.totalEnergy[-1]),
                ("force of an instant, largest", lambda c: max(
                    c.contact("floor")["bumper.bottom:Fy"]))):
            found.setdefault(name, []).append(value(own)/value(one) - 1)
    done, ofOne = evaluations(own)
    p = own.momentumOf()
    impulse = own.contact("floor")["bumper.bottom:Iy"][-1]
    with figures(f"box on a bumper, {joint}, own steps against one") as f:
        for name, differences in found.items():
            last = 0.06 if "instant" in name else 0.01
            comes = joint == "tied" or name.startswith("largest")
            if comes and last < 0.06 and name != "energy at the end":
                f.falling(f"{name}, difference on 8 and 16 elements",
                          np.abs(differences))
            f.within(f"{name} / of one step, 16 elements",
                     1 + differences[-1], 1, last)
        f.atLeast("evaluations of one step / own", ofOne/done, 2.5)
        f.atMost("momentum less impulse / momentum",
                 abs(p[-1, 1] - p[0, 1] - impulse)/abs(p[0, 1]), 1e-12)


@pytest.mark.parametrize("most", (4, 64))
def test_balance_of_a_box_on_a_bumper(tmp_path, figures, most):
    """The energy balance closes with variable steps."""
    case = finished(boxOnBumper(tmp_path/"case", every=1, subCycling="yes",
                                maxSubCycles=most))
    with figures(f"box on a bumper, {most} short steps at most") as f:
        f.atMost("balance at the end / initial energy",
                 abs(case.energies["total:balance"][-1])/case.totalEnergy[0],
                 1e-3)


def shortSteps(case):
    """Number of steps of the stiff body in a common step, from the last
    message."""
    return int(re.findall(r"now: .*\bstiff (\d+)", case.output)[-1])


def test_scaled_mass(tmp_path, figures):
    """massScaling with subCycling equals a higher density to the last bit. A
    body whose step is scaled to that of the others needs no short steps."""
    cases = {}
    for name, rho, control in (
            ("own", 1, {}), ("denser", 4, {}),
            ("scaled", 1, {"massScaling": {
                "stiff": {"factor": 4, "force": "yes"}}})):
        case = block(tmp_path/name, True, coulomb(0.3), **control)
        case.set("constant/stiff/mechanicalProperties", {"rho": rho})
        cases[name] = finished(case)
    end = cases["own"].last
    denser, scaled = (
        {f"{region}/{file}": data for region in ("soft", "stiff")
         for file, data in contents(cases[name]/end/region).items()}
        for name in ("denser", "scaled"))
    e = cases["scaled"].energies
    first = e["total:kinetic"][0]

    stepOf = {"stiff": {"step": 0.02, "force": "yes"}}
    one = bars(tmp_path/"one", True, 50, massScaling=stepOf)
    impulseOfBar = momentum(one)[1]
    with figures("massScaling with steps of their own") as f:
        f.equal("fields that differ from those of the density",
                differingFiles([denser], [scaled]), [])
        f.atLeast("fields compared", len(denser), 16)
        f.within("short steps, own / scaled by 4", shortSteps(cases["own"])
                 / shortSteps(cases["scaled"]), 2, 0.25)
        f.atLeast("largest area of contact", max(
            cases["scaled"].contact("blocks")["area"]), 0.1)
        f.atMost("balance / kinetic energy at first",
                 largest(e["total:balance"])/first, 0.02)
        f.equal("short steps of a bar that has the step of the other",
                shortSteps(one), 1)
        f.atLeast("its momentum", impulseOfBar[-1], 1e-3)


@pytest.mark.parametrize("ranks", (1, 2))
def test_restart_with_scaled_mass(tmp_path, figures, ranks):
    case = block(tmp_path/"case", True, coulomb(0.3), massScaling={
        "stiff": {"factor": 3, "force": "yes"}})
    (expected, _), (found, _) = runAgain(case, ranks)
    with figures(f"steps of their own, scaled mass, {ranks} ranks") as f:
        f.equal("files that differ", differingFiles(expected, found), [])
        f.atLeast("files compared", len(expected[0]), 8)
