"""The variational scheme: its conservation to round-off, its dissipation, and
bodies that come to rest on each other."""

import numpy as np
import pytest

from vertexContactTests.caseTools import rise
from vertexContactTests.defaultCases import (CLAMPED, STEEP, barAgainst,
                                             checkShock, defaultCase, rough)
from vertexContactTests.smallCases import (ELASTIC, FLOOR, RUBBER, SIDES, Body,
                                           GmshBody, condition, coulomb,
                                           distorted, interface, largest, table)


@pytest.mark.parametrize("cells, material", (
    ((6,), RUBBER), ((6, 6), RUBBER), ((3, 3, 3), RUBBER), ((5, 5, 5), STEEP),
    ((4, 4, 4), ELASTIC)), ids=str)
def test_momenta_to_round_off(tmp_path, figures, cells, material):
    """A free, distorted body with a rough motion: linear and angular momentum
    are constant to round-off, and the energy only falls, by the dissipation in
    the accounts."""
    n = len(cells)
    run = defaultCase(tmp_path, Body(cells, material=material,
                                     velocity=rough(n),
                                     moved=distorted(0.4, dimensions=n)), 50,
                      every=10).run()
    p, L, E = run.momentumOf(), run.angularMomentumOf(), run.totalEnergy
    with figures(f"variational, free {cells}, {material['type']}") as f:
        f.atMost("change of the momentum / (mass speed)",
                 largest(p - p[0])/0.1, 1e-14)
        if material is not ELASTIC:         # a small-strain law
            f.atMost("change of the angular momentum / (mass speed size)",
                     largest(L - L[0])/0.1, 1e-14)
        f.atMost("largest energy / initial - 1", E.max()/E[0] - 1, 1e-6)
        f.atMost("balance / initial energy",
                 largest(run.energies["total:balance"])/E[0], 2e-3)


def test_unit_of_pressure(tmp_path, figures):
    """With density and modulus in another unit the motion is the same, also
    at the Poisson's ratio from which the Jacobian is smoothed. Some moduli
    give this ratio only less its round-off."""
    def motion(unit):
        material = dict(RUBBER, rho=unit, E=unit, nu=0.45)
        return defaultCase(tmp_path/str(unit), Body(
            (4, 4), material=material, velocity=rough(2)), 2).run().at("pointD")
    one, others = motion(1), [motion(unit) for unit in (3, 0.8e6, 1e6)]
    with figures("variational, units") as f:
        f.atMost("difference of displacements / largest", max(
            largest(other - one) for other in others)/largest(one), 1e-10)


def test_energy_is_of_second_order(tmp_path, figures):
    """The residual of the energy balance, with all dissipation included, falls
    with the square of the step."""
    def residual(maxCo):
        def velocity(X):
            return 0.3*np.sin(np.pi*X[:, :1])*np.array((1.0, 0.5, 0))
        run = defaultCase(tmp_path/str(maxCo), Body((8, 8), velocity=velocity),
                          4, {"maxCo": maxCo}, every=1).run()
        return (largest(run.energies["total:balance"])
                / run.totalEnergy[0])
    coarse, fine = residual(0.4), residual(0.2)
    with figures("variational, balance") as f:
        f.within("order of the balance", np.log2(coarse/fine), 2, 0.3)
        f.atMost("balance / initial energy at maxCo 0.2", fine, 1e-3)


# Round-off of a displacement of 8,000 cells, times kappa/mu. Nothing damps the
# pressure waves that it causes
@pytest.mark.parametrize("material, limit", ((RUBBER, 1e-9), (STEEP, 2e-7)),
                         ids=("0.3", "0.4995"))
def test_superposed_velocity(tmp_path, figures, material, limit):
    """An additional velocity of a thousand metres per second changes
    nothing."""
    def sigma(speed):
        def velocity(X):
            return rough(2)(X) + np.array((speed, 0, 0))
        run = defaultCase(tmp_path/f"{speed}",
                          Body((4, 4), material=material, velocity=velocity,
                        moved=distorted(0.3, dimensions=2)), 2,
                          {"adjustTimeStep": "no", "deltaT": 0.001}).run()
        return run.at("sigma")
    still, moving = sigma(0), sigma(1000)
    with figures("variational, 1000 m/s") as f:
        f.atMost("change of the stress / largest",
                 largest(moving - still)/largest(still), limit)


