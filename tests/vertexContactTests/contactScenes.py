"""Scenes of contact for several tests: four blocks that collide, on given
ranks; a rigid tool on a block; a box that falls on its bumper."""

import numpy as np

from vertexContactTests.caseTools import DEFAULT, checked, solver
from vertexContactTests.defaultCases import defaultCase
from vertexContactTests.smallCases import (FLOOR, Body, SmallCase, coulomb,
                                           interface, table)

MATERIAL = {"type": "neoHookean", "rho": 1000, "E": 1e6, "nu": 0.3}
END = 0.05


def squares(gap=0.05):
    """Four blocks of one metre on a grid of two by two fly to the middle. Each
    touches two others, and all four touch with their corners."""
    bodies = []
    for i in range(2):
        for j in range(2):
            sides = {("right", "left")[i]: "contact",
                     ("top", "bottom")[j]: "contact"}
            bodies.append(Body(
                cells=(4 + i, 4 + j), name=f"square{i}{j}", size=(1, 1, 1),
                start=(i*(1 + gap), j*(1 + gap), 0), sides=sides,
                material=MATERIAL, velocity=(2 - 4*i, 1.5 - 3*j, 0)))
    return bodies


def solve(case, ranks=1):
    code, log = case.attempt(ranks)
    if code:
        raise RuntimeError(log)
    return log


def difference(a, b):
    """Difference of the final energies, relative to the initial energy."""
    return max(abs(a.energies[f"total:{e}"][-1] - b.energies[f"total:{e}"][-1])
               for e in ("kinetic", "strain"))/a.totalEnergy[0]


# Rank of each cell: a body as a whole or cut in two, on all ranks. With four
# ranks, one rank has no part of a contact surface. Then two touching bodies on
# one rank
PLACES = {
    "mixed": (4, {"square00": lambda i, j: 0, "square10": lambda i, j: 1,
                  "square01": lambda i, j: 1 + (j > 1),
                  "square11": lambda i, j: 3 if min(i, j) > 2
                  else (i + j) % 3}),
    "whole": (3, {"square00": lambda i, j: 2, "square10": lambda i, j: 2,
                  "square01": lambda i, j: 0, "square11": lambda i, j: 1})}


def solveOn(case, ranks, places):
    """Run the case with each cell on a given rank."""
    for body in case.bodies:
        nx, ny = body.cells
        cells = [places[body.name](k % nx, k//nx) for k in range(nx*ny)]
        (case.path/"constant"/body.name/"cellDecomposition").write_text(
            "FoamFile { version 2.0; format ascii; class labelList; "
            "object cellDecomposition; }\n"
            f"{len(cells)} ({' '.join(map(str, cells))})\n")
    case.decompose(ranks, "manual")
    checked(solver(ranks), case.path)


def rigid(**more):
    return {"type": "rigid", "rho": 1, **more}


def spinning(center, spin, velocity=(0, 0, 0)):
    """Initial velocity of a rotating body."""
    return lambda X: np.cross(spin, X - np.array(center)) + np.array(velocity)


def toolAndBlock(folder, endTime=1, ranks=1, control=None, material=None,
                 contact=None):
    """A rotating tool is pressed on a block with friction."""
    tool = Body(cells=(3, 3, 3), name="tool", start=(0.3, 1.01, 0.4),
                size=(0.5, 0.3, 0.7), sides={"bottom": "contact"},
                velocity=spinning((0.55, 1.16, 0.75), (0.1, 1.0, 0.05)),
                material=material or rigid(
                    rho=2, force=table((0, (0, 0, 0)), (0.3, (0, -0.1, 0)))))
    block = Body(cells=(5, 4, 6), name="block", size=(1.2, 1, 1.5),
                 sides={"top": "contact",
                        "bottom": {"type": "fixedVelocity",
                                   "velocity": (0, 0, 0)}})
    case = SmallCase(folder, [tool, block], endTime,
                     interfaces=contact or {"both": interface(
                         ("tool", "bottom"), ("block", "top"), coulomb(0.3),
                         pairing="nearestFace")},
                     functions=("contactForces",), preset=DEFAULT,
                     control={"writeInterval": endTime/2, **(control or {})})
    return case.run() if ranks == 1 else case.runParallel(ranks)


ALUMINIUM = {"type": "neoHookean", "rho": 2700, "E": 70e9, "nu": 0.33}


def boxOnBumper(folder, joint="tied", nu=0.4, every=5, n=8, **control):
    """An aluminium box with a rubber bumper falls on a rigid plane at 3 m/s.
    n: elements over each height; every: steps between rows of histories. The
    case is not run yet."""
    gap, speed, thick = 1e-4, (0, -3, 0), 0.01
    box = Body((n, n), name="box", start=(0, thick + gap, 0),
               size=(0.05, 0.05, 1), material=ALUMINIUM, velocity=speed,
               sides={"bottom": "contact"})
    bumper = Body((5*n//2, n), name="bumper", start=(0, gap, 0),
                  size=(0.05, thick, 1), velocity=speed, material={
                      "type": "neoHookean", "rho": 1100, "E": 5e6, "nu": nu},
                  sides={"bottom": "contact", "top": "contact"})
    between = interface(("bumper", "top"), ("box", "bottom"), joint,
                        pairing="AMI" if joint == "tied" else "nearestFace")
    return defaultCase(
        folder, [box, bumper], 2e-3, control, every=every, interfaces={
            "joint": between,
            "floor": {"side": ("bumper", "bottom"), "obstacle": FLOOR}})


def released(case):
    """The time at which the bumper leaves the floor."""
    contact = case.contact("floor")
    return contact["Time"][contact["area"] > 0][-1]
