"""One free body without contact: the largest stable step, bad cells, and
vibrations that last."""

import numpy as np

from smallCases import RUBBER, Body, distorted, largest

from .judge import BALANCE, SPLIT_BALANCE, momentumChange, outcome, small

# Elements of a side
FINE = {1: 20, 2: 6, 3: 4}

# Most that H and J may be away from F
DRIFT = 0.2


def rubber(nu):
    """Neo-Hookean, and the speeds of its waves."""
    material = {**RUBBER, "nu": nu}
    shear = 0.5/(1 + nu)
    pressure = 2*shear*(1 - nu)/(1 - 2*nu)
    return material, np.sqrt(pressure), np.sqrt(shear)


def anyModes(speed, dimensions, seed=1):
    """Random velocities of all nodes: every mode of the mesh takes part."""
    def velocity(X):
        # By position, so that the points of one node have the same
        place = np.unique(np.round(X[:, :dimensions], 9), axis=0,
                          return_inverse=True)[1].ravel()
        random = np.random.default_rng(seed).uniform(
            -speed, speed, (place.max() + 1, 3))
        return random[place]*(np.arange(3) < dimensions)
    return velocity


def step(folder, dimensions, nu, reconstruction, timeIntegrator, maxCo,
         steps=100):
    """Some hundred steps (300 to 600) of a distorted block in which all modes
    are excited, at a tenth of the speed of shear waves. Most of the energy
    dissipates at once, within steps that are not small: the balance says how
    accurate that is, not whether it is stable."""
    n = FINE[dimensions]
    material, cp, cs = rubber(nu)
    body = Body(cells=(n,)*dimensions, material=material,
                moved=distorted(0.3, dimensions=dimensions),
                velocity=anyModes(0.1*cs, dimensions),
                scheme={"reconstruction": reconstruction})
    control = {"writeControl": "none"}
    if timeIntegrator != "TVDRK2":
        control["timeIntegrator"] = timeIntegrator
    case = small(folder, body, steps*maxCo/n/cp, maxCo, control)
    return outcome(case, balanceLimit=None)


# Bad cells

def wobble(folder, body, transits=4, maxCo=None):
    """All modes of a body of any shape, for some transits of its length."""
    case = small(folder, body, transits/rubber(0.3)[1], maxCo,
                 {"writeControl": "none"})

    def check(case):
        scale = np.sqrt(2*case.totalEnergy[0])
        yield "momentum", momentumChange(case, scale), 0, 1e-12
    return outcome(case, check)


def aspect(folder, dimensions, shape, ratio, maxCo=None):
    """Cells of an aspect ratio, as plates (one short side) or needles (one
    long side)."""
    thin = {"plates": dimensions - 1, "needles": 1}[shape]
    size = np.where(np.arange(3) < thin, 1, 1/ratio)
    size[dimensions:] = 1
    n = FINE[dimensions]
    return wobble(folder, Body(
        cells=(n,)*dimensions, size=size, moved=distorted(
            0.3, size, dimensions),
        velocity=anyModes(0.05, dimensions)), maxCo=maxCo)


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


def sliver(folder, kind, angle, maxCo=None):
    """Tetrahedra with dihedral angles down to this many degrees."""
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
        velocity=anyModes(0.05, 3)), maxCo=maxCo)
    result.figures["angle"] = (
        smallestAngle(SLIVERS[kind](left, n), n), None, None)
    return result


# Vibrations that last

def drift(case, region=None):
    """Largest |H - cof F| and |J - det F| at the end."""
    F = case.at("F", region=region).reshape(-1, 3, 3)
    det = np.linalg.det(F)
    cofactor = det[:, None, None]*np.linalg.inv(F).transpose(0, 2, 1)
    return (largest(case.at("H", region=region).reshape(-1, 3, 3) - cofactor),
            largest(case.at("J", region=region)[:, 0] - det))


def vibration(folder, cells, reconstruction, timeIntegrator, steps):
    """Free vibration of a few cells. Translation and rotation remain; all
    else dies out, and the energy never rises."""
    dimensions = len(cells.split("x"))
    counts = tuple(int(n) for n in cells.split("x"))
    size = np.ones(3)
    size[:dimensions] = counts
    material, cp, _ = rubber(0.3)
    # A step in transits of a cell
    step = {1: 0.3, 2: 0.155, 3: 0.11}[dimensions]
    body = Body(cells=counts, size=size, material=material,
                velocity=anyModes(0.1, dimensions),
                scheme={"reconstruction": reconstruction})
    control = {
        "writeInterval": steps*step/cp, "functions": {"solidEnergies": {
            "type": "solidEnergies", "libs": "(vertexContact)",
            "writeControl": "timeStep",
            "writeInterval": max(1, steps//20000)}}}
    if timeIntegrator != "TVDRK2":
        control["timeIntegrator"] = timeIntegrator
    case = small(folder, body, steps*step/cp, control=control)

    def check(case):
        if dimensions > 1:
            H, J = drift(case)
            yield "H - cof F", H, 0, DRIFT
            yield "J - det F", J, 0, DRIFT
        yield "energy left", case.totalEnergy[-1]/case.totalEnergy[0], None, 1
    return outcome(case, check, balanceLimit=SPLIT_BALANCE
                   if timeIntegrator == "symplecticEuler" else BALANCE)


def spin(folder, cells, reconstruction, revolutions):
    """A free block turns about its axis, its sides at a tenth of the speed of
    waves: nothing else ever happens, and its energy never rises."""
    counts = tuple(int(n) for n in cells.split("x"))
    material, cp, _ = rubber(0.3)
    omega = 0.2*cp
    case = small(
        folder, Body(cells=counts, material=material,
                     velocity=lambda X: np.cross((0, 0, omega), X - 0.5),
                     scheme={"reconstruction": reconstruction}),
        2*np.pi*revolutions/omega, control={
            "functions": {"solidEnergies": {
                "type": "solidEnergies", "libs": "(vertexContact)",
                "writeControl": "timeStep", "writeInterval": 10}}})

    def check(case):
        L = case.momentum["body:Lz"]
        yield "angular momentum", largest(L/L[0] - 1), 0, 1e-6
        strain = case.energies["total:strain"]/case.totalEnergy[0]
        yield "strain energy at the end", strain[-1], 0, 0.1
        H, J = drift(case)
        yield "H - cof F", H, 0, DRIFT
        yield "J - det F", J, 0, DRIFT
    return outcome(case, check)