def test_rotated_and_mirrored(tmp_path, figures):
    """A body rotated by 90 degrees, or its mirror image, moves in the same
    way: the diagonals and the bound of the step have no preferred
    direction."""
    def velocity(X, turn):
        x, y = X[:, 0] - 0.5, X[:, 1] - 0.5
        if turn == "rotated":
            x, y = y, -x
        if turn == "mirrored":
            x = -x
        u = 0.2*np.sin(2*x + y) + 0.1*x
        v = 0.1*np.cos(3*x)*y
        out = np.zeros_like(X)
        out[:, 0], out[:, 1] = u, v
        if turn == "rotated":
            out[:, 0], out[:, 1] = -v, u
        if turn == "mirrored":
            out[:, 0] = -u
        return out

    def energies(turn):
        run = defaultCase(tmp_path/turn, Body(
            (6, 6), velocity=lambda X: velocity(X, turn)), 3).run()
        return run.energies["total:strain"][-1]
    plain = energies("plain")
    with figures("variational, rotated and mirrored") as f:
        for turn in ("rotated", "mirrored"):
            f.within(f"strain energy, {turn} / plain", energies(turn)/plain,
                     1, 1e-11)


def test_long_rotation(tmp_path, figures):
    """A free block gains no energy in forty turns."""
    with figures("variational, forty turns") as f:
        for cells in ((3, 3, 3), (6, 6)):
            run = defaultCase(tmp_path/str(len(cells)), Body(
                cells, velocity=lambda X: 0.2*np.cross((0, 0, 1), X - 0.5)),
                80*np.pi/0.2, every=100).run()
            E, L = run.totalEnergy, run.angularMomentumOf()
            f.atMost(f"{cells}: largest rise of the energy / initial",
                     rise(E), 1e-4)
            f.atMost(f"{cells}: change of the angular momentum / initial",
                     largest(L - L[0])/largest(L[0]), 1e-11)


def test_loaded_for_a_while(tmp_path, figures):
    """A temporary traction leaves no strain when the waves have died out: F is
    the gradient of the displacement, to round-off."""
    pull = condition("traction", traction=table(
        (0, (0, 0, 0)), (1, (0.05, 0, 0)), (2, (0, 0, 0)), (1e6, (0, 0, 0))))
    body = Body((3, 3), sides={"right": pull, "left": condition(
        "fixedVelocity", velocity=(0, 0, 0))})
    run = defaultCase(tmp_path, body, 12000, every=50).run()
    E = run.totalEnergy
    with figures("variational, load and release") as f:
        f.atMost("energy at the end / largest", E[-1]/E.max(), 1e-25)


def enclosed(x):
    """Volume within the surface of a block with nodes x[k, j, i], whose
    quadrilaterals are split by both diagonals, with half of the weight each.
    For one layer x[j, i] it is the area within the outline."""
    def inside(*corners):
        return np.linalg.det(np.stack(corners, axis=-2)).sum()

    if x.ndim == 3:
        outline = np.concatenate((x[0, :-1], x[:-1, -1], x[-1, :0:-1],
                                  x[:0:-1, 0]))
        return inside(outline, np.roll(outline, -1, axis=0))/2
    volume = 0
    for axis in range(3):
        for layer, sign in ((0, -1), (-1, 1)):
            # By the other two directions, in cyclic order
            side = np.moveaxis(x, 2 - axis, 0)[layer]
            side = side.swapaxes(0, 1) if axis != 1 else side
            a, b, c, d = (side[:-1, :-1], side[1:, :-1], side[1:, 1:],
                          side[:-1, 1:])
            volume += sign*(inside(a, b, c) + inside(a, c, d)
                            + inside(a, b, d) + inside(b, c, d))/12
    return volume


TETRAHEDRA = """
    SetFactory("OpenCASCADE");
    Box(1) = {0, 0, 0, 1, 1, 1};
    Mesh.CharacteristicLengthMin = 0.4;
    Mesh.CharacteristicLengthMax = 0.4;
    Physical Volume("body") = {1};
    Physical Surface("all") = {1, 2, 3, 4, 5, 6};
    """


@pytest.mark.parametrize("cells, single", (
    ((3, 3), False), ((3, 3, 3), False), ((3, 3, 3), True),
    ("tetrahedra", False)), ids=str)
