"""Rigid regions: compared with theory, with obstacles, and with the deformable
bodies that they touch."""

import re

import numpy as np
import pytest

from vertexContactCases import readResults
from vertexContactTests.caseTools import DEFAULT, execute, timeFolders
from vertexContactTests.contactScenes import rigid, spinning, toolAndBlock
from vertexContactTests.smallCases import (EACH_STEP, FLOOR, RUBBER, Body,
                                           SmallCase, condition, coulomb,
                                           interface, largest, table, turned)

# A run with a single rigid region has no stable step
FIXED = {"adjustTimeStep": "no"}
GRAVITY = 9.81


def lifted(R):
    """Displacement that rotates a body about the origin."""
    return lambda X: X @ (R - np.eye(3)).T


def about(axis, angle):
    """Rotation about an axis of space."""
    c, s = np.cos(angle), np.sin(angle)
    R = np.array(((c, -s, 0), (s, c, 0), (0, 0, 1)))
    order = {"x": (2, 0, 1), "y": (1, 2, 0), "z": (0, 1, 2)}[axis]
    return R[np.ix_(order, order)]


# A rod that hangs from the origin
ROD = (0.1, 1.0, 0.1)
ROD_INERTIA = (ROD[0]**2 + ROD[1]**2)/12        # per mass, about its centre
PERIOD = 2*np.pi*np.sqrt((ROD_INERTIA + ROD[1]**2/4)/(GRAVITY*ROD[1]/2))
HANGING = {"size": ROD, "start": (-ROD[0]/2, -ROD[1], -ROD[2]/2)}


def pendulum(folder, material, periods, steps=2000, **more):
    body = Body(cells=(2, 8, 2), **more, material={
        "type": "rigid", "pivot": (0, 0, 0), **material})
    return SmallCase(folder, body, periods*PERIOD, gravity=(0, -GRAVITY, 0),
                     control={**FIXED, "deltaT": PERIOD/steps},
                     preset=DEFAULT).run()


def test_compound_pendulum(tmp_path, figures):
    """Period of a rod on a pivot for small angles: 2 pi sqrt(I/(m g d))."""
    case = pendulum(tmp_path, {"rho": 1, "freeRotation": "(z)"}, 2.2,
                    displacement=lifted(about("z", 1e-3)), **HANGING)
    L = case.momentum["body:Lz"]
    t = case.momentum["Time"]
    up = np.flatnonzero((L[:-1] < 0) & (L[1:] >= 0))
    zero = t[up] - L[up]*(t[up + 1] - t[up])/(L[up + 1] - L[up])
    with figures("compound pendulum") as f:
        f.within("period / theory", np.diff(zero).mean()/PERIOD, 1, 1e-5)
        f.atMost("energy balance", largest(case.energies["total:balance"])
                / largest(case.energies["total:kinetic"]), 1e-4)


@pytest.mark.parametrize("motion", ("in a plane", "in space"))
def test_given_mass_is_that_of_the_mesh(tmp_path, figures, motion):
    """A pendulum has the given mass, centre and inertia, and the mesh of a
    brick at another place. It swings like a pendulum that has them from its
    mesh and density. Also a rod that hangs obliquely, whose inertia has all
    components, and that is thrown round."""
    rho = 3.0
    mass = rho*np.prod(ROD)
    R = np.eye(3)
    free, motionOf = {"freeRotation": "(z)"}, {
        "displacement": lifted(about("z", 1))}
    if motion == "in space":
        R = about("x", 0.4) @ about("z", -0.7) @ about("y", 0.3)
        free, motionOf = {}, {"velocity": spinning((0, 0, 0), (2, 5, -3))}
    square = np.array(ROD)**2/12
    inertia = R @ np.diag(mass*(square.sum() - square)) @ R.T
    given = {"mass": mass, "inertia": inertia[np.triu_indices(3)],
             "centreOfMass": R @ (0, -ROD[1]/2, 0)}
    cases = [pendulum(tmp_path/name, {**material, **free}, 1, 500, **motionOf,
                      **mesh) for name, material, mesh in (
        ("mesh", {"rho": rho}, {**HANGING, "moved": lambda X: X @ R.T}),
        ("given", given, {
            "size": (0.3, 0.2, 0.1), "start": (0.5, 0.1, 0.2)}))]
    with figures(f"pendulum {motion}, mass given or from the mesh") as f:
        a, b = (case.angularMomentumOf() for case in cases)
        f.atMost("angular momentum, difference / largest",
                 largest(a - b)/largest(a), 1e-12)
        a, b = (case.momentumOf() for case in cases)
        f.atMost("momentum, difference / largest",
                 largest(a - b)/largest(a), 1e-12)
        a, b = (case.energies["total:externalWork"] for case in cases)
        f.atMost("work of gravity, difference / largest",
                 largest(a - b)/largest(a), 1e-12)
        f.atLeast("largest work / (mass g length)",
                  largest(a)/(mass*GRAVITY*ROD[1]), 0.1)


@pytest.mark.parametrize("grows", (False, True), ids=("constant", "grows"))
@pytest.mark.parametrize("kind, axis", (
    ("3D", "x"), ("3D", "y"), ("3D", "z"), ("axis", "x"), ("2D", "z")))
def test_moment_about_a_principal_axis(tmp_path, figures, kind, axis, grows):
    """A free brick under a moment about one of its axes rotates by M t^2/(2
    I), exactly in the leapfrog. Under a moment that grows from zero it rotates
    by M t^2/(6 I) (1 - 1/n^2), with n steps."""
    size, rho, steps, time, angle = np.array((1, 0.5, 0.3)), 2.0, 40, 3.0, 2.5
    cells = (2, 2) if kind == "2D" else (2, 1, 2)
    if kind == "2D":
        size[2] = 1
    i = "xyz".index(axis)
    across = np.delete(size, i)
    mass = rho*np.prod(size)
    inertia = mass*np.sum(across**2)/12
    n = np.eye(3)[i]
    M = angle*inertia/time**2*(6 if grows else 2)
    moment = table((0, (0, 0, 0)), (time, M*n)) if grows else M*n
    body = Body(cells=cells, size=tuple(size), start=-size/2, material=rigid(
        rho=rho, moment=moment,
        **({"freeRotation": f"({axis})"} if kind == "axis" else {})))
    case = SmallCase(tmp_path, body, time, preset=DEFAULT,
                     control={**FIXED, "deltaT": time/steps}).run()
    turn = angle*(1 - 1/steps**2 if grows else 1)
    D, e = case.at("pointD"), case.energies
    kinetic = (M*time*(0.5 if grows else 1))**2/(2*inertia)
    name = "growing moment" if grows else "moment"
    with figures(f"{name} about {axis}, {kind}") as f:
        f.atMost("displacement from that of the angle / size",
                 largest(D - lifted(about(axis, turn))(case.X())), 1e-13)
        f.within("kinetic energy / theory", e["total:kinetic"][-1]/kinetic, 1,
                 1e-13)
        # The last half of a step has the power at its end
        f.within("work of the moment / kinetic energy",
                 e["total:externalWork"][-1]/kinetic, 1, 1.01/steps**2)
        f.atMost("momentum / (mass times speed of the corner)", largest(
            case.momentumOf())/(mass*angle/time), 1e-14)


