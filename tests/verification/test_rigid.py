"""Rigid regions: against theory, against obstacles, and with deformable bodies
that they touch."""

import numpy as np
import pytest

from caseTools import DEFAULT, execute
from contactScenes import rigid, spinning, toolAndBlock
from smallCases import (FLOOR, RUBBER, Body, SmallCase, coulomb, interface,
                        largest, table)

# The run of one rigid region has no step of its own
FIXED = {"adjustTimeStep": "no"}
GRAVITY = 9.81


def test_compound_pendulum(tmp_path, figures):
    """Period of a rod on a pivot, small angles: 2 pi sqrt(I/(m g d))."""
    length, width, angle = 1.0, 0.1, 1e-3
    inertia = (length**2 + width**2)/12 + (length/2)**2
    period = 2*np.pi*np.sqrt(inertia/(GRAVITY*length/2))

    def tilted(X):
        c, s = np.cos(angle), np.sin(angle)
        return np.stack((c*X[:, 0] - s*X[:, 1] - X[:, 0],
                         s*X[:, 0] + c*X[:, 1] - X[:, 1], 0*X[:, 2]), axis=1)

    body = Body(cells=(2, 8, 2), start=(-width/2, -length, -width/2),
                size=(width, length, width), displacement=tilted,
                material=rigid(pivot=(0, 0, 0), freeRotation="(z)"))
    case = SmallCase(tmp_path, body, 2.2*period, gravity=(0, -GRAVITY, 0),
                     control={**FIXED, "deltaT": period/2000},
                     preset=DEFAULT).run()
    L = case.momentum["body:Lz"]
    t = case.momentum["Time"]
    up = np.flatnonzero((L[:-1] < 0) & (L[1:] >= 0))
    zero = t[up] - L[up]*(t[up + 1] - t[up])/(L[up + 1] - L[up])
    with figures("compound pendulum") as f:
        f.within("period / theory", np.diff(zero).mean()/period, 1, 1e-5)
        f.atMost("energy balance", largest(case.energies["total:balance"])
                / largest(case.energies["total:kinetic"]), 1e-4)


def test_bounce_keeps_momenta(tmp_path, figures):
    """A spinning rigid cuboid bounces on a soft block that is free, off
    centre: linear and angular momentum of the pair stay, and it takes energy
    only."""
    tool = Body(cells=(3, 3, 3), name="tool", start=(0.5, 1.02, 0.4),
                size=(0.5, 0.3, 0.7), sides={"bottom": "contact"},
                velocity=spinning((0.75, 1.17, 0.75), (0.1, 2.0, 0.05),
                                  (0, -0.1, 0)),
                material=rigid(rho=2))
    block = Body(cells=(5, 4, 6), name="block", size=(1.2, 1, 1.5),
                 sides={"top": "contact"})
    case = SmallCase(tmp_path, [tool, block], 4,
                     interfaces={"both": interface(
                         ("tool", "bottom"), ("block", "top"), coulomb(0.3),
                         pairing="nearestFace")},
                     functions=("contactForces",), preset=DEFAULT).run()
    p, L = case.momentumOf(), case.angularMomentumOf()
    E = case.energies["total:kinetic"] + case.energies["total:strain"]
    assert largest(case.contact("both")["tool.bottom:Fy"]) > 0
    with figures("spinning rigid cuboid bounces on a soft block") as f:
        f.atMost("linear momentum, change / initial",
                largest(p - p[0])/np.linalg.norm(p[0]), 1e-12)
        f.atMost("angular momentum, change / initial",
                largest(L - L[0])/np.linalg.norm(L[0]), 1e-12)
        f.atMost("energy / initial", E.max()/E[0], 1 + 1e-6)
        f.within("energy at the end / initial", E[-1]/E[0], 0.85, 0.1)
        f.atMost("energy balance / initial",
                largest(case.energies["total:balance"])/E[0], 1e-3)


def test_general_contact(tmp_path, figures):
    """All surfaces with each other: what the named pair gives."""
    named = toolAndBlock(tmp_path/"named")
    general = toolAndBlock(tmp_path/"general", contact={
        "all": {"surfaces": "all", "law": coulomb(0.3)}})
    a, b = (case.energies["total:contactWork"] for case in (named, general))
    with figures("rigid tool on a block, all surfaces") as f:
        f.atMost("contact work, difference / largest",
                 largest(a - b)/largest(a), 1e-10)


def test_known_before_the_run(tmp_path):
    """-dry-run and checkContact take rigid regions."""
    case = toolAndBlock(tmp_path)
    for command in (("vertexContactFoam", "-dry-run"),
                    ("checkContact", "-time", "0")):
        done = execute(command, case.path)
        assert done.returncode == 0, done.stdout
        assert "tool" in done.stdout


def test_parallel(tmp_path, figures):
    """Two ranks, which cut both bodies, give what one gives."""
    one = toolAndBlock(tmp_path/"one")
    two = toolAndBlock(tmp_path/"two", ranks=2)
    with figures("rigid tool on a block, 2 ranks against 1") as f:
        for name in "total:kinetic", "total:externalWork", "total:contactWork":
            f.atMost(name, largest(one.energies[name] - two.energies[name])
                     / largest(one.energies["total:kinetic"]), 1e-10)
        a, b = (run.angularMomentumOf("tool") for run in (one, two))
        f.atMost("angular momentum", largest(a - b)/largest(a), 1e-10)


