"""Edges and vertices of bodies in contact: contact without friction with what
stands still does no work, and takes energy or keeps it."""

import numpy as np
import pytest

from vertexContactTests.caseTools import DEFAULT
from vertexContactTests.smallCases import (ELASTIC, FLOOR, SIDES, Body,
                                           SmallCase, interface, largest)


def onto(direction):
    """Rotation that makes a direction the vertical one."""
    a = np.array(direction)/np.linalg.norm(direction)
    b = np.array((0, 1, 0))
    v, c = np.cross(a, b), a @ b
    K = np.array(((0, -v[2], v[1]), (v[2], 0, -v[0]), (-v[1], v[0], 0)))
    return np.eye(3) + K + K @ K/(1 + c)


def sidesOf(nDim):
    return {side: "contact" for side in SIDES if SIDES[side][0] < nDim}


def finished(case):
    code, log = case.attempt()
    assert code == 0, log[-3000:]
    return case


@pytest.mark.parametrize("nDim, direction, speed", (
    (2, (1, 1, 0), 0.05), (3, (1, 1, 0), 0.05), (3, (1, 1, 1), 0.01),
    (3, (1, 1, 1), 0.2)), ids=("corner", "edge", "vertex", "fast vertex"))
def test_falls_on_its(tmp_path, figures, nDim, direction, speed):
    """A block on a plane: what pushes at a node is what its whole surface
    gives along the normal of the plane."""
    R = onto(direction)
    case = finished(SmallCase(tmp_path, Body(
        (4,)*nDim, moved=lambda X: X @ R.T, sides=sidesOf(nDim),
        displacement=lambda X: 0*X + np.array((0, 0.005, 0)),
        velocity=(0, -speed, 0)), 4,
        {"floor": {"side": '(body ".*")', "obstacle": FLOOR}},
        control={"maxCo": 0.9}, preset=DEFAULT))
    E = case.keptEnergy
    p = case.momentumOf("body")[:, 1]
    with figures(f"{nDim}D, falls with {speed} on {direction}") as f:
        f.atMost("largest energy / initial", E.max()/E[0], 1 + 1e-6)
        f.atMost("work of contact / initial energy",
                 case.energies["total:contactWork"].max()/E[0], 1e-6)
        f.atLeast("change of the momentum / initial", (p.max() - p[0])/-p[0],
                    0.4)


@pytest.mark.parametrize("cells, speeds, apart", (
    (4, (0.02, 0.02), 0), (4, (0.02, 0.02), 0.05), (4, (0.03, 0.02), 0),
    (8, (0.02, 0.02), 0), (4, (0.02, 0), -0.01)))
def test_corner_meets_corner(tmp_path, figures, cells, speeds, apart):
    """Blocks that no faces of are opposite before they are inside each other.
    They were found when they were half of a cell inside, and left with seven
    times their energy."""
    sides = sidesOf(2)
    blocks = (
        Body((cells, cells), name="a", start=(1, 0, 0),
             velocity=(0, speeds[1], 0), sides=sides),
        Body((cells, cells), name="b", start=(0, 1 + apart, 0),
             velocity=(speeds[0], 0, 0), sides=sides))
    case = finished(SmallCase(
        tmp_path, blocks, 10, {"all": {"surfaces": "all", "self": "no"}},
        control={"maxCo": 0.9, "writeInterval": 10}, preset=DEFAULT))
    E = case.keptEnergy
    p = case.momentumOf("a")
    with figures(f"corners of {cells} cells, {speeds}, {apart} apart") as f:
        f.atMost("largest energy / initial", E.max()/E[0], 1.04)
        f.atLeast("change of the momentum / initial",
                  largest(p - p[0])/largest(p[0] + case.momentumOf("b")[0]),
                  0.01)


WEDGES = (
    (2, 1.5, "rigid", {}), (2, 1.5, "same", {}), (2, 1.5, "heavy", {}),
    (2, 1.5, "heavy", {"updateDistance": 0.4}), (2, 0.6, "heavy", {}),
    (3, 0.6, "same", {}), (3, 1.5, "heavy", {"updateDistance": 0.4}))


