"""Prescribed motions by component, along a direction, and by displacement;
reactions of all patches that hold nodes."""

import numpy as np
import pytest

from vertexContactCases import readResults
from vertexContactTests.caseTools import DEFAULT, differingFiles, runAgain
from vertexContactTests.smallCases import (RUBBER, SIDES, Body, SmallCase,
                                           condition,
                                           interface, largest, smooth, table)


def reactionsOf(case):
    return readResults.table(case.path, "reactionForces", "reactions.dat")


def vectors(columns, name):
    return np.array([columns[f"{name}{c}"] for c in "xyz"]).T


def ramp(time, value, n=200):
    """A smooth rise from zero to a value within a time, then rest."""
    s = np.linspace(0, 1, n + 1)
    value = np.asarray(value, dtype=float)
    rows = [(time*x, tuple(smooth(x)*value) if value.ndim
             else float(smooth(x)*value)) for x in s]
    return table(*rows, (1e3*time, rows[-1][1]))


def small(folder, bodies, endTime, interfaces=None, **more):
    return SmallCase(
        folder, bodies, endTime, interfaces=interfaces, preset=DEFAULT,
        functions=("reactionForces", *(("contactForces",) if interfaces
                                       else ())), **more)


TRACTION = (0.002, -0.003, 0.001)
GRAVITY = (0.001, -0.002, 0.003)


def pressed(folder, endTime=1.5, write=None):
    """Two blocks with all kinds of constraints, some of them at the same
    nodes. The upper block is pressed onto the lower one and pulled
    sideways."""
    lower = Body(
        cells=(4, 3, 3), name="lower", material=RUBBER, sides={
            "bottom": condition("fixedVelocity", velocity=(0, 0, 0)),
            "left": "slip", "top": "contact",
            "front": condition("fixedVelocity", velocity=table(
                (0, 0.0), (9, 0.2)), direction=(0.3, 0, 1))})
    upper = Body(
        cells=(3, 3, 4), name="upper", material=RUBBER, start=(0, 1, 0),
        velocity=(0, -0.02, 0), sides={
            "bottom": "contact", "left": "slip",
            "right": condition("traction", traction=TRACTION),
            "back": condition("fixedDisplacement", components=("x", "z"),
                              displacement=table((0, (0, 0, 0)),
                                                 (9, (0.1, 5, 0.2)))),
            "top": condition("fixedDisplacement", direction=(0, 2, 1),
                             displacement=ramp(1, -0.05))})
    contact = interface(("upper", "bottom"), ("lower", "top"),
                        law={"type": "Coulomb", "frictionCoeff": 0.3},
                        pairing="nearestFace")
    return small(folder, (lower, upper), endTime, gravity=GRAVITY,
                 interfaces={"between": contact},
                 control={"writeInterval": write or endTime})


@pytest.mark.parametrize("ranks", (1, 2))
def test_momentum_balance(tmp_path, figures, ranks):
    """The impulses of reactions, contact, tractions and gravity equal the
    change of the momentum."""
    case = pressed(tmp_path)
    if ranks == 1:
        case.run()
    else:
        case.runParallel(ranks)
    reactions, contact = reactionsOf(case), case.contact("between")
    t = case.momentum["Time"]
    assert np.array_equal(t, reactions["Time"])
    # Contact has no row at the start
    assert np.array_equal(t[1:], contact["Time"])
    steps = np.diff(t, prepend=t[0])
    acting = (t - 0.5*steps)[:, None]
    with figures(f"momentum with reactions, {ranks} ranks") as f:
        patches = sorted({key.split(":")[0] for key in reactions
                          if ":" in key})
        f.equal("patches", patches,
                ["lower.bottom", "lower.front", "lower.left",
                 "upper.back", "upper.left", "upper.top"])
        for name, loads in (("lower", 0), ("upper", np.array(TRACTION))):
            held = sum(vectors(reactions, f"{patch}:I") for patch in patches
                       if patch.startswith(name))[1:]
            side = {"lower": "lower.top", "upper": "upper.bottom"}[name]
            given = vectors(contact, f"{side}:I")
            change = case.momentumOf(name)
            change = (change - change[0])[1:]
            scale = largest(held) + largest(given)
            f.atLeast(f"{name}, impulse of contact", largest(given), 1e-3)
            f.atMost(f"{name}, what is left of the impulses", largest(
                change - held - given - acting[1:]*(loads + np.array(GRAVITY)))
                / scale, 1e-12)
        X, D = case.X("upper"), case.at("pointD", region="upper")
        top = np.abs(X[:, 1] - 2) < 1e-9
        back = np.abs(X[:, 2]) < 1e-9
        way = np.array((0, 2, 1))/np.sqrt(5)
        end = 1.5/9
        f.atMost("displacement along the direction, error",
                 largest(D[top & ~back] @ way + 0.05), 1e-15)
        slips = np.abs(X[:, 0]) < 1e-9
        f.atMost("displacement of components, error", largest(
            D[back & ~slips][:, [0, 2]] - np.array((0.1, 0.2))*end), 1e-15)
        f.atMost("where a mirror holds one of them, error", largest(
            D[back & slips][:, [0, 2]] - np.array((0, 0.2))*end), 1e-15)
        f.atMost("both at the common edge",
                 largest(D[back & top] @ way + 0.05), 1e-14)
        f.atLeast("what is free moves", largest(D[back & ~top][:, 1]), 1e-3)
        e = case.energies
        f.atMost("balance of the energy / largest energy", largest(
            e["total:balance"])/largest(case.totalEnergy), 1e-3)