def test_restart(tmp_path):
    """A run that is started from half of the time ends in the same bits."""
    whole = toolAndBlock(tmp_path/"whole")
    again = toolAndBlock(tmp_path/"again", 0.5, control={"writeInterval": 0.5})
    again.set("system/controlDict", {"endTime": 1})
    again.run()
    for region in "tool", "block":
        for name in "pointD", "pointU", "lm":
            assert np.array_equal(whole.at(name, region=region),
                                  again.at(name, region=region)), name


def test_sub_cycling(tmp_path, figures):
    """With steps of their own the rigid region takes the shortest one."""
    one = toolAndBlock(tmp_path/"one")
    own = toolAndBlock(tmp_path/"own", control={"subCycling": "yes"})
    with figures("rigid tool on a block, subCycling") as f:
        for name in "total:kinetic", "total:contactWork":
            f.within(f"{name}, of one step",
                     own.energies[name][-1]/one.energies[name][-1], 1, 1e-6)


@pytest.mark.parametrize("motion", ("displacement", "velocity"))
def test_moved_plate_is_as_an_obstacle(tmp_path, figures, motion):
    """A plate that is moved presses as an obstacle with the same motion: up to
    what overlaps of faces and corners differ by."""
    value = {"displacement": table((0, (0, 0, 0)), (1, (0, 0.05, 0))),
             "velocity": (0, 0.05, 0)}
    move = {motion: value[motion]}
    force = []
    for kind in "region", "obstacle":
        block = Body(cells=(6, 6), name="block", start=(0, 0.001, 0),
                     sides={"bottom": "contact"}, material=RUBBER)
        plate = Body(cells=(3, 1), name="plate", start=(-1, -0.5, 0),
                     size=(3, 0.5, 1), sides={"top": "contact"},
                     material=rigid(motion=move))
        sides = (interface(("block", "bottom"), ("plate", "top"),
                           pairing="nearestFace") if kind == "region" else
                 {"side": ("block", "bottom"), "obstacle": FLOOR,
                  "motion": move, "law": {"type": "frictionless"}})
        bodies = [block, plate] if kind == "region" else [block]
        case = SmallCase(tmp_path/kind, bodies, 1, interfaces={"c": sides},
                         functions=("contactForces",), preset=DEFAULT).run()
        force.append(case.contact("c")["block.bottom:Fy"])
    n = min(len(f) for f in force)
    with figures(f"plate that is moved by a {motion} against obstacle") as f:
        f.atMost("force, difference / largest", largest(
            force[0][:n] - force[1][:n])/largest(force[1]), 5e-3)


def test_rest(tmp_path, figures):
    """A rigid block that lies on a soft one under gravity, at the sag of
    statics (a column without lateral strain), stays at rest there."""
    g, load = 0.01, 3*0.01
    column = {"type": "linearElastic", "rho": 0.01, "E": 1, "nu": 0}
    tool = Body(cells=(1, 1), name="tool", start=(0, 1, 0), size=(1, 1, 1),
                sides={"bottom": "contact"}, material=rigid(rho=3),
                displacement=lambda X: X*0 - (0, load, 0))
    block = Body(cells=(4, 4), name="block",
                 sides={"top": "contact", "bottom": {
                     "type": "fixedVelocity", "velocity": (0, 0, 0)}},
                 material=column,
                 displacement=lambda X: -load*X*np.array((0, 1, 0)))
    case = SmallCase(tmp_path, [tool, block], 20, gravity=(0, -g, 0),
                     interfaces={"c": interface(
                         ("tool", "bottom"), ("block", "top"),
                         pairing="nearestFace")},
                     functions=("contactForces",), preset=DEFAULT).run()
    sag = -case.at("pointD", region="tool")[:, 1].mean()
    F = case.contact("c")["tool.bottom:Fy"]
    with figures("rigid block on a soft one") as f:
        f.within("sag / theory", sag/load, 1, 0.01)
        f.within("mean force / weight", F[len(F)//2:].mean()/load, 1, 0.01)
        f.atMost("kinetic energy / strain energy",
                 case.energies["total:kinetic"].max()
                 / case.energies["total:strain"].max(), 1e-4)


BAD = {
    "both": ({"mass": 1}, "mass"),
    "axes": ({"freeRotation": "(x y)"}, "freeRotation"),
    "direction": ({"freeTranslation": "(up)"}, "freeTranslation"),
    "pivot": ({"pivot": (0, 0, 0), "motion": {"velocity": (0, 0, 0)}},
              "motion"),
    "motion": ({"motion": {"velocity": (0, 0, 0),
                           "displacement": (0, 0, 0)}}, "motion"),
    "inertia": ({"inertia": (1, 0, 0, 1, 0, 3)}, "inertia"),
    "unknown": ({"E": 1}, "E"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_input(tmp_path, name):
    more, keyword = BAD[name]
    body = Body(cells=(1, 1, 1), material=rigid(**more))
    code, out = SmallCase(tmp_path, body, 1, control=FIXED,
                          preset=DEFAULT).attempt()
    assert code != 0 and "FOAM FATAL IO ERROR" in out
    assert keyword in out and "mechanicalProperties" in out


def test_all_rigid_needs_a_step(tmp_path):
    body = Body(cells=(1, 1, 1), material=rigid())
    code, out = SmallCase(tmp_path, body, 1, preset=DEFAULT).attempt()
    assert code != 0 and "adjustTimeStep" in out