def test_pivot_holds_from_the_first_step(tmp_path, figures):
    """A brick spins about a vertical edge. The pivot pulls with m w^2 r and
    provides the moment of the products of inertia, in each step. The momentum
    is that half a step earlier. (In the first step the force was twice as
    large.)"""
    spin, step, size = 2.0, 0.003, np.array((1, 0.6, 0.2))
    mass, arm = size.prod(), np.hypot(*size[:2])/2
    body = Body((2, 2, 2), size=tuple(size), velocity=spinning(
        (0, 0, 0), (0, 0, spin)), material=rigid(
            pivot=(0, 0, 0), freeRotation="(z)"))
    case = SmallCase(tmp_path, body, 100*step, preset=DEFAULT, control={
        **FIXED, "deltaT": step}, functions=("reactionForces",)).run()
    r = readResults.table(case.path, "reactionForces", "reactions.dat")
    force = np.hypot(r["body:Fx"], r["body:Fy"])[1:]
    moment = np.hypot(r["body:Mx"], r["body:My"])[1:]
    p = case.momentumOf()[1:]
    turned = spin*step*(np.arange(len(p)) + 0.5) + np.arctan2(*size[1::-1])
    exact = mass*spin*arm*np.stack((-np.sin(turned), np.cos(turned)), 1)
    with figures("pivot of a brick that spins") as f:
        f.atMost("force / theory - 1", largest(
            force/(mass*spin**2*arm) - 1), 1e-4)
        f.atMost("moment / theory - 1", largest(
            moment/(mass*spin**2*arm*size[2]/2) - 1), 1e-4)
        f.atMost("momentum, difference / largest",
                 largest(p[:, :2] - exact)/largest(exact), 1e-12)


def test_heavy_top(tmp_path, figures):
    """A square top spins on its tip, tilted by 30 degrees, with the initial
    motion of steady precession. It continues this motion at the rate that
    solves I1 cos(tilt) W^2 - I3 spin W + m g d = 0. The error of the rate and
    the remaining nutation fall with the square of the step."""
    width, thick, d, tilt, spin = 0.6, 0.1, 0.2, np.pi/6, 40.0
    mass = width**2*thick
    I3 = mass*width**2/6
    I1 = mass*(width**2 + thick**2)/12 + mass*d**2
    a, b, c = I1*np.cos(tilt), I3*spin, mass*GRAVITY*d
    rate = 2*c/(b + np.sqrt(b**2 - 4*a*c))
    period = 2*np.pi/rate
    R = about("y", tilt)
    up, axis = np.array((0, 0, 1)), R[:, 2]
    omega = rate*up + (spin - rate*np.cos(tilt))*axis
    body = Body(cells=(1, 1, 1), size=(width, width, thick),
                start=(-width/2, -width/2, d - thick/2),
                displacement=lifted(R), material=rigid(pivot=(0, 0, 0)),
                velocity=lambda X: np.cross(omega, X @ R.T))
    errors, nutations = [], []
    for steps in 3000, 6000:
        case = SmallCase(
            tmp_path/f"{steps}", body, period, gravity=(0, 0, -GRAVITY),
            preset=DEFAULT, control={
                **FIXED, "deltaT": period/steps, "functions": {
                    name: {"type": name, "libs": "(vertexContact)",
                           **more, **EACH_STEP}
                    for name, more in (
                        ("solidEnergies", {}),
                        ("solidAverages", {"fields": "(pointD)"}))}}).run()
        means = readResults.table(case.path, "solidAverages", "averages.dat")
        x = np.array([means[f"body:pointD.{k}"] for k in "xyz"]).T + (0, 0, d)
        azimuth = np.unwrap(np.arctan2(x[:, 1], x[:, 0]))
        errors.append(abs(azimuth[-1]/(2*np.pi) - 1))
        nutations.append(largest(np.arccos(x[:, 2]/d) - tilt))
    L, E = case.angularMomentumOf(), case.energies
    with figures("heavy top in steady precession") as f:
        f.atMost("azimuth after a period / theory - 1", errors[1], 1e-5)
        f.within("ratio of two steps", errors[0]/errors[1], 4, 0.2)
        f.atMost("change of the tilt", nutations[1], 1e-5)
        f.within("ratio of two steps", nutations[0]/nutations[1], 4, 0.2)
        f.atMost("angular momentum about the vertical, change / size",
                 largest(L[:, 2] - L[0, 2])/L[0, 2], 1e-13)
        f.atMost("distance of the centre from the tip, change / size",
                 largest(np.linalg.norm(x, axis=1)/d - 1), 1e-13)
        f.atMost("balance of the energy / kinetic", largest(
            E["total:balance"])/E["total:kinetic"][0], 1e-6)


def test_probe_of_a_rigid_region(tmp_path, figures):
    """A probe follows a rigid region in each step, also at a node without
    contact."""
    v, spin, end = np.array((1, -2, 0.5)), 3.0, 0.4
    corner = np.array((0.5, 0.5, 0.5))
    case = SmallCase(
        tmp_path, Body(cells=(2, 2, 2), start=(-0.5, -0.5, -0.5),
                       material={"type": "rigid", "rho": 1},
                       velocity=spinning((0, 0, 0), (0, 0, spin), v)),
        end, control={**FIXED, "deltaT": end/100}, preset=DEFAULT,
        probes={"corner": ("body", corner)}).run()
    t, D = case.probe("corner", "pointD")
    _, U = case.probe("corner", "pointU")
    r = np.vstack([turned(corner, (0, 0, 1), spin*s) for s in t])
    expected = r - corner + np.outer(t, v)
    with figures("probe of a free rigid cube") as f:
        f.atMost("displacement", largest(D.reshape(-1, 3) - expected), 1e-12)
        f.atMost("velocity", largest(
            U.reshape(-1, 3) - v - np.cross((0, 0, spin), r)), 1e-12)