def test_pressure_around_a_spinning_body(tmp_path, figures, cells, single):
    """A pressure on the whole surface of a coarse body with warped sides,
    which spins and vibrates: resultant and moment vanish to round-off, and the
    work is that of the volume within the deformed faces."""
    p, T = 0.2, 20
    load = condition("pressure", pressure=p)
    tetrahedra = cells == "tetrahedra"
    n = 3 if tetrahedra else len(cells)

    def warped(X):
        x = X.copy()
        for i in range(n):
            x[:, i] += 0.12*np.sin(2*X[:, (i + 1) % n] + 3*X[:, i] + i)
        return x
    more = {"moved": warped, "velocity": rough(n, spin=0.4, noise=0.05),
            "scheme": {"cells": "simplicialSingle"} if single else {}}
    if tetrahedra:
        body = GmshBody(geometry=TETRAHEDRA, sides={"all": load}, **more)
    else:
        body = Body(cells, sides=dict.fromkeys(list(SIDES)[:2*n], load), **more)
    # The works of the leapfrog have second order at the ends of a run
    run = defaultCase(tmp_path, body, T, {"maxCo": 0.1}).run()
    P, L = run.momentumOf(), run.angularMomentumOf()
    split = "one split" if single else "both splits"
    with figures(f"pressure around {cells}, {split}") as f:
        f.atMost("change of the momentum / (p area time)",
                 largest(P - P[0])/(p*T), 1e-12)
        f.atMost("change of the angular momentum / (p area size time)",
                 largest(L - L[0])/(p*T), 1e-12)
        if not (tetrahedra or single):
            X = run.X()
            first = slice((cells[0] + 1)**n)
            change = np.subtract(*(
                enclosed(x[first, :n].reshape((cells[0] + 1,)*n + (n,)))
                for x in (X + run.at("pointD"), X)))
            work = run.energies["total:externalWork"]
            f.within("work / -p (volume change)", work[-1]/(-p*change), 1,
                     2e-3)
            f.atMost("balance / largest work",
                     largest(run.energies["total:balance"])/largest(work),
                     1e-3)


def test_work_of_a_moving_clamp(tmp_path, figures):
    """A clamp bends a beam and then holds it. Its work equals the energy of
    the beam, except for the energy that oscillates on the mesh."""
    bend = table((0, (0, 0, 0)), (15, (0, 0.007, 0)), (30, (0, 0, 0)),
                 (1e6, (0, 0, 0)))
    body = Body((20, 8), size=(1, 0.4, 1), sides={
        "left": condition("fixedVelocity", velocity=(0, 0, 0)),
        "right": condition("fixedVelocity", velocity=bend)})
    run = defaultCase(tmp_path, body, 300, every=10).run()
    t, E = run.energies["Time"], run.totalEnergy
    held = np.interp((31, 300), t, E)
    work = run.energies["total:externalWork"]
    with figures("variational, bent and held") as f:
        f.atMost("energy lost while held / energy", 1 - held[1]/held[0], 0.01)
        f.atMost("work while held / energy",
                 abs(np.interp(31, t, work)/work[-1] - 1), 1e-3)
        f.atMost("balance / energy",
                 largest(run.energies["total:balance"])/held[0], 2e-3)


@pytest.mark.parametrize("cells", ((6,), (6, 6), (4, 4, 4)), ids=str)
def test_kept_energy_of_linear_bodies(tmp_path, figures, cells):
    """With the default step, close to the stable one: the leapfrog conserves
    the energy minus the swing. So the balance is round-off for linear forces,
    although the energies at single instants oscillate."""
    n = len(cells)
    run = defaultCase(tmp_path, Body(cells, material=ELASTIC,
                                     velocity=rough(n)), 20, every=1).run()
    E, kept = run.totalEnergy, run.keptEnergy
    with figures(f"variational, linear {cells}") as f:
        f.atLeast("largest swing / energy", largest(E - kept)/E[0], 0.01)
        f.atMost("balance / energy",
                 largest(run.energies["total:balance"])/E[0], 1e-13)


@pytest.mark.parametrize("control", (
    {}, {"damping": {"body": {"coefficient": 2}}}), ids=("free", "damped"))
@pytest.mark.parametrize("cells", ((6,), (6, 6), (4, 4, 4)), ids=str)
def test_kept_energy_of_a_released_body(tmp_path, figures, cells, control):
    """A linear body that begins under stress, at rest: the first kick lasts
    half a step, and the balance is round-off with it. (It was less by the swing
    of this half step, 4 % of the energy of a bar that was stretched.)"""
    n = len(cells)
    case = defaultCase(tmp_path, Body(
        cells, material=ELASTIC, velocity=rough(n),
        displacement=rough(n, 0)), 5,
        every=1, control=control)
    case.run()
    E = case.totalEnergy
    with figures(f"variational, released {cells}") as f:
        f.atMost("balance / energy",
                 largest(case.energies["total:balance"])/E[0], 1e-13)


