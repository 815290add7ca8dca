"""contactIterations: contact is solved again with the velocities that its own
forces cause."""

import numpy as np
import pytest

from vertexContactTests.contactScenes import (END, PLACES, difference, solve,
                                              solveOn, squares, toolAndBlock)
from vertexContactTests.defaultCases import CLAMPED, defaultCase
from vertexContactTests.smallCases import (FLOOR, Body, GmshBody, SmallCase,
                                           condition, coulomb, interface)


def pressed(folder, iterations):
    """A block at rest on a base with a three times finer mesh."""
    block = Body((2, 2), name="block", sides={
        "bottom": "contact",
        "top": condition("traction", traction=(0, -0.05, 0))})
    base = Body((12, 6), name="base", start=(-0.5, -1, 0), size=(2, 1, 1),
                sides={**CLAMPED, "top": "contact"})
    return defaultCase(
        folder, [block, base], 1500, {
            "writeInterval": 1500, "contactIterations": iterations},
        every=50, interfaces={"contact": interface(
            ("block", "bottom"), ("base", "top"), coulomb(0.5),
            pairing="nearestFace")}, functions=("contactForces",)).run()


def test_less_penetration(tmp_path, figures):
    """Pressed surfaces penetrate less with each iteration."""
    runs = [pressed(tmp_path/f"{n}", n) for n in (1, 2, 4)]
    depths = [run.contact("contact")["penetration"][-1] for run in runs]
    with figures("contactIterations 1, 2, 4, a block at rest") as f:
        f.falling("penetration [cells]", [2*d for d in depths])
        f.atMost("of 2 / of 1", depths[1]/depths[0], 0.7)
        for n, run in zip((1, 2, 4), runs):
            work = run.energies["total:contactWork"]
            f.atMost(f"{n}: most that contact gives / largest kinetic energy",
                     work.max()/run.energies["total:kinetic"].max(), 1e-3)


def test_point_by_point(tmp_path, figures):
    """If each node touches one other node, one solution is exact, also for
    slipping nodes."""
    runs = []
    for n in 1, 2, 3, 4:
        bars = [Body((8, 2), name=name, start=(start, 0, 0), size=(1, 0.25, 1),
                     sides={side: "contact"}, velocity=(speed, 0.3*speed, 0))
                for name, start, side, speed in (
                    ("a", 0, "right", 0.1), ("b", 1.001, "left", -0.05))]
        runs.append(defaultCase(
            tmp_path/f"{n}", bars, 2, {"contactIterations": n},
            interfaces={"c": interface(("a", "right"), ("b", "left"),
                                       coulomb(0.3))}).run())
    one, *others = runs
    with figures("contactIterations 2 to 4 against 1, matching bars") as f:
        f.atLeast("friction / initial energy",
                  one.energies["total:frictionDissipation"][-1]
                  / one.totalEnergy[0], 1e-3)
        f.atLeast("energy that contact takes / initial",
                  -one.energies["total:contactWork"].min()
                  / one.totalEnergy[0], 0.01)
        for n, other in enumerate(others, 2):
            for name in "kinetic", "strain":
                f.atMost(f"{n}: {name}, difference / initial energy", np.abs(
                    one.energies[f"total:{name}"]
                    - other.energies[f"total:{name}"]).max()
                    / one.totalEnergy[0], 1e-10)


@pytest.mark.parametrize("places", PLACES)
def test_ranks(tmp_path, figures, places):
    """The scene has friction, many surfaces, and a floor under two of the
    blocks."""
    def case(name, iterations):
        bodies = squares()
        bodies[0].velocity = (2, 4, 0)
        for body in bodies[0], bodies[2]:
            body.sides["bottom"] = "contact"
        return SmallCase(
            tmp_path/name, bodies, END, {
                "all": {"surfaces": "all", "law": coulomb(0.3)},
                "floor": {"side": ("square10", "bottom"), "law": coulomb(0.3),
                          "obstacle": FLOOR}},
            preset="balanced", control={
                "maxCo": 0.9, "contactIterations": iterations})
    once, serial, parallel = (
        case(name, n) for name, n in (("once", 1), ("serial", 2),
                                      ("parallel", 2)))
    solve(once)
    solve(serial)
    solveOn(parallel, *PLACES[places])
    E = serial.totalEnergy
    with figures(f"contactIterations 2 on ranks: {places}") as f:
        f.atMost("difference of energies / initial energy",
                 difference(serial, parallel), 1e-9)
        f.atLeast("difference to 1", difference(serial, once), 1e-6)
        f.atMost("largest energy / initial", E.max()/E[0], 1 + 1e-6)