def test_bounce_keeps_momenta(tmp_path, figures):
    """A spinning rigid cuboid bounces off a free soft block, off centre:
    linear and angular momentum of the pair are conserved, and energy only
    dissipates."""
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
    """'surfaces all' gives the result of the named pair."""
    named = toolAndBlock(tmp_path/"named")
    general = toolAndBlock(tmp_path/"general", contact={
        "all": {"surfaces": "all", "law": coulomb(0.3)}})
    a, b = (case.energies["total:contactWork"] for case in (named, general))
    with figures("rigid tool on a block, all surfaces") as f:
        f.atMost("contact work, difference / largest",
                 largest(a - b)/largest(a), 1e-10)


def test_known_before_the_run(tmp_path):
    """-dry-run and checkContact accept rigid regions."""
    case = toolAndBlock(tmp_path)
    for command in (("vertexContactFoam", "-dry-run"),
                    ("checkContact", "-time", "0")):
        done = execute(command, case.path)
        assert done.returncode == 0, done.stdout
        assert "tool" in done.stdout


def test_parallel(tmp_path, figures):
    """Two ranks, which divide both bodies, give the result of one."""
    one = toolAndBlock(tmp_path/"one")
    two = toolAndBlock(tmp_path/"two", ranks=2)
    with figures("rigid tool on a block, 2 ranks against 1") as f:
        for name in "total:kinetic", "total:externalWork", "total:contactWork":
            f.atMost(name, largest(one.energies[name] - two.energies[name])
                     / largest(one.energies["total:kinetic"]), 1e-10)
        a, b = (run.angularMomentumOf("tool") for run in (one, two))
        f.atMost("angular momentum", largest(a - b)/largest(a), 1e-10)


def test_restart(tmp_path):
    """A run that is continued from half of the time ends with the same
    bits."""
    whole = toolAndBlock(tmp_path/"whole")
    again = toolAndBlock(tmp_path/"again", 0.5, control={"writeInterval": 0.5})
    again.set("system/controlDict", {"endTime": 1})
    again.run()
    for region in "tool", "block":
        for name in "pointD", "pointU", "lm":
            assert np.array_equal(whole.at(name, region=region),
                                  again.at(name, region=region)), name


def test_sub_cycling(tmp_path, figures):
    """With subCycling the rigid region takes the shortest step."""
    one = toolAndBlock(tmp_path/"one")
    own = toolAndBlock(tmp_path/"own", control={"subCycling": "yes"})
    with figures("rigid tool on a block, subCycling") as f:
        for name in "total:kinetic", "total:contactWork":
            f.within(f"{name}, of one step",
                     own.energies[name][-1]/one.energies[name][-1], 1, 1e-6)


@pytest.mark.parametrize("motion", ("displacement", "velocity"))
def test_moved_plate_is_as_an_obstacle(tmp_path, figures, motion):
    """A moved plate presses like an obstacle with the same motion, up to the
    difference between overlaps of faces and corners."""
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


def test_squeezed_pad(tmp_path, figures):
    """A rubber pad between two plates, without friction. It stretches along
    them, and vibrates. Contact does no work, as between obstacles: each node
    gets the force of its own stretched area. With the mean stretch of both
    sides, contact gave it a tenth of its energy."""
    time, deep = 400, 0.05
    motion = {"displacement": table((0, (0, 0, 0)), (0.75*time, (0, -deep, 0)),
                                    (2*time, (0, -deep, 0)))}
    means = {}
    with figures("a pad between plates") as f:
        for kind in "regions", "obstacles":
            bodies = [Body((40, 4), name="pad", start=(-5, 0, 0),
                           size=(10, 1, 1), material={**RUBBER, "nu": 0.46},
                           sides={"bottom": "contact", "top": "contact"})]
            roof = {**FLOOR, "pointAndNormalDict": {"point": (0, 1, 0),
                                                    "normal": (0, -1, 0)}}
            law = {"law": {"type": "frictionless"}}
            interfaces = {
                "low": {"side": ("pad", "bottom"), "obstacle": FLOOR, **law},
                "high": {"side": ("pad", "top"), "obstacle": roof,
                         "motion": motion, **law}}
            if kind == "regions":
                bodies += [
                    Body((16, 1), name="base", start=(-8, -1, 0),
                         size=(16, 1, 1), sides={"top": "contact"},
                         material=rigid(freeTranslation=(), freeRotation=())),
                    Body((16, 1), name="plate", start=(-8, 1, 0),
                         size=(16, 1, 1), sides={"bottom": "contact"},
                         material=rigid(motion=motion),
                         velocity=(0, -deep/(0.75*time), 0))]
                interfaces = {
                    "low": interface(("pad", "bottom"), ("base", "top"),
                                     pairing="nearestFace"),
                    "high": interface(("pad", "top"), ("plate", "bottom"),
                                      pairing="nearestFace")}
            case = SmallCase(tmp_path/kind, bodies, time, interfaces,
                             functions=("contactForces",), preset=DEFAULT,
                             control={"maxCo": 0.9}).run()
            contact = case.contact("high")
            force = -contact["pad.top:Fy"][contact["Time"] > 0.9*time]
            means[kind] = force.mean()
            f.atMost(f"{kind}: scatter of the force / mean",
                     force.std()/force.mean(), 0.05)
            if kind == "regions":
                f.atMost("work of contact / strain energy",
                         largest(case.energies["total:contactWork"])
                         / case.energies["total:strain"][-1], 1e-3)
        f.within("force / that between obstacles",
                 means["regions"]/means["obstacles"], 1, 1e-3)


SWINGING = {
    "displacement": {"displacement": "sine", "displacementCoeffs": {
        "frequency": 100, "amplitude": 1, "scale": (0, 0.001, 0),
        "level": (0, 0, 0)}},
    "oscillatingLinearMotion": {
        "solidBodyMotionFunction": "oscillatingLinearMotion",
        "oscillatingLinearMotionCoeffs": {
            "amplitude": (0, 0.001, 0), "omega": 200*np.pi}}}