@pytest.mark.parametrize("nDim, slope, base, more", WEDGES)
def test_wedge_meets_face(tmp_path, figures, nDim, slope, base, more):
    """A wedge of few cells, in 3D a pyramid, falls on a face with its tip. It
    touches with the tip, between the points of its overlaps. Where these were
    pressed as a whole or not at all it was 0.4 of a cell inside before the
    next pairing saw that, and left with two to six times its energy."""
    def pointed(X):
        off = np.maximum(abs(X[:, 0]), abs(X[:, 2]) if nDim == 3 else 0)
        return np.stack((X[:, 0], X[:, 1] + (1 - X[:, 1])*slope*off,
                         X[:, 2]), axis=1)

    deep = -0.5 if nDim == 3 else 0
    wedge = Body((4,)*nDim, name="wedge", start=(-0.5, 0, deep), moved=pointed,
                 sides={"bottom": "contact"}, velocity=(0, -0.05, 0),
                 displacement=lambda X: 0*X + np.array((0, 0.002, 0)))
    material = {"rigid": {"type": "rigid", "rho": 1, "freeTranslation": "()",
                          "freeRotation": "()"},
                "heavy": {**ELASTIC, "rho": 1000}, "same": ELASTIC}[base]
    held = {} if base == "rigid" else {
        "bottom": {"type": "fixedVelocity", "velocity": (0, 0, 0)}}
    ground = Body((6, 2, 6)[:nDim], name="ground", start=(-1.5, -1, 3*deep),
                  size=(3, 1, 3 if nDim == 3 else 1), material=material,
                  sides={"top": "contact", **held})
    case = finished(SmallCase(
        tmp_path, (wedge, ground), 3,
        {"a": interface(("wedge", "bottom"), ("ground", "top"),
                        pairing="nearestFace", **more)},
        control={"maxCo": 0.9, "writeInterval": 3}, preset=DEFAULT))
    E = case.keptEnergy
    p = case.momentumOf("wedge")[:, 1]
    with figures(f"{nDim}D wedge, slope {slope}, on {base}, {more}") as f:
        f.atMost("largest energy / initial", E.max()/E[0], 1 + 1e-6)
        f.atMost("work of contact / initial energy",
                 case.energies["total:contactWork"].max()/E[0], 1e-6)
        f.atLeast("change of the momentum / initial", (p.max() - p[0])/-p[0],
                  0.9 if nDim == 2 else 0.1)


@pytest.mark.parametrize("distance", (0.02, 0.1, 0.4))
def test_corner_slides_over_faces(tmp_path, figures, distance):
    """A rigid block that is held at an angle slides over a finer floor with
    its corner. Between pairings the overlap at its rim becomes short; its gap
    was that of a point far off it, so that the corner was thrown up."""
    R = np.array(((np.cos(0.44), -np.sin(0.44), 0),
                  (np.sin(0.44), np.cos(0.44), 0), (0, 0, 1)))
    up = 0.5*(np.cos(0.44) + np.sin(0.44)) + 1e-4
    block = Body((3, 3), name="block", start=(-0.5, -0.5, 0),
                 moved=lambda X: X @ R.T + np.array((0, up, 0)),
                 sides=dict.fromkeys(("left", "right", "bottom", "top"),
                                     "contact"),
                 velocity=(0.2, -0.02, 0),
                 material={"type": "rigid", "rho": 1, "freeRotation": "()"})
    floor = Body((11, 1), name="floor", start=(-4, -1, 0), size=(8, 1, 1),
                 sides={"top": "contact"}, material={
                     "type": "rigid", "rho": 1, "freeTranslation": "()",
                     "freeRotation": "()"})
    case = finished(SmallCase(
        tmp_path, (block, floor), 20,
        {"all": {"surfaces": "all", "self": "no",
                 "law": {"type": "frictionless"},
                 "updateDistance": distance}}, gravity=(0, -0.02, 0),
        control={"adjustTimeStep": "no", "deltaT": 0.01}, preset=DEFAULT))
    p = case.momentumOf("block")
    W = case.energies["total:contactWork"]
    E = case.energies["block:kinetic"][0]
    with figures(f"a corner slides, updateDistance {distance}") as f:
        f.atMost("work of contact / initial energy", W.max()/E, 1e-6)
        f.atLeast("vertical momentum, largest", p[:, 1].max(), 0.01)
        f.atLeast("least momentum along the floor / initial",
                  p[:, 0].min()/p[0, 0], 0.9 if distance < 0.2 else 0.3)


def test_corners_that_have_passed_do_not_pull(tmp_path, figures):
    """A rigid square meets one that turns, corner at corner, and the corners
    slide off each other between pairings: the overlap of both has a negative
    area then. It pulled them into each other, and they left with 82 times
    their energy."""
    def square(name, centre, angle, velocity, spin):
        R = np.array(((np.cos(angle), -np.sin(angle)),
                      (np.sin(angle), np.cos(angle))))

        def moved(X):
            return np.hstack((X[:, :2] @ R.T + centre, X[:, 2:]))

        def speed(X):
            return np.stack((velocity - spin*(X[:, 1] - centre[1]),
                             spin*(X[:, 0] - centre[0]), 0*X[:, 0]), axis=1)
        return Body(
            (2, 2), name=name, start=(-0.5, -0.5, 0), sides=sidesOf(2),
            moved=moved, velocity=speed, material={"type": "rigid", "rho": 1})

    case = finished(SmallCase(
        tmp_path, (square("a", (0, 0), 0, 0.1, 0),
                   square("b", (1.4, 0.8), 0.3, 0, 0.3)), 10,
        {"all": {"surfaces": "all", "self": "no",
                 "law": {"type": "frictionless"}}},
        control={"adjustTimeStep": "no", "deltaT": 0.004},
        functions=("contactForces",), preset=DEFAULT))
    E = case.keptEnergy
    with figures("a rigid corner slides off another one") as f:
        f.atMost("largest energy / initial", E.max()/E[0], 1 + 1e-6)
        f.atLeast("least area of a pair that touches [m2]",
                  case.contact("all")["area"].min(), 0)
        f.atLeast("largest loss of energy / initial", 1 - E.min()/E[0], 0.1)
