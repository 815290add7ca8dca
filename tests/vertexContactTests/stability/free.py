"""One free body without contact: the largest stable step, bad cells, and
vibrations that last."""

import numpy as np

from vertexContactTests.smallCases import (RUBBER, Body, condition, distorted,
                                           largest)

from .judge import BALANCE, momentumChange, outcome, small

# Number of elements per side
FINE = {1: 20, 2: 6, 3: 4}


def rubber(nu):
    """Neo-Hookean rubber and its wave speeds."""
    material = {**RUBBER, "nu": nu}
    shear = 0.5/(1 + nu)
    pressure = 2*shear*(1 - nu)/(1 - 2*nu)
    return material, np.sqrt(pressure), np.sqrt(shear)


def anyModes(speed, dimensions, seed=1):
    """Random velocities of all nodes, which excite every mode of the mesh."""
    def velocity(X):
        # Sorted by position, so that the points of one node have the same
        # velocity
        place = np.unique(np.round(X[:, :dimensions], 9), axis=0,
                          return_inverse=True)[1].ravel()
        random = np.random.default_rng(seed).uniform(
            -speed, speed, (place.max() + 1, 3))
        return random[place]*(np.arange(3) < dimensions)
    return velocity


HOLD = condition("fixedVelocity", velocity=(0, 0, 0))


def held(dimensions, nu, stretch, sides):
    """A distorted block with velocities in all of its modes, at a tenth of the
    shear wave speed. It is free, or held at both ends at another length, with
    its sides wider or narrower by a factor."""
    n = FINE[dimensions]
    material, cp, cs = rubber(nu)
    rough = anyModes(0.1*cs, dimensions)
    scale = np.array((stretch, sides, sides))[:dimensions]
    scale = np.append(scale, np.ones(3 - dimensions))

    def inside(X):
        x = X[:, :1]
        return rough(X)*((x > 1e-9) & (x < 1 - 1e-9))
    more = {"velocity": rough} if stretch == 1 else {
        "velocity": inside, "sides": {"left": HOLD, "right": HOLD},
        "displacement": lambda X: (scale - 1)*X}
    return Body(cells=(n,)*dimensions, material=material, moved=distorted(
        0.3, dimensions=dimensions), **more), n, cp


def step(folder, dimensions, nu, maxCo, stretch=1, **how):
    """Some hundred steps of a distorted block in which all modes are excited,
    at a tenth of the speed of shear waves. The block is free, or held at both
    ends at another length; in two and three dimensions it keeps its volume.
    Most of the energy dissipates at once, within steps that are not small:
    the balance shows how accurate that is, not whether it is stable."""
    body, n, cp = held(dimensions, nu, stretch, 1 if dimensions == 1 else
                       stretch**(-1/(dimensions - 1)))
    case = small(folder, body, 90*maxCo/n/cp, {"writeControl": "none"},
                 maxCo, **how)
    return outcome(case, balanceLimit=None)


def release(folder, dimensions, cells, nu, stretch, **how):
    """The same block at another length and with another volume, held at its
    ends while its sides are released. The pressure of rubber that is squeezed
    by 40 % is as many times its modulus as it is hard to compress."""
    body, n, cp = held(dimensions, nu, stretch, 1)
    case = small(folder, body, 90/n/cp, {"writeControl": "none"},
                 scheme={"cells": cells}, **how)
    return outcome(case)


# Bad cells

def wobble(folder, body, how, transits=4, balanceLimit=BALANCE):
    """All modes of a body of any shape, for some transits of its length."""
    case = small(folder, body, transits/rubber(0.3)[1],
                 {"writeControl": "none"}, **how)

    def check(case):
        scale = np.sqrt(2*case.totalEnergy[0])
        yield "momentum", momentumChange(case, scale), 0, 1e-12
    return outcome(case, check, balanceLimit=balanceLimit)


def aspect(folder, dimensions, shape, ratio, **how):
    """Cells of a given aspect ratio: plates (one short side) or needles (one
    long side)."""
    thin = {"plates": dimensions - 1, "needles": 1}[shape]
    size = np.where(np.arange(3) < thin, 1, 1/ratio)
    size[dimensions:] = 1
    n = FINE[dimensions]
    return wobble(folder, Body(
        cells=(n,)*dimensions, size=size, moved=distorted(
            0.3, size, dimensions),
        velocity=anyModes(0.05, dimensions)), how)