@pytest.mark.parametrize("motion", SWINGING)
def test_start_of_a_motion(tmp_path, figures, motion):
    """A region with a motion starts with its velocity, for any length of the
    run. A finished case can be looked at and continued."""
    case = SmallCase(tmp_path, [
        Body(cells=(2, 2), name="tool", start=(0, 1.5, 0), material=rigid(
            motion=SWINGING[motion])), Body(cells=(2, 2), name="pad")], 1000,
        control={"stopAt": "nextWrite", "writeInterval": 0.01},
        preset=DEFAULT).run()
    last = float(timeFolders(case.path)[-1])
    case.set("system/controlDict", {"stopAt": "endTime", "endTime": last})
    codes = [execute(c, case.path).returncode for c in (
        ["vertexContactFoam"], ["vertexContactFoam", "-dry-run"],
        ["checkContact"])]
    with figures(f"region that swings by {motion}, at its start") as f:
        f.within("velocity / of the motion", case.momentumOf("tool")[0, 1]
                 / (0.2*np.pi), 1, 1e-7)
        f.equal("ended, started again, looked at: exit codes", codes, [0]*3)


@pytest.mark.parametrize("free", ("x y z", "x z", "y", ""))
def test_constant_force(tmp_path, figures, free):
    """Free directions with gravity and a force at the centre move by v t +
    (F/m + g) t^2/2. The other directions do not move."""
    force, speed, time = np.array((1, -2, 3)), np.array((0.3, 0.2, -0.1)), 2.0
    may = np.array([c in free for c in "xyz"], dtype=float)
    case = SmallCase(tmp_path, Body(
        cells=(1, 1, 1), size=(1, 0.5, 2), velocity=speed, material=rigid(
            rho=4, freeTranslation=f"({free})", force=force)), time,
        gravity=(0, -3, 0), control={**FIXED, "deltaT": 0.1},
        preset=DEFAULT).run()
    way = may*(speed*time + (force/4 - (0, 3, 0))*time**2/2)
    with figures(f"rigid body under a force, free in ({free})") as f:
        f.atMost("way from theory / largest",
                 largest(case.at("pointD") - way)/7, 1e-12)


def turning(axis, angle, origin):
    """A motion that rotates by this angle in a second."""
    return {"solidBodyMotionFunction": "rotatingMotion",
            "rotatingMotionCoeffs": {
                "origin": origin, "axis": axis, "omega": angle}}


def test_turning_region(tmp_path, figures):
    """A rigid region with a rotation is at the rotated position. Its momentum
    is that at the middle of the last step."""
    n, angle, origin = (0.48, 0.6, 0.64), 1.62, np.array((0.5, -4, 0.5))
    steps = 100
    case = SmallCase(tmp_path, Body(cells=(2, 2, 2), material=rigid(
        motion=turning(n, angle, origin))), 1, preset=DEFAULT,
        control={**FIXED, "deltaT": 1/steps}).run()
    r = case.X() - origin
    way = turned(r, n, angle) - r
    U = angle*np.cross(n, turned(r, n, angle*(1 - 0.5/steps)))
    with figures("rigid region that a motion turns") as f:
        f.atMost("way from theory / largest",
                 largest(case.at("pointD") - way)/largest(way), 1e-13)
        f.atMost("momentum per mass from theory / largest", largest(
            case.at("lm") - U)/largest(U), 0.1*(angle/steps)**2)


# Angular velocities, and the angle at the time 1. Beyond their ends tables
# keep their first and last values
OMEGAS = {
    "from rest": (table((0, 0), (10, 1)), 0.05),
    "point at 0": (table((-1, 0), (0, 0.5), (2, 1)), 0.625),
    "begins late": (table((0.5, 1), (2, 1)), 1),
    "ends early": (table((0, 0), (0.5, 1)), 0.75),
    "in parts": (None, 0.05)}


@pytest.mark.parametrize("name", OMEGAS)
def test_turned_by_a_table(tmp_path, figures, name):
    """A table of the angular velocity rotates a region by its integral, also
    in a run that continues from the middle. OpenFOAM's own function fails at
    time 0."""
    omega, angle = OMEGAS[name]
    origin, n, steps = np.array((0.5, -1, 0.5)), (0, 0, 1), 100
    motion = turning(n, omega, origin) if omega else {
        "solidBodyMotionFunction": "multiMotion", "multiMotionCoeffs": {
            "one": turning(n, table((0, 0), (10, 0.5)), origin),
            "two": turning(n, table((0, 0), (10, 0.5)), origin)}}
    case = SmallCase(tmp_path, Body(cells=(2, 2, 2), material=rigid(
        motion=motion)), 0.5, preset=DEFAULT,
        control={**FIXED, "deltaT": 1/steps}).run()
    case.set("system/controlDict", {"endTime": 1})
    case.run()
    r = case.X() - origin
    way = turned(r, n, angle) - r
    with figures(f"rigid region turned by a table, {name}") as f:
        f.atMost("way from theory / largest",
                 largest(case.at("pointD") - way)/largest(way), 1e-12)


def test_turned_from_time_0(tmp_path, figures):
    """OpenFOAM's axisRotationMotion divides by zero at time 0."""
    rate, origin = 30, np.array((0.5, -1, 0.5))
    case = SmallCase(tmp_path, Body(cells=(2, 2, 2), material=rigid(motion={
        "solidBodyMotionFunction": "axisRotationMotion",
        "origin": origin, "radialVelocity": (0, 0, rate)})), 1,
        preset=DEFAULT, control={**FIXED, "deltaT": 0.01}).run()
    r = case.X() - origin
    way = turned(r, (0, 0, 1), np.radians(rate)) - r
    with figures("rigid region turned by axisRotationMotion") as f:
        f.atMost("way from theory / largest",
                 largest(case.at("pointD") - way)/largest(way), 1e-12)


# Displacement, velocity and angle of motions
def waves(t):
    return np.array((0.3*np.sin(2*t), 0, 0.1*np.cos(3*t) - 0.1))


def wavesRate(t):
    return np.array((0.6*np.cos(2*t), 0, -0.3*np.sin(3*t)))


def listedMotion(function):
    """A table with intervals that are small compared with the step."""
    return table(*((t, tuple(function(t))) for t in np.linspace(0, 1.1, 4401)))