@pytest.mark.parametrize("ranks", (1, 2))
def test_restart(tmp_path, figures, ranks):
    """A restart is equal to the last bit."""
    case = pressed(tmp_path, endTime=0.6, write=0.2)
    (expected, straight), (found, again) = runAgain(
        case, ranks, lambda case, _: reactionsOf(case))
    late = straight["Time"] > 0.2 - 1e-9
    with figures(f"restart with constraints, {ranks} ranks") as f:
        f.equal("files that differ", differingFiles(expected, found), [])
        f.atMost("largest difference of a row / largest value", max(
            largest(straight[key][late] - again[key][-late.sum():])
            / (largest(straight[key]) + 1e-300) for key in straight),
            0 if ranks == 1 else 1e-13)


def test_uniaxial_strain(tmp_path, figures):
    """A block is compressed between two planes and slides along mirrors at its
    sides. With a prescribed displacement it agrees with theory; with the
    velocity of this displacement the result is the same."""
    nu, strain, time = 0.3, -0.02, 40
    modulus = (1 - nu)/((1 + nu)*(1 - 2*nu))
    material = {"type": "linearElastic", "rho": 1, "E": 1, "nu": nu}
    size = (1, 2, 1.5)
    s = np.linspace(0, 1, 2001)
    velocities = [(time*a, (7, 60*a**2*(1 - a)**2*strain/time, 7)) for a in s]
    ways = {
        "displacement": condition("fixedDisplacement", components=("y",),
                                  displacement=ramp(time, (7, 2*strain, 7))),
        "velocity": condition("fixedVelocity", components=("y",),
                              velocity=table(*velocities))}
    runs = {}
    for way, top in ways.items():
        block = Body(
            cells=(3, 4, 3), name="block", material=material, size=size,
            sides={"top": top, "left": "slip", "back": "slip",
                   "right": condition("fixedVelocity", components=("x",),
                                      velocity=(0, 3, 3)),
                   "front": condition("fixedVelocity", direction=(0, 0, -1),
                                      velocity=0),
                   "bottom": condition("fixedVelocity", components=("y",),
                                       velocity=(1, 0, 1))})
        runs[way] = small(tmp_path/way, block, time).run()
    area = size[0]*size[2]
    with figures("uniaxial strain, by") as f:
        for way, case in runs.items():
            r, e = reactionsOf(case), case.energies
            force = area*modulus*strain
            energy = 0.5*area*size[1]*modulus*strain**2
            exact = 1e-14 if way == "displacement" else 1e-9
            D, X = case.at("pointD"), case.X()
            f.atMost(f"{way}: largest error of the displacement / largest",
                     largest(D - strain*X*(0, 1, 0))/abs(2*strain), 2e-4)
            top = np.abs(X[:, 1] - size[1]) < 1e-9
            f.atMost(f"{way}: that of the upper side",
                     largest(D[top][:, 1] - 2*strain)/abs(2*strain), exact)
            lateral = nu/(1 - nu)*modulus*strain
            for patch, c, value in (
                    ("top", "y", force), ("bottom", "y", -force),
                    ("left", "x", -lateral*size[1]*size[2]),
                    ("right", "x", lateral*size[1]*size[2]),
                    ("back", "z", -lateral*size[0]*size[1]),
                    ("front", "z", lateral*size[0]*size[1])):
                f.within(f"{way}: force of {patch} / theory",
                         r[f"block.{patch}:F{c}"][-1]/value, 1, 1e-3)
            f.within(f"{way}: work / theory",
                     r["block.top:work"][-1]/energy, 1, 1e-3)
            f.within(f"{way}: work of the reactions / externalWork",
                     sum(r[k][-1] for k in r if k.endswith("work"))
                     / e["total:externalWork"][-1], 1, 1e-3)
            f.atMost(f"{way}: balance / energy",
                     largest(e["total:balance"])/energy, 1e-7)
        ends = [reactionsOf(case)["block.top:Fy"][-1]
                for case in runs.values()]
        f.within("force by velocity / by displacement", ends[1]/ends[0],
                 1, 1e-4)


