"""Analysis of a run of tutorials/hundredDiscs: the load of the box, the parts
of the energy, and the overlap of discs."""

import re
from pathlib import Path

import numpy as np

from vertexContactCases import discs, readFields, readResults

GRAVITY = 9.81


def mass(nQuarter):
    """Mass of all discs [kg/m], which are regular polygons."""
    n = 4*nQuarter
    return sum(discs.DENSITY[stiff]
               * 0.5*n*np.sin(2*np.pi/n)*radius**2
               for _, radius, _, _, stiff in discs.discs())


def box(case):
    """Times; and, for all discs together, the force of the box [N/m] and its
    impulse so far [N.s/m], in x and y; its friction so far [J/m]."""
    force = impulse = friction = 0
    for name, *_ in discs.discs():
        data = readResults.table(case, "contactForces",
                                 f"box.{name}.surface.dat")
        of = [np.array([data[f"{name}.surface:{what}{c}"] for c in "xy"]).T
              for what in "FI"]
        force, impulse = force + of[0], impulse + of[1]
        friction = friction + data["frictionDissipation"]
    return data["Time"], force, impulse, friction


def outlines(case, time):
    """For each disc the corners of its boundary, in order, at their current
    positions."""
    found = []
    bodies = readFields.Reader(case).read(time, "surface", ("pointD",))
    for body in bodies.values():
        X = np.asarray(body.points, dtype=float)
        D = np.asarray(body.point_data["pointD"], dtype=float)
        front = X[:, 2] > X[:, 2].mean()
        X, x = X[front, :2], (X + D)[front, :2]
        angle = np.arctan2(*(X - X.mean(axis=0)).T)
        found.append(x[np.argsort(-angle)])
    return found


def depth(points, polygon):
    """How deep points are in a polygon; 0 outside."""
    a, b = polygon, np.roll(polygon, -1, axis=0)
    p = points[:, None]
    along = b - a
    s = np.clip(((p - a)*along).sum(-1)/(along**2).sum(-1), 0, 1)
    distance = np.linalg.norm(p - a - s[..., None]*along, axis=-1).min(1)
    crosses = (a[:, 1] > p[..., 1]) != (b[:, 1] > p[..., 1])
    with np.errstate(divide="ignore", invalid="ignore"):
        x = a[:, 0] + (p[..., 1] - a[:, 1])*along[:, 0]/along[:, 1]
    inside = (crosses & (p[..., 0] < x)).sum(1) % 2 == 1
    return np.where(inside, distance, 0)


def overlaps(case, time):
    """Largest depths [m] of a corner in another disc, and in the box."""
    shapes = outlines(case, time)
    low = np.array([s.min(axis=0) for s in shapes])
    high = np.array([s.max(axis=0) for s in shapes])
    deepest = 0
    for i, shape in enumerate(shapes):
        near = ((low < high[i]) & (high > low[i])).all(axis=1)
        near[i] = False
        for j in np.flatnonzero(near):
            deepest = max(deepest, depth(shape, shapes[j]).max())
    beyond = max((-low).max(), (high[:, 0] - discs.WIDTH).max(), 0)
    return deepest, beyond


def ledger(case):
    """Times, and the parts of the energy [J/m]; the first part is the sum of
    the others."""
    data = readResults.table(case, "solidEnergies", "energies.dat")
    total = {key[6:]: data[key] for key in data if key.startswith("total:")}
    first = total["kinetic"][0] + total["strain"][0]
    return data["Time"], {
        "at first, and work of gravity": first + total["externalWork"],
        "friction": total["frictionDissipation"],
        "what contact takes beside friction":
            -total["contactWork"] - total["frictionDissipation"],
        "numerical dissipation": total["numericalDissipation"],
        "kinetic energy": total["kinetic"],
        "strain energy": total["strain"]}


def momentumResidual(case, nQuarter):
    """Residual of the momentum balance at the end of a run, in x and in y,
    relative to the impulse of gravity. Velocities of the leapfrog are half a
    step behind the time."""
    momentum = readResults.table(case, "solidEnergies", "momentum.dat")
    times, _, impulse, _ = box(case)
    state = Path(case)/f"{times[-1]:.10g}"/"uniform"/"solidSystem"
    step = float(re.search(r"lastStep +(\S+);", state.read_text())[1])
    gravity = mass(nQuarter)*GRAVITY*(times[-1] - 0.5*step)
    p = np.array([momentum[f"total:p{c}"][[0, -1]] for c in "xy"])
    return (p[:, 1] - p[:, 0] - impulse[-1] + (0, gravity))/gravity