MOVED = {
    "displacement": ({"displacement": listedMotion(waves)},
                     lambda X, t: np.tile(wavesRate(t), (len(X), 1))),
    "velocity": ({"velocity": listedMotion(wavesRate)},
                 lambda X, t: np.tile(wavesRate(t), (len(X), 1))),
    "linear": ({"solidBodyMotionFunction": "oscillatingLinearMotion",
                "oscillatingLinearMotionCoeffs": {
                    "amplitude": (0.2, 0, 0.1), "omega": 3}},
               lambda X, t: np.tile(3*np.cos(3*t)*np.array((0.2, 0, 0.1)),
                                    (len(X), 1))),
    "rotation": ({"solidBodyMotionFunction": "oscillatingRotatingMotion",
                  "oscillatingRotatingMotionCoeffs": {
                      "origin": (0.5, -1, 0.5), "amplitude": (0, 0, 40),
                      "omega": 3}},
                 lambda X, t: np.cross(
                     (0, 0, np.radians(40)*3*np.cos(3*t)), turned(
                         X - (0.5, -1, 0.5), (0, 0, 1),
                         np.radians(40)*np.sin(3*t))))}


@pytest.mark.parametrize("name", MOVED)
def test_velocity_of_a_moved_region(tmp_path, figures, name):
    """The written velocity is that of the motion at the time of the
    displacement, to second order in the step. The same holds for free
    directions across the motion."""
    motion, theory = MOVED[name]
    errors = []
    for steps in 20, 40:
        free = {} if name == "rotation" else {
            "freeTranslation": "(y)", "force": (0, 1, 0)}
        case = SmallCase(
            tmp_path/f"{steps}", Body(cells=(2, 2, 2), material=rigid(
                motion=motion, **free)), 1, preset=DEFAULT,
            control={**FIXED, "deltaT": 1/steps}).run()
        U = theory(case.X(), 1)
        if free:
            U[:, 1] = 1
        errors.append(largest(case.at("pointU") - U)/largest(U))
    with figures(f"rigid region with the motion {name}") as f:
        f.atMost("pointU from theory / largest", errors[1], 2e-3)
        if errors[1] > 1e-10:
            f.within("ratio of two steps", errors[0]/errors[1], 4, 0.5)


@pytest.mark.parametrize("omega", (0.05, table((0, 0), (10, 1))))
def test_turning_obstacle(tmp_path, figures, omega):
    """An obstacle that rotates below a block is at the rotated position: the
    gaps of the block show it."""
    n, angle, origin = (0.6, 0, 0.8), 0.05, np.array((-1, -0.2, 0.3))
    case = SmallCase(tmp_path, Body(
        cells=(4, 4, 4), name="block", sides={"bottom": "contact"}), 1,
        interfaces={"c": {
            "side": ("block", "bottom"), "law": {"type": "frictionless"},
            "motion": turning(n, omega, origin), "obstacle": {
                "type": "plane", "planeType": "pointAndNormal",
                "pointAndNormalDict": {"point": origin,
                                       "normal": (0, 1, 0)}}}},
        preset=DEFAULT).run()
    X = case.X()
    bottom = X[:, 1] == 0
    gap = (X[bottom] - origin) @ turned(np.eye(3)[1:2], n, angle)[0]
    with figures("plane that a motion turns") as f:
        f.atMost("gaps from theory / width", largest(
            case.at("contactGap")[bottom, 0] - gap), 1e-12)
        f.atLeast("change of a gap by the turn / width",
                  largest(gap - 0.2), 0.05)
        f.atMost("displacement of the block", largest(case.at("pointD")),
                 1e-15)


def test_rest(tmp_path, figures):
    """A rigid block lies on a soft one under gravity, at the sag of the static
    solution (a column without lateral strain). It stays at rest."""
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


# Supports of a rigid region

def reaction(case, name, kind):
    """A vector of reactionForces, with a row per step."""
    columns = readResults.table(case.path, "reactionForces", "reactions.dat")
    return np.array([columns[f"{name}:{kind}{c}"] for c in "xyz"]).T


def histories(*names, **more):
    """Function objects with a row per step."""
    return {"functions": {name: {
        "type": name, "libs": "(vertexContact)", **EACH_STEP,
        **more.get(name, {})} for name in ("solidEnergies", *names)}}


@pytest.mark.parametrize("free", ("about its axis", "about all"))
def test_force_of_a_pivot(tmp_path, figures, free):
    """A pendulum released at 60 degrees. The pivot bears m g cos + m d w^2
    along the rod and m g sin (1 - m d^2/I) across it, with w from the energy.
    An axis also bears the moment of a force along the axis at the middle of
    the rod."""
    mass, d, side = np.prod(ROD), ROD[1]/2, 0.01
    inertia = ROD_INERTIA + d**2
    axis = free == "about its axis"
    errors = []
    for steps in 1000, 2000:
        case = SmallCase(
            tmp_path/f"{steps}", Body(
                cells=(1, 2, 1), **HANGING,
                displacement=lifted(about("z", np.pi/3)), material=rigid(
                    pivot=(0, 0, 0), **({"freeRotation": "(z)", "force":
                                         (0, 0, side)} if axis else {}))),
            0.6*PERIOD, gravity=(0, -GRAVITY, 0), preset=DEFAULT, control={
                **FIXED, "deltaT": PERIOD/steps, **histories(
                    "reactionForces", "solidAverages",
                    solidAverages={"fields": "(pointD)"})}).run()
        means = readResults.table(case.path, "solidAverages", "averages.dat")
        down = np.array([means["body:pointD.x"],
                         means["body:pointD.y"] - d]).T/d
        # The force acts at the start of the step
        cos, sin = -down[:-1, 1], down[:-1, 0]
        along = GRAVITY*(cos + 2*d**2/inertia*(cos - 0.5))
        across = GRAVITY*sin*(1 - d**2/inertia)
        theory = mass*np.array((-along*sin + across*cos,
                                along*cos + across*sin)).T
        F = reaction(case, "body", "F")[1:]
        errors.append(largest(F[:, :2] - theory)/(mass*GRAVITY))
    M = reaction(case, "body", "M")[1:]
    lever = d*np.array((cos, sin)).T
    with figures(f"pivot of a pendulum, free {free}") as f:
        f.atMost("force from theory / weight", errors[1], 1e-5)
        f.within("ratio of two steps", errors[0]/errors[1], 4, 0.4)
        f.atLeast("largest force / weight",
                  largest(F)/(mass*GRAVITY), 1.7)
        f.atMost("force along the axis from theory / weight", largest(
            F[:, 2] + axis*side)/(mass*GRAVITY), 1e-12)
        f.atMost("moment from theory / weight times length", largest(
            M[:, :2] - axis*side*lever)/(mass*GRAVITY*d), 1e-12)