# The two splits of a hexahedron, vertices by (x, y, z)
CUBE = np.array(((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                 (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)))
SPLITS = ((0, 1, 3, 4), (2, 1, 3, 6), (5, 1, 4, 6), (7, 3, 4, 6), (1, 3, 4, 6),
          (1, 0, 2, 5), (3, 0, 2, 7), (4, 0, 5, 7), (6, 2, 5, 7), (0, 2, 5, 7))


def dihedrals(X):
    """All dihedral angles of tetrahedra (n, 4, 3), in degrees."""
    normals = []
    for i in range(4):
        a, b, c = (X[:, (i + k) % 4] for k in (1, 2, 3))
        n = np.cross(b - a, c - a)
        inward = np.einsum("ij,ij->i", n, X[:, i] - a)
        n *= np.sign(inward)[:, None]
        normals.append(n/np.linalg.norm(n, axis=1, keepdims=True))
    return np.degrees([np.arccos(np.clip(-np.einsum(
        "ij,ij->i", normals[i], normals[j]), -1, 1))
        for i in range(4) for j in range(i)])


def smallestAngle(move, n):
    """Smallest dihedral angle of both splits of the n^3 hexahedra of a unit
    block whose points are moved."""
    corner = np.stack(np.meshgrid(*(np.arange(n),)*3), -1).reshape(-1, 1, 3)
    hexes = (corner + CUBE)/n
    X = move(hexes.reshape(-1, 3)).reshape(hexes.shape)
    return dihedrals(X[:, SPLITS].reshape(-1, 4, 3)).min()


def flattened(left, n):
    """The cells of the layer in the middle are squashed to this height, in
    cells: each then holds slivers, four nodes that nearly lie in a plane."""
    def move(X):
        low, high = n//2/n, (n//2 + 1)/n
        Y = distorted(0.3)(X)
        middle = 0.5*(low + high)
        for z, sign in (low, -1), (high, 1):
            on = np.abs(X[:, 2] - z) < 1e-9
            Y[on, 2] = middle + sign*0.5*left/n
        return Y
    return move


def pushed(left, n):
    """One node inside is pushed along a diagonal of its cell, towards the
    plane of its three neighbours: one cell with slivers among good ones."""
    def move(X):
        Y = X.copy()
        node = np.full(3, n//2/n)
        on = np.linalg.norm(X - node, axis=1) < 1e-9
        Y[on] += (1/3 - left)/n
        return Y
    return move


SLIVERS = {"layer": flattened, "node": pushed}


def sliver(folder, kind, angle, **how):
    """Tetrahedra with dihedral angles down to this many degrees. The energy of
    their modes dissipates within steps that are not small, as in group
    step."""
    n = FINE[3]
    below, above = 1e-6, 0.3
    while above/below > 1 + 1e-9:
        left = np.sqrt(below*above)
        if smallestAngle(SLIVERS[kind](left, n), n) < angle:
            below = left
        else:
            above = left
    result = wobble(folder, Body(
        cells=(n,)*3, moved=SLIVERS[kind](left, n),
        velocity=anyModes(0.05, 3)), how, balanceLimit=0.1)
    result.figures["angle"] = (
        smallestAngle(SLIVERS[kind](left, n), n), None, None)
    return result


# Motions that last

# A default step of the undeformed body, in transits of a cell
STEP = {1: 0.6, 2: 0.46, 3: 0.375}


def energies(steps):
    """Write energies once in so many steps."""
    return {"functions": {"solidEnergies": {
        "type": "solidEnergies", "libs": "(vertexContact)",
        "writeControl": "timeStep", "writeInterval": max(1, steps//20000)}}}


def counts(cells):
    return tuple(int(n) for n in cells.split("x"))


def vibration(folder, cells, steps, nu=0.3, **how):
    """Free vibration of a few cells. Translation and rotation remain; all
    other motion should die out, and the kept energy (the energy that the
    leapfrog conserves) never rise."""
    n = counts(cells)
    material, cp, _ = rubber(nu)
    body = Body(cells=n, size=(n + (1, 1))[:3], material=material,
                velocity=anyModes(0.1, len(n)))
    time = steps*STEP[len(n)]/cp
    case = small(folder, body, time, {"writeInterval": time,
                                      **energies(steps)}, **how)

    def check(case):
        E = case.keptEnergy/case.totalEnergy[0]
        yield "energy left", E[-1], None, 1
        yield "lost in the last half", 1 - E[-1]/E[len(E)//2], None, 1
        yield "momentum", momentumChange(case, 1), 0, 1e-9
    return outcome(case, check)


def spin(folder, cells, steps, **how):
    """A free block turns about its axis; its sides move at a tenth of the
    speed of waves. Nothing else may happen, and its energy may never rise."""
    n = counts(cells)
    material, cp, _ = rubber(0.3)
    omega = 0.2*cp
    time = steps*STEP[len(n)]/n[0]/cp
    case = small(
        folder, Body(cells=n, material=material,
                     velocity=lambda X: np.cross((0, 0, omega), X - 0.5)),
        time, {"writeInterval": time, **energies(steps)}, **how)

    def check(case):
        L = case.momentum["body:Lz"]
        yield "turns", omega*time/2/np.pi, None, None
        yield "angular momentum", largest(L/L[0] - 1), 0, 1e-6
        E = case.totalEnergy/case.totalEnergy[0]
        yield "energy left", E[-1], None, 1
        yield "lost in the last half", 1 - E[-1]/E[len(E)//2], None, 1
        strain = case.energies["total:strain"]/case.totalEnergy[0]
        yield "strain energy at the end", strain[-1], 0, 0.1
    return outcome(case, check)