@pytest.mark.parametrize("on, law, counts, ratio, weight", (
    ("plane", coulomb(0.5), (4, 4), 0, 0.05),
    ("body", coulomb(0.5), (4, 4), 1, 0.005),
    ("body", coulomb(0.5), (4, 4), 3, 0.05),
    ("body", coulomb(0), (4, 4), 2, 0.05),
    ("body", {"type": "tied"}, (4, 4), 1.5, 0.05),
    ("body", coulomb(0.5), (2, 2, 2), 2, 0.005)))
def test_comes_to_rest_and_stays(tmp_path, figures, on, law, counts, ratio,
                                 weight):
    """A block on a plane or on a deformable base, with any mesh, comes to
    rest, stays at rest, and gains no energy."""
    tied = law["type"] == "tied"
    # Without friction it would slide off the hollow that it makes. So the
    # model is a half
    middle = {"left": "symmetryPlane"} if law == coulomb(0) else {}
    block = Body(counts, name="block", sides={**middle, "bottom": "contact"})
    base = Body((round(ratio*counts[0]) or 1, *counts[1:]), name="base",
                start=(0 if middle else -0.5, -1, 0), size=(2, 1, 1),
                sides={**CLAMPED, **middle, "top": "contact"})
    if on == "plane":
        touch, more = {"side": ("block", "bottom"), "obstacle": FLOOR,
                       "law": law}, []
    else:
        touch, more = interface(("block", "bottom"), ("base", "top"), law,
                                pairing="AMI" if tied else "nearestFace"), [
                                    base]
    # Only the dissipation of smooth waves brings it to rest
    time = (60000.0 if law == coulomb(0) else
            20000.0 if weight > 0.01 else 6000.0)
    run = defaultCase(tmp_path, [block, *more], time, {"writeInterval": time/4},
                      every=20, interfaces={"contact": touch},
                      gravity=(0, -weight, 0)).run()
    kinetic = run.energies["total:kinetic"]
    drift = largest(run.at("pointD", run.times[3], "block")
                    - run.at("pointD", run.times[2], "block"))*counts[1]
    with figures(f"variational, rest on {on}, {law}, {counts}, {ratio}, "
                 f"{weight}") as f:
        f.atMost("kinetic energy in the last quarter / largest",
                 kinetic[3*len(kinetic)//4:].max()/kinetic.max(), 1e-10)
        f.atMost("drift in the last quarter / cell", drift, 1e-6)
        if not tied:
            f.atMost("penetration / cell",
                     run.contact("contact")["penetration"].max()*counts[1],
                     0.03 if weight < 0.01 else 0.15)


@pytest.mark.parametrize("against", ("mirror", "plane", "body"))
@pytest.mark.parametrize("speed", (0.5, 1.0, 1.2))
@pytest.mark.parametrize("dimensions", (1, 2))
def test_strong_shocks(tmp_path, figures, dimensions, speed, against):
    """A bar hits its mirror image, a wall, or an equal bar, at the wave speed
    and faster, with the default settings. There is no saw-tooth behind the
    shock."""
    cells = (200,) if dimensions == 1 else (80, 10)
    run = barAgainst(tmp_path, against, cells, speed)
    E = run.totalEnergy
    # In the first three steps the front has the length of the steps
    start = 1e-4 if (dimensions, speed, against) == (2, 0.5, "mirror") else 1e-6
    with figures(f"variational, {dimensions}D, {speed} c_p against {against}"
                 ) as f:
        checkShock(f, run, speed)
        f.atMost("largest energy / initial - 1", E.max()/E[0] - 1, start)


@pytest.mark.parametrize("cells, limit", ((16, 0.94), (64, 0.97)))
def test_cradle(tmp_path, figures, cells, limit):
    """Five equal bars in a row: the last bar takes over the velocity of the
    first."""
    bodies, interfaces = [], {}
    for i in range(5):
        sides = {side: "contact" for side, at in (("left", i > 0),
                                                  ("right", i < 4)) if at}
        bodies.append(Body((cells,), name=f"b{i}", start=(1.0001*i, 0, 0),
                           material=ELASTIC, sides=sides,
                           velocity=(0.0 if i else 0.01, 0, 0)))
        if i:
            interfaces[f"i{i}"] = interface((f"b{i - 1}", "right"),
                                            (f"b{i}", "left"))
    run = defaultCase(tmp_path, bodies, 11, interfaces=interfaces).run()
    p = run.momentumOf()
    with figures(f"variational, cradle of {cells}") as f:
        f.atLeast("velocity of the last / of the first",
                  run.momentum["b4:px"][-1]/0.01, limit)
        f.atMost("change of the momentum", largest(p - p[0])/0.01, 1e-13)