def test_reactions_of_a_moved_region(tmp_path, figures):
    """A motion presses a plate on a block; the other directions of the plate
    are held. Reaction, contact and weight equal the change of its momentum to
    round-off, and the work of the reaction equals that of the energies."""
    g = 0.01
    block = Body(cells=(10, 8), name="block", material=RUBBER, sides={
        "bottom": condition("fixedVelocity", velocity=(0, 0, 0)),
        "top": "contact"})
    plate = Body(cells=(3, 2), name="plate", start=(0.1, 1.001, 0),
                 size=(1.2, 0.3, 1), sides={"bottom": "contact"},
                 material=rigid(rho=2, force=(0.001, 0, 0), motion={
                     "displacement": table(
                         *((t, (0, -0.03*t**2, 0))
                           for t in np.linspace(0, 2, 50)))}))

    def scene(name, endTime, **control):
        return SmallCase(
            tmp_path/name, [block, plate], endTime, gravity=(0, -g, 0),
            interfaces={"c": interface(
                ("plate", "bottom"), ("block", "top"), coulomb(0.3),
                pairing="nearestFace")}, preset=DEFAULT, control={
                **histories("reactionForces", "contactForces"), **control})
    case = scene("case", 1.5, maxCo=0.1, writeInterval=0.75).run()
    columns = readResults.table(case.path, "reactionForces", "reactions.dat")
    t = columns["Time"]
    halfBack = (t - np.diff(t, prepend=0)/2)[1:, None]
    contact = case.contact("c")
    impulse = np.array([contact[f"plate.bottom:I{c}"] for c in "xyz"]).T
    p = case.momentumOf("plate")
    weight = 2*0.36*g
    total = (reaction(case, "plate", "I")[1:] + impulse
             + halfBack*np.array((0.001, -weight, 0)))
    # Without the work of the weight, and without the jolt at the start
    external = case.energies["plate:externalWork"]
    work = ((external[1:] + external[:-1])/2 - weight*0.03*halfBack[:, 0]**2)
    with figures("plate that a motion presses on a block") as f:
        f.atMost("impulses from the change of momentum / largest",
                 largest(p[1:] - p[0] - total)/largest(p), 1e-12)
        f.atMost("work of the reaction from that of the energies / largest",
                 largest((columns["plate:work"][1:] - work)[1:])
                 / largest(work), 0.01)
        f.atLeast("work", work[-1], 1e-4)
        f.atLeast("largest moment / weight times length",
                  largest(reaction(case, "plate", "M"))/weight, 0.05)

    again = scene("again", 0.75, maxCo=0.1).run()
    again.set("system/controlDict", {"endTime": 1.5})
    again.run()
    own = scene("own", 1.5, writeInterval=0.75, subCycling="yes").run()
    two = scene("two", 1.5, maxCo=0.1, writeInterval=0.75).runParallel(2)
    I = reaction(case, "plate", "I")
    with figures("the same in two runs, on two ranks, with own steps") as f:
        for name, its, limit in (
                ("two runs", reaction(again, "plate", "I")[-1] - I[-1], 1e-12),
                ("ranks", reaction(two, "plate", "I")[-1] - I[-1], 1e-9),
                ("own steps", reaction(own, "plate", "I")[-1] - I[-1], 0.02)):
            f.atMost(f"{name}, difference of the impulse / largest",
                     largest(its)/largest(I), limit)


def test_weight_on_a_held_region(tmp_path, figures):
    """A block lies at rest on a fixed plate, off its middle: the plate bears
    both weights and the moment of the block."""
    g, arm, rho = 0.01, 0.3, 2
    column = {"type": "linearElastic", "rho": 1, "E": 1, "nu": 0}
    block = Body(cells=(4, 6), name="block", start=(0.5 + arm, 0, 0),
                 sides={"bottom": "contact"}, material=column,
                 displacement=lambda X: -g*(X[:, 1] - X[:, 1]**2/2)[:, None]
                 * np.array((0, 1, 0)))
    plate = Body(cells=(4, 1), name="plate", start=(0, -0.5, 0),
                 size=(2, 0.5, 1), sides={"top": "contact"}, material=rigid(
                     rho=rho, freeTranslation="()", freeRotation="()"))
    case = SmallCase(tmp_path, [block, plate], 20, gravity=(0, -g, 0),
                     interfaces={"c": interface(
                         ("block", "bottom"), ("plate", "top"),
                         pairing="nearestFace")}, preset=DEFAULT,
                     control={"maxCo": 0.9,
                              **histories("reactionForces")}).run()
    F, M = (reaction(case, "plate", kind) for kind in "FM")
    half = len(F)//2
    with figures("block on a plate that is held") as f:
        f.within("force / weights", F[half:, 1].mean()/(g*(1 + rho)), 1, 2e-3)
        f.within("moment / weight of the block times its lever",
                 M[half:, 2].mean()/(g*arm), 1, 5e-3)


def test_warning_of_the_start_velocity(tmp_path, figures):
    """The warning comes once if pointU is not the motion of a rigid body. It
    never comes in a restarted run with a rotating body."""
    said = []
    for name, U in (("turns", spinning((0.5, 0.5, 0), (0, 0, 2))),
                    ("shears", lambda X: X[:, 1:2]*np.array((1, 0, 0)))):
        case = SmallCase(tmp_path/name, Body(
            cells=(3, 3), velocity=U, material=rigid()), 0.1,
            control={**FIXED, "deltaT": 0.01}, preset=DEFAULT)
        for end in 0.1, 0.2:
            case.set("system/controlDict", {"endTime": end})
            said.append("this rigid body cannot move" in case.attempt()[1])
    with figures("warnings of the velocity at the start") as f:
        f.equal("turns, restarted, shears, restarted", said,
                [False, False, True, False])


@pytest.mark.parametrize("dimensions", (2, 3))
def test_displacements_of_no_rigid_body(tmp_path, figures, dimensions):
    """The warning comes if pointD is not the motion of a rigid body, but not
    for one with six digits, and never in a restarted run. A body that is
    turned inside out is an error."""
    def away(X):
        return turned(X, (0, 0, 1), 0.5) - X + (9, 4, 0)
    said = {}
    for name, displacement in (
            ("moves", away), ("rests", lambda X: 0*X),
            ("digits", np.vectorize(lambda X: float(f"{X:.6g}"))),
            ("stretches", lambda X: X*(1e-4, 0, 0)),
            ("mirrors", lambda X: X*(-2, 0, 0))):
        case = SmallCase(tmp_path/name, Body(
            cells=(3,)*dimensions, material=rigid(), displacement=(
                lambda X: displacement(away(X))) if name == "digits"
            else displacement), 0.1,
            control={**FIXED, "deltaT": 0.01}, preset=DEFAULT)
        said[name] = []
        for end in 0.1, 0.2:
            case.set("system/controlDict", {"endTime": end})
            code, log = case.attempt()
            said[name].append(
                "inside out" in log and "0/body/pointD" in log if code else
                "cannot have the displacements of pointD" in log)
    with figures(f"displacements at the start, rigid, {dimensions}D") as f:
        f.equal("said", said, {
            "moves": [False, False], "rests": [False, False],
            "digits": [False, False], "stretches": [True, False],
            "mirrors": [True, True]})