def turned(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array(((c, -s, 0), (s, c, 0), (0, 0, 1)))


def sliding(folder, angle):
    """A block slides along one side, is pushed along a direction that is
    oblique to this side, and is pulled. The whole scene is rotated."""
    Q = turned(angle)
    block = Body(
        cells=(6, 4), name="block", material=RUBBER, size=(1.5, 1, 1),
        moved=lambda X: X @ Q.T, sides={
            "bottom": "slip",
            "left": condition("fixedVelocity", velocity=0.02,
                              direction=Q @ (3, 4, 0)),
            "right": condition("fixedVelocity", velocity=0,
                               direction=Q @ (1, 0, 0)),
            "top": condition("traction", traction=Q @ (0.02, 0.03, 0))})
    return small(folder, block, 3).run()


def test_turned_by_45_degrees(tmp_path, figures):
    """The same scene is rotated by 45 degrees, so that slip and directions are
    along no axis."""
    straight = sliding(tmp_path/"straight", 0)
    slanted = sliding(tmp_path/"slanted", np.pi/4)
    Q = turned(np.pi/4)
    with figures("sliding along a slope") as f:
        D, turnedD = straight.at("pointD"), slanted.at("pointD")
        X = straight.X()
        size = largest(D)
        f.atLeast("largest displacement / height", size, 0.02)
        f.atMost("difference of the displacements / largest",
                 largest(turnedD - D @ Q.T)/size, 1e-12)
        a, b = reactionsOf(straight), reactionsOf(slanted)
        for patch in ("bottom", "left", "right"):
            F, G = (vectors(r, f"block.{patch}:F") for r in (a, b))
            f.atLeast(f"largest force of {patch}", largest(F), 1e-3)
            f.atMost(f"difference of the forces of {patch} / largest",
                     largest(G - F @ Q.T)/largest(F), 1e-10)
        f.atMost("force of the slip along it / largest",
                 largest(a["block.bottom:Fx"])/largest(a["block.bottom:Fy"]),
                 1e-14)
        corner = (np.abs(X[:, 0]) < 1e-9) & (np.abs(X[:, 1]) < 1e-9)
        U = straight.at("pointU")[corner]
        f.atMost("velocity of the corner of both, error / speed", largest(
            U - (0.02*5/3, 0, 0))/0.02, 1e-12)
        left = np.abs(X[:, 0]) < 1e-9
        f.atMost("velocity along the direction, error / speed", largest(
            straight.at("pointU")[left] @ (0.6, 0.8, 0) - 0.02)/0.02, 1e-12)


def test_vibrating_support(tmp_path, figures):
    """The reaction of a shaken side contains the inertia of the body: a block
    whose side is shaken as a whole reacts with its mass."""
    T = 50
    motion = {"amplitude": 1, "frequency": 1/T, "scale": 1, "level": 0}
    case = small(tmp_path, Body(
        cells=(3, 3), name="block", material=RUBBER,
        velocity=(2*np.pi/T, 0, 0), sides={
            side: condition("fixedDisplacement", direction=(1, 0, 0),
                            displacement="sine",
                            displacementCoeffs=motion)
            for side in ("left", "right", "bottom", "top")}), T)
    case.run()
    r = reactionsOf(case)
    force = sum(r[f"block.{side}:Fx"]
                for side in ("left", "right", "bottom", "top"))
    omega = 2*np.pi/T
    # The force acts around the start of the step
    t = np.concatenate(([0], r["Time"][:-1]))
    with figures("a block that is shaken") as f:
        f.atMost("force, error / mass times acceleration", largest(
            force[5:] + omega**2*np.sin(omega*t[5:]))/omega**2, 0.05)


def test_rigid_regions_are_held_as_a_whole(tmp_path, figures):
    """The patches of rigid regions have no reactions. A rigid region has one,
    if it is held."""
    block = Body(cells=(3, 3), name="block", sides={
        "left": condition("fixedVelocity", velocity=(0, 0, 0))})
    plate = Body(cells=(2, 2), name="plate", start=(2, 0, 0),
                 material={"type": "rigid", "rho": 1},
                 sides={"left": "symmetryPlane"})
    free = Body(cells=(2, 2), name="free", start=(4, 0, 0),
                material={"type": "rigid", "rho": 1})
    both = small(tmp_path/"both", (block, plate, free), 0.1).run()
    code, output = small(tmp_path/"free", (
        Body(cells=(3, 3), name="block"), free), 0.1).attempt()
    with figures("reactions beside rigid regions") as f:
        f.equal("what is held", sorted({key.split(":")[0] for key in
                                        reactionsOf(both)} - {"Time"}),
                ["block.left", "plate"])
        f.equal("exit code where nothing is held", code, 1)
        f.equal("message", "no patch holds nodes of a region that deforms, "
                "and no rigid region is held" in output, True)


@pytest.mark.parametrize("angle, nDim, law", (
    (60, 2, "neoHookean"), (120, 2, "neoHookean"), (60, 2, "HenckyVonMises"),
    (60, 3, "neoHookean")))
def test_mirrors_at_an_angle(tmp_path, figures, angle, nDim, law):
    """A kite between two mirrors is symmetric about the line between them. It
    stays symmetric, whichever mirror comes first: each mirror sees an image of
    the other."""
    half = np.radians(angle)/2
    tip = np.array((np.cos(half), np.sin(half)))/max(np.cos(half), 0.5)
    sides = np.array((1, 0)), np.array((np.cos(2*half), np.sin(2*half)))

    def kite(X):
        s, t = X[:, :1], X[:, 1:2]
        return np.hstack((s*(1 - t)*sides[0] + (1 - s)*t*sides[1] + s*t*tip,
                          X[:, 2:]))

    material = {"type": law, "rho": 1, "E": 1, "nu": 0.3}
    if law == "HenckyVonMises":
        material["tauY"] = 0.02
    case = SmallCase(
        tmp_path, Body((6, 6, 3)[:nDim], moved=kite, material=material, sides={
            "bottom": "symmetryPlane", "left": "symmetryPlane"},
            velocity=lambda X: -0.3*X*np.array((1, 1, 0))), 1.5,
        preset=DEFAULT).run()
    X, D = case.X(), case.at("pointD")
    along = np.array((np.cos(half), np.sin(half), 0))
    M = 2*np.outer(along, along) - np.diag((1, 1, -1))
    image = [np.argmin(((X - M @ x)**2).sum(1)) for x in X]
    with figures(f"{law} between mirrors at {angle} degrees, {nDim}D") as f:
        f.atLeast("largest displacement", largest(D), 0.02)
        f.atMost("difference of the halves / largest displacement",
                 largest(D[image] @ M.T - D)/largest(D), 1e-12)


class Joined(Body):
    """A body whose left and bottom sides are one patch."""

    def boundary(self, faces):
        each = super().boundary(faces)
        patches = dict(zip(each[::2], each[1::2]))
        patches["left"]["faces"] = "({} {})".format(*(
            patches[side]["faces"].strip()[1:-1]
            for side in ("left", "bottom")))
        del patches["bottom"]
        return [part for pair in patches.items() for part in pair]

    @property
    def patches(self):
        return tuple(side for side in SIDES if side != "bottom")


@pytest.mark.parametrize("nDim", (2, 3))
@pytest.mark.parametrize("ranks", (1, 2))
def test_slip_does_not_turn_by_an_edge(tmp_path, nDim, ranks):
    """A node on the edge would slide through both sides."""
    case = SmallCase(tmp_path, Joined((4,)*nDim, sides={"left": "slip"}), 1,
                     preset=DEFAULT)
    code, log = case.attempt(ranks)
    assert code != 0 and "FOAM FATAL IO ERROR" in log
    assert "'left'" in log and "an edge at (0 0 " in log and "pointU" in log