@pytest.mark.parametrize("own", ("no", "yes"))
def test_rigid(tmp_path, figures, own):
    """A rigid tool with friction, also with subCycling. Two ranks give the
    result of one, and contact dissipates energy."""
    control = {"contactIterations": 2, "subCycling": own}
    one = toolAndBlock(tmp_path/"one", control=control)
    two = toolAndBlock(tmp_path/"two", ranks=2, control=control)
    work = one.energies["total:contactWork"]
    kinetic = one.energies["total:kinetic"].max()
    with figures(f"contactIterations 2, rigid tool, subCycling {own}") as f:
        f.atLeast("energy that contact takes / kinetic", -work.min()/kinetic,
                  1e-3)
        for name in "total:kinetic", "total:externalWork", "total:contactWork":
            f.atMost(f"{name}, 2 ranks against 1",
                     np.abs(one.energies[name] - two.energies[name]).max()
                     / kinetic, 1e-10)
        a, b = (run.angularMomentumOf("tool") for run in (one, two))
        f.atMost("angular momentum, 2 ranks against 1",
                 np.abs(a - b).max()/np.abs(a).max(), 1e-10)


def box(patches):
    """A box whose bottom is two rectangles, in one or two patches."""
    def within(name, *corners):
        return (f"{name}() = Surface In BoundingBox{{"
                f"{', '.join(str(c) for c in corners)}}};\n")
    e, y = 1e-6, 0.01
    low, high = (-e, y - e, -e), (1 + e, y + 1 + e, 1 + e)
    rest = "".join(
        within(f"s{axis}{side}",
               *(at - e if i == axis else low[i] for i in range(3)),
               *(at + e if i == axis else high[i] for i in range(3)))
        for axis, side, at in ((0, 0, 0), (0, 1, 1), (1, 1, y + 1), (2, 0, 0),
                               (2, 1, 1)))
    names = ("a()", "b()") if patches == 2 else ("a(), b()",)
    surfaces = "".join(f'Physical Surface("bottom{i}") = {{{name}}};\n'
                       for i, name in enumerate(names))
    return f"""SetFactory("OpenCASCADE");
Box(1) = {{0, {y}, 0, 0.5, 1, 1}};
Box(2) = {{0.5, {y}, 0, 0.5, 1, 1}};
Coherence;
Mesh.CharacteristicLengthMax = 0.3;
{within("a", -e, y - e, -e, 0.5 + e, y + e, 1 + e)}
{within("b", 0.5 - e, y - e, -e, 1 + e, y + e, 1 + e)}
{rest}{surfaces}
Physical Surface("rest") = {{s00(), s01(), s11(), s20(), s21()}};
Physical Volume("all") = {{1, 2}};
"""


@pytest.mark.parametrize("iterations", (1, 2))
@pytest.mark.parametrize("on", ("plane", "body"))
def test_seam(tmp_path, figures, on, iterations):
    """A box falls on its bottom, which has one or two patches. Nodes between
    both patches are pushed once. If the other side is a body, each patch is
    paired at its own times."""
    base = Body((3, 2, 3), name="base", start=(-0.25, -1, -0.25),
                size=(1.5, 1, 1.5), sides={"top": "contact"})

    def fallen(n):
        sides = [f"bottom{i}" for i in range(n)]
        falling = GmshBody(
            name="box", geometry=box(n), velocity=(0, -0.05, 0),
            sides={**dict.fromkeys(sides, "contact"), "rest": "tractionFree"})
        interfaces = {side: {
            "side": ("box", side), "obstacle": FLOOR} if on == "plane"
            else interface(("box", side), ("base", "top"),
                           pairing="nearestFace") for side in sides}
        return defaultCase(
            tmp_path/f"{n}", [falling] + [base]*(on == "body"), 2,
            {"contactIterations": iterations}, interfaces=interfaces).run()
    one, two = fallen(1), fallen(2)
    with figures(f"two patches against one, on a {on}, contactIterations "
                 f"{iterations}") as f:
        f.atLeast("energy that contact takes / initial",
                  -one.energies["total:contactWork"].min()
                  / one.totalEnergy[0], 1e-3)
        for name in "kinetic", "strain", "contactWork":
            f.atMost(f"{name}, difference / initial energy", np.abs(
                one.energies[f"total:{name}"]
                - two.energies[f"total:{name}"]).max()/one.totalEnergy[0],
                1e-9 if on == "plane" else 1e-4)