@pytest.mark.parametrize("U, warned", (
    ((0, -0.05, 0), True), ((0, -0.2, 0), False), ((0, 0, 0), False),
    ((0.1, 0, 0), False), ((0.1, -0.2, 0), False)))
def test_warning_of_a_start_against_the_motion(tmp_path, U, warned):
    """pointU may have the free motion only, or the whole motion; x is free."""
    case = SmallCase(tmp_path, Body(cells=(2, 2), velocity=U, material=rigid(
        motion={"velocity": (0, -0.2, 0)}, freeTranslation="(x)")), 0.1,
        control={**FIXED, "deltaT": 0.01}, preset=DEFAULT)
    code, log = case.attempt()
    assert code == 0, log
    assert ("this rigid body cannot move" in log) == warned, log


def moved(name, beside=None, **coeffs):
    return {"motion": {"solidBodyMotionFunction": name,
                       f"{name}Coeffs": coeffs, **(beside or {})}}


TURN = {"origin": (0, 0, 0), "axis": (0, 0, 1), "omega": 1}
BAD = {
    "axis": (moved("rotatingMotion", **{**TURN, "axis": (0, 0, 0)}),
             "'axis' is (0 0 0)"),
    "rate": (moved("rotatingMotion", **{**TURN, "omega": "sine"}, omegaCoeffs={
        "frequency": 1, "amplitude": 1, "scale": 1, "level": 0}),
        "'omega' is the function sine"),
    "coefficient": (moved("rotatingMotion", **TURN, omeag=1),
                    "'omeag'. Did you mean 'omega'"),
    "beside": (moved("linearMotion", {"velcity": (0, 0, 5)},
                     velocity=(0, 1, 0)), "'velcity'"),
    "without Coeffs": ({"motion": {
        "solidBodyMotionFunction": "rotatingMotion", **TURN, "axsi": 1}},
        "'axsi'. Did you mean 'axis'"),
    "no pose": (moved("drivenLinearMotion", CofGvelocity="U"),
                "no position at a given time"),
    "no motion": (moved("multiMotion"), "multiMotion"),
    "no dictionary": (moved("multiMotion", a=1), "'a' of multiMotion"),
    "part": (moved("multiMotion", a={
        "solidBodyMotionFunction": "linearMotion", "linearMotionCoeffs": {
            "velocity": (0, 0, 0), "velcity": 1}}), "'velcity'"),
    "no table": (moved("tabulated6DoFMotion", CofG=(0, 0, 0),
                       timeDataFileName='"missing"'), "Cannot open"),
    "nothing held": ({"motion": {"velocity": (0, 1, 0)},
                      "freeTranslation": "(x y z)"}, "'freeTranslation'"),
    "free, too": ({"motion": {"velocity": (1, 2, 0)},
                   "freeTranslation": "(y)"}, "'freeTranslation' 1(y)"),
    "free, as a function": (
        {"freeTranslation": "(y z)", **moved(
            "linearMotion", velocity=(1, 0, 2))}, "'freeTranslation' 2(y z)"),
    "both": ({"mass": 1}, "mass"),
    "axes": ({"freeRotation": "(x y)"}, "freeRotation"),
    "direction": ({"freeTranslation": "(up)"}, "freeTranslation"),
    "pivot": ({"pivot": (0, 0, 0), "motion": {"velocity": (0, 0, 0)}},
              "motion"),
    "motion": ({"motion": {"velocity": (0, 0, 0),
                           "displacement": (0, 0, 0)}}, "motion"),
    "sine": ({"motion": {"velocity": "sine", "velocityCoeffs": {
        "frequency": 1, "amplitude": 1, "scale": (0, 1, 0),
        "level": (0, 0, 0)}}}, "'velocity' is the function sine"),
    "jump": ({"motion": {"displacement": (0.1, 0, 0)}}, "motion"),
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
    assert "FOAM FATAL ERROR" not in out


@pytest.mark.parametrize("motion, good", (
    ({"velocity": (0.1, 0, 0.2)}, True), ({"velocity": (0.1, 0.1, 0)}, False),
    (moved("rotatingMotion", origin=(0, 0, 0), axis=(0, 1, 0),
           omega=1)["motion"], True),
    (moved("rotatingMotion", origin=(0, 0, 0), axis=(0, 0, 1),
           omega=1)["motion"], False)))
def test_motion_off_a_mirror(tmp_path, motion, good):
    """A mirror stays where it is, so the body may only move along it."""
    body = Body((1, 1, 1), sides={"bottom": "symmetryPlane"},
                material=rigid(motion=motion))
    code, out = SmallCase(tmp_path, body, 1, preset=DEFAULT, control={
        **FIXED, "deltaT": 0.1}).attempt()
    assert (code == 0) == good, out
    assert good or "off its mirror" in out and "normal (0 -1 0)" in out, out


def test_short_step_of_a_spin(tmp_path):
    """The step of a body that turns is short. No node of another body is the
    reason."""
    tool = Body((2, 2), "tool", (2, 0, 0), material=rigid(),
                velocity=spinning((2.5, 0.5, 0), (0, 0, 1e6)))
    code, out = SmallCase(tmp_path, [Body((2, 2)), tool], 1, preset=DEFAULT,
                          control={"minDeltaT": 1e-3}).attempt()
    assert code != 0
    assert "(minDeltaT): the rigid region tool turns too fast, at time" in out


@pytest.mark.parametrize("first, last, told", (
    (0, 0.5, "no position at time 1 s"), (0.5, 1, "no position at time 0 s"),
    (0, 1, "")))
def test_table_of_a_motion(tmp_path, first, last, told):
    """A table that does not cover the run is reported before the first
    step."""
    tmp_path.mkdir(exist_ok=True)
    (tmp_path/"poses").write_text(
        f"(({first} ((0 0 0) (0 0 0))) ({last} ((0 1 0) (0 0 0))))\n")
    case = SmallCase(tmp_path/"case", Body(cells=(1, 1, 1), material=rigid(
        **moved("tabulated6DoFMotion", CofG=(0, 0, 0),
                timeDataFileName=f'"{tmp_path}/poses"'))), 1,
        control={**FIXED, "deltaT": 0.1}, preset=DEFAULT)
    code, out = case.attempt()
    assert (code == 0) == (not told), out
    assert told in out and "FOAM FATAL ERROR" not in out, out
    assert ("mechanicalProperties.motion" in out) == bool(told), out


@pytest.mark.parametrize("keyword, value", (
    ("freeRotation", "(x)"), ("freeTranslation", "(z)")))
def test_freedom_that_the_plane_has_not(tmp_path, keyword, value):
    body = Body(cells=(2, 2), material=rigid(**{keyword: value}))
    code, out = SmallCase(tmp_path, body, 1, control=FIXED,
                          preset=DEFAULT).attempt()
    assert code != 0 and "FOAM FATAL IO ERROR" in out
    assert f"'{keyword}'" in out and "2 directions" in out


@pytest.mark.parametrize("motion, dimensions", (
    ({"velocity": (0.1, 0, 0.2)}, 2),
    ({"displacement": table((0, (0, 0, 0)), (1, (0, 0.1, 0)))}, 1),
    (moved("rotatingMotion", origin=(0, 0, 0), axis=(1, 0, 0),
           omega=1)["motion"], 2),
    (moved("rotatingMotion", origin=(0, 0, 0), axis=(0, 0, 1),
           omega=1)["motion"], 1)))
def test_motion_out_of_the_mesh(tmp_path, motion, dimensions):
    """A body that rotates out of its plane would become narrower there."""
    for nDim in (dimensions, 3):
        code, out = SmallCase(
            tmp_path/str(nDim), Body((2,)*nDim, material=rigid(motion=motion)),
            1, control={**FIXED, "deltaT": 0.1}, preset=DEFAULT).attempt()
        assert (code != 0) == (nDim < 3), out
        assert ("'motion'" in out) == (nDim < 3), out


def test_all_rigid_needs_a_step(tmp_path):
    body = Body(cells=(1, 1, 1), material=rigid())
    code, out = SmallCase(tmp_path, body, 1, preset=DEFAULT).attempt()
    assert code != 0 and "adjustTimeStep" in out


@pytest.mark.parametrize("angle", (30, 60, 90))
def test_sector_between_mirrors(tmp_path, figures, angle):
    """Two mirrors, at right angles or not, leave no free direction in the
    plane."""
    def sector(X):
        phi = np.radians(angle)*X[:, 1]
        return np.column_stack((X[:, 0]*np.cos(phi), X[:, 0]*np.sin(phi),
                                X[:, 2]))

    case = SmallCase(
        tmp_path, Body((4, 8), start=(1, 0, 0), moved=sector, sides={
            "bottom": "symmetryPlane", "top": "symmetryPlane"},
            material={"type": "rigid", "rho": 1}), 1,
        gravity=(-1, -0.3, 0), control={**FIXED, "deltaT": 0.01},
        preset=DEFAULT).run()
    with figures(f"rigid sector of {angle} degrees") as f:
        f.atMost("displacement", largest(case.at("pointD")), 1e-12)


def test_sub_cycling_of_rigid_regions_alone(tmp_path):
    """Nothing is evaluated, and the report at the end says so."""
    case = SmallCase(
        tmp_path, [Body((2, 2), name=name, start=(x, 0, 0),
                        material={"type": "rigid", "rho": 1})
                   for name, x in (("a", 0), ("b", 1.05))], 0.1,
        control={**FIXED, "deltaT": 0.01, "subCycling": "yes"},
        preset=DEFAULT)
    code, log = case.attempt()
    assert code == 0 and "evaluations of nodes" in log, log[-3000:]


@pytest.mark.parametrize("length", (4, 16))
def test_slender_bar_lands_flat(tmp_path, figures, length):
    """A bar that may rotate about its own axis reacts like a bar that may not.
    When its compliance was that of its smallest moment of inertia, it was
    soft, and penetrated by a fifth of a face."""
    case = {}
    for free in "", "()":
        turns = {"freeRotation": free} if free else {}
        bar = Body((16, 1, 1), name="bar", start=(-length/2, 0.01, -0.125),
                   size=(length, 0.25, 0.25), sides={"bottom": "contact"},
                   velocity=(0, -0.05, 0), material=rigid(rho=4, **turns))
        block = Body((16, 4, 1), name="block", start=(-length/2, -1, -0.125),
                     size=(length, 1, 0.25), material=RUBBER, sides={
                         "top": "contact", "bottom": condition(
                             "fixedVelocity", velocity=(0, 0, 0))})
        case[free] = SmallCase(
            tmp_path/f"free{free}", (bar, block), 8,
            {"a": interface(("bar", "bottom"), ("block", "top"),
                            pairing="nearestFace")},
            functions=("contactForces",), preset=DEFAULT).run()
    p = {free: c.momentumOf("bar")[:, 1] for free, c in case.items()}
    deepest = case[""].contact("a")["relativePenetration"].max()
    with figures(f"bar of {length} x 0.25 x 0.25 lands flat") as f:
        f.atLeast("speed with which it leaves / initial",
                  -p["()"][-1]/p["()"][0], 0.5)
        f.within("change of the momentum / that without rotation",
                 (p[""][-1] - p[""][0])/(p["()"][-1] - p["()"][0]), 1, 0.05)
        f.atMost("deepest penetration / face", deepest, 0.05)


def test_rigid_regions_that_speed_up_together(tmp_path, figures):
    """They are paired once. The frame in which surfaces slide had the mean
    displacement of nodes that are not placed in each step: 15 pairings."""
    solid = {"type": "rigid", "rho": 1, "force": "constant (0.5 0 0)"}
    case = SmallCase(tmp_path/"case", [
        Body((6, 6, 6), name=name, start=(0, 1.001*i, 0), material=solid,
             sides={"bottom" if i else "top": "contact"},
             velocity=(0.5, -0.01*i, 0)) for i, name in enumerate("ab")],
        4, {"ab": interface(("a", "top"), ("b", "bottom"),
                            pairing="nearestFace")},
        control={"deltaT": 0.005, "writeInterval": 4, **FIXED},
        preset=DEFAULT)
    code, log = case.attempt()
    assert code == 0, log
    with figures("rigid regions that speed up together") as f:
        f.equal("pairings", int(re.search(r"in (\d+) pairings", log)[1]), 0)
