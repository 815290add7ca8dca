"""Bodies that hit each other: fast and slow, light and heavy, with surfaces
that do not match, with gaps and from inside each other, with one cell each,
ten in a row, and in other units."""

import numpy as np

from vertexContactTests.caseTools import PRESET
from vertexContactTests.smallCases import (ELASTIC, RUBBER, Body, condition,
                                           distorted, interface, largest)

from .free import anyModes, rubber
from .judge import RISE, momentumChange, outcome, small

PAIRINGS = "matching", "AMI", "nearestFace"
FORCES = {"functions": ("contactForces",)}


def upTo(limit, paper, how):
    """The limit of a figure. The paper's scheme has another limit, since its
    surfaces drift into each other."""
    return paper if how.get("preset") == PRESET else limit


def meanVelocity(case, body, mass, time=-1):
    return case.momentumOf(body)[time, 0]/mass


def bar(name, cells, start=0, length=1, speed=0, material=RUBBER, gap=0,
        width=None, **more):
    """A bar along x, with cells along it, and across it in 2D. Both ends may
    touch."""
    size = (length, width or length*(cells[-1]/cells[0]), 1)
    return Body(cells=cells, name=name, start=(start + gap, 0, 0),
                size=size[:len(cells)] + (1,)*(3 - len(cells)),
                material=dict(material), velocity=(speed, 0, 0),
                sides={"left": "contact", "right": "contact"}, **more)


def ends(left, right, **settings):
    """The interface between the right end of a bar and the left end of the
    next."""
    return {left + right: interface((left, "right"), (right, "left"),
                                    **settings)}


def outer(first, last):
    """The outer ends of a row of bars are no contact patches."""
    first.sides = {"right": "contact"}
    last.sides = {"left": "contact"}


def apart(case, name):
    yield "area at the end", case.contact(name)["area"][-1], 0, 0


# Two deformable blocks at the default, and away from it

def collision(folder, nu, **how):
    """Two distorted 3D blocks, in contact from the start, run into each other
    with a fifth of the speed of shear waves. In addition all modes are
    excited."""
    material, cp, cs = rubber(nu)
    bodies = []
    for name, x, sign, side in (("left", 0, 1, "right"),
                                ("right", 1, -1, "left")):
        start = (x, 0, 0)
        modes = anyModes(0.02*cs, 3, seed=2 + sign)
        bodies.append(Body(
            cells=(3, 3, 3), name=name, start=start, material=material,
            moved=distorted(0.3, start=start), sides={side: "contact"},
            velocity=lambda X, modes=modes, sign=sign:
                modes(X) + (0.1*sign*cs, 0, 0)))
    case = small(folder, bodies, min(3/cs, 20/cp), {"writeControl": "none"},
                 interfaces=ends("left", "right"), **FORCES, **how)

    def check(case):
        scale = 0.1*cs
        yield "momentum", momentumChange(case, scale), 0, 1e-12
        yield ("penetration", case.contact("leftright")[
            "penetration"].max()*3, 0, upTo(0.01, 0.1, how))
    return outcome(case, check)


# Bars

def mach(folder, cells, speed, **how):
    """A bar hits an equal one at rest; its speed is given relative to that of
    sound. Such strong waves dissipate. Momentum must be kept, and no energy
    made."""
    material, cp, _ = rubber(0.3)
    counts = tuple(int(n) for n in cells.split("x"))
    bodies = (bar("left", counts, speed=speed*cp, material=material),
              bar("right", counts, 1, material=material))
    outer(*bodies)
    case = small(folder, bodies, 6/cp, {"writeControl": "none"},
                 interfaces=ends("left", "right"), **FORCES, **how)

    def check(case):
        mass = np.prod(bodies[0].size)
        back = (meanVelocity(case, "right", mass)
                - meanVelocity(case, "left", mass))/(speed*cp)
        yield "momentum", momentumChange(case, mass*speed*cp), 0, 1e-12
        yield ("rebound", back, 0.9 if len(counts) == 1 and speed <= 0.01
               else upTo(0.6, 0.2, how), 1)
        # The half cells at the ends touch first. With the paper's scheme they
        # penetrate by a third of a cell at Mach 1
        yield ("penetration", case.contact("leftright")["penetration"].max()
               * counts[0], 0, upTo(0.01, 0.06 + 0.36*speed, how))
        yield from apart(case, "leftright")
    return outcome(case, check)


def impedance(folder, dimensions, by, ratio, **how):
    """A bar hits a bar at rest whose impedance rho c is ratio times its own,
    in 2D with free sides (nu = 0). The exact solution: it leaves with
    (1 - ratio)/(1 + ratio) of its velocity, for a rigid wall with -1 of it,
    unless the other bar is softer or a wave returns from that bar earlier.
    by: what makes the impedance. The other bar is so long that its waves
    return no earlier."""
    speed = 1e-3
    E, rho, length = {"both": (ratio, ratio, 1), "rho": (1, ratio**2, 1),
                      "E": (ratio**2, 1, ratio)}[by]
    other = {**ELASTIC, "E": E, "rho": rho}
    material = {**other, "E": 1, "rho": 1}
    cells = {1: (40,), 2: (20, 4)}[dimensions]
    width = cells[-1]/cells[0]
    bodies = (bar("left", cells, speed=speed, material=material, width=width),
              bar("right", cells, 1, length, material=other, width=width))
    outer(*bodies)
    case = small(folder, bodies, 3, {"writeControl": "none"},
                 interfaces=ends("left", "right"), **FORCES, **how)

    def check(case):
        mass = np.prod(bodies[0].size)
        exact = (1 - ratio)/(1 + ratio)
        error = meanVelocity(case, "left", mass)/speed - exact
        yield "momentum", momentumChange(case, mass*speed), 0, 1e-9
        yield "error of the velocity", error, -0.1, 0.1
        yield ("penetration", case.contact("leftright")["penetration"].max()
               * cells[0], 0, upTo(1e-3, 0.05, how))
        yield from apart(case, "leftright")
    return outcome(case, check)


def gap(folder, dimensions, pairing, cell, **how):
    """Bars that are at first so many cells apart, or inside each other (less
    than 0). Exact (nu = 0): contact begins after gap/speed, and velocities
    are exchanged. Bars inside each other are pushed apart as they collide.
    No body has given the energy for this; its rise is bounded."""
    n, speed = 20, 0.02
    cells = {1: (n,), 2: (n, 4)}[dimensions]
    material = {**RUBBER, "nu": 0}
    left = bar("left", cells, speed=speed, material=material)
    right = bar("right", cells, 1, material=material, gap=cell/n)
    outer(left, right)
    start = max(cell, 0)/n/speed
    case = small(folder, (left, right), start + 4, {"writeControl": "none"},
                 interfaces=ends("left", "right", pairing=pairing), **FORCES,
                 **how)

    def check(case):
        mass = np.prod(left.size)
        contact = case.contact("leftright")
        t = contact["Time"][contact["area"] > 0]
        yield "momentum", momentumChange(case, mass*speed), 0, 1e-12
        yield ("begins late", t[0] - start if len(t) else np.inf, -0.1, 0.1)
        yield ("velocity passed on", meanVelocity(case, "right", mass)/speed,
               0.9, 1.1)
        yield ("deeper than at first", contact["penetration"].max()*n
               - max(-cell, 0), -1, upTo(0.005, 0.05, how))
        yield "inside at the end", contact["penetration"][-1]*n, 0, 0.01
        yield from apart(case, "leftright")
    return outcome(case, check, riseLimit=0.02 if cell < 0 else RISE)


# Surfaces that do not match

def faces(folder, dimensions, pairing, ratio, **how):
    """Two blocks meet with an offset; their faces are 1:ratio along x."""
    low = {2: (2, 2), 3: (2, 2, 2)}[dimensions]
    high = (2*ratio, 4, 3)[:dimensions]
    speed = 0.05
    bodies = (
        Body(cells=low, name="low", velocity=(0, speed, 0),
             sides={"top": "contact"}),
        Body(cells=high, name="high", velocity=(0, -speed, 0),
             start=(0.3, 1.01, 0.15 if dimensions == 3 else 0),
             sides={"bottom": "contact"}))
    case = small(folder, bodies, 1.5, {"writeControl": "none"},
                 interfaces={"contact": interface(
                     ("low", "top"), ("high", "bottom"), pairing=pairing)},
                 **FORCES, **how)

    def check(case):
        change = case.momentumOf("high")[-1, 1] + speed
        yield "momentum", momentumChange(case, speed), 0, 1e-12
        yield "impulse", change/speed, 0.8, 2
        yield ("penetration", case.contact("contact")["penetration"].max()*2,
               0, upTo(0.05, 0.1, how))
    return outcome(case, check)


def pressed(folder, dimensions, pairing, ratio, **how):
    """A uniform pressure acts across faces of 1:ratio; nothing may move."""
    stretch, mu, kappa = 0.9, 0.5/1.3, 1/1.2
    b = np.diag((1, stretch**2, 1))
    stress = (mu*stretch**(-5/3)*(b - np.trace(b)/3*np.eye(3))
              + kappa*(stretch - 1)*np.eye(3))[1, 1]
    mirror = dict.fromkeys(("left", "right", "back", "front")[:2*(
        dimensions - 1)], "symmetryPlane")
    squeezed = {"displacement": lambda X: (stretch - 1)*X*(0, 1, 0)}
    bodies = (
        Body(cells=(2,)*dimensions, name="low", **squeezed,
             sides={**mirror, "bottom": "symmetryPlane", "top": "contact"}),
        Body(cells=(2*ratio, 4, 3)[:dimensions], name="high",
             start=(0, 1, 0), **squeezed,
             sides={**mirror, "bottom": "contact",
                    "top": condition("pressure", pressure=-stress)}))
    case = small(folder, bodies, 0.5, interfaces={
        "contact": interface(("low", "top"), ("high", "bottom"),
                             pairing=pairing)}, **how)

    def check(case):
        for body in bodies:
            sigma = case.at("sigma", region=body.name)[:, 3]
            yield (f"stress in {body.name}", largest(sigma/stress - 1), 0,
                   1e-9)
            yield (f"velocity in {body.name}", largest(
                case.at("pointU", region=body.name)), 0, 1e-9)
    return outcome(case, check)


# One cell a body, ten bodies in a row

def single(folder, dimensions, pairing, **how):
    """Two bodies of one cell each collide. The energy that contact stores and
    returns to separate them is not small compared with that of one cell."""
    speed = 0.05
    bodies = (bar("left", (1,)*dimensions, speed=speed),
              bar("right", (1,)*dimensions, 1, gap=0.01))
    outer(*bodies)
    case = small(folder, bodies, 6, {"writeControl": "none"},
                 interfaces=ends("left", "right", pairing=pairing), **FORCES,
                 **how)

    def check(case):
        back = (meanVelocity(case, "right", 1)
                - meanVelocity(case, "left", 1))/speed
        yield "momentum", momentumChange(case, speed), 0, 1e-12
        yield "rebound", back, 0.2, 1
        yield from apart(case, "leftright")
    return outcome(case, check, riseLimit=0.05)


def cradle(folder, dimensions, gap, bodies=10, **how):
    """The first of ten equal bars moves (nu = 0). In theory the last one
    leaves with its velocity, and the others rest. Gaps are in cells."""
    n, speed = 20, 0.01
    cells = {1: (n,), 2: (n, 2)}[dimensions]
    material = {**RUBBER, "nu": 0}
    names = [f"bar{i}" for i in range(bodies)]
    row = [bar(name, cells, i*(1 + gap/n), material=material,
               speed=speed if i == 0 else 0) for i, name in enumerate(names)]
    outer(row[0], row[-1])
    interfaces = {}
    for pair in zip(names, names[1:]):
        interfaces |= ends(*pair)
    time = bodies + 2 + (bodies - 1)*gap/n/speed
    case = small(folder, row, time, {"writeControl": "none"},
                 interfaces=interfaces, **how)

    def check(case):
        mass = np.prod(row[0].size)
        v = [meanVelocity(case, name, mass)/speed for name in names]
        yield "momentum", momentumChange(case, mass*speed), 0, 1e-12
        # Nine impacts with gaps dissipate more than one wave through all bars
        yield "velocity of the last", v[-1], 0.9 if gap == 0 else 0.75, 1.01
        yield "largest of the others", largest(v[:-1]), 0, 0.1
    return outcome(case, check)


# Units

UNITS = {"Pa m": (1, 1), "Pa mm": (1, 1e-3), "MPa mm": (1e6, 1e-3),
         "GPa mm": (1e9, 1e-3), "GPa km": (1e9, 1e3), "Pa um": (1, 1e-6),
         "GPa nm": (1e9, 1e-9)}


def steelBlocks(folder, pairing, units, how):
    """Steel blocks of 0.1 m that hit each other, with all numbers in units of
    a pressure and a length; time in seconds. Returns the case and the units
    of its results."""
    pressure, length = UNITS[units]
    steel = {"type": "neoHookean", "rho": 7800*length**2/pressure,
             "E": 210e9/pressure, "nu": 0.3}
    side = 0.1/length
    bodies = [Body(
        cells=(4,)*2, name=name, size=(side, side, 1),
        start=(start*side, 0, 0), material=steel,
        velocity=(speed/length, 0.2*speed/length, 0),
        sides={end: "contact"}) for name, start, speed, end in (
            ("left", 0, 50, "right"), ("right", 1.001, -50, "left"))]
    case = small(folder, bodies, 1e-4, interfaces=ends(
        "left", "right", pairing=pairing), **FORCES, **how)
    return case, {"pointU": 100/length, "pointD": 0.01/length, "F": 1,
                  "sigma": 210e9/pressure}


def units(folder, pairing, units, **how):
    """The same scene in other units must give the same numbers."""
    folder.mkdir()
    reference, one = steelBlocks(folder/"reference", pairing, "Pa m", how)
    reference.run()
    case, other = steelBlocks(folder/"case", pairing, units, how)

    def check(case):
        for name in one:
            yield f"difference of {name}", max(largest(
                case.at(name, region=r)/other[name]
                - reference.at(name, region=r)/one[name])
                for r in ("left", "right")), 0, 1e-9
        yield ("impulse", abs(case.contact("leftright")["left.right:Ix"][-1])
               / (7800*0.1*100*0.1*UNITS[units][1]**-1
                  / UNITS[units][0]), 0.1, 2)
    return outcome(case, check, riseLimit=0.02)


# The scheme of the paper

PAPER = {
    "bars, 0.001 of their speed of waves": (mach, {
        "cells": "40", "speed": 0.001}, {}),
    "the same in 2D": (mach, {"cells": "20x4", "speed": 0.001}, {}),
    "bars, 0.1": (mach, {"cells": "40", "speed": 0.1}, {}),
    "bars, 0.5": (mach, {"cells": "40", "speed": 0.5}, {}),
    "bars, 0.5, stretched": (mach, {"cells": "40", "speed": 0.5}, {
        "waveSpeed": "stretched"}),
    "bars, 1, stretched": (mach, {"cells": "40", "speed": 1}, {
        "waveSpeed": "stretched"}),
    "impedances 1:100": (impedance, {
        "dimensions": 1, "by": "both", "ratio": 100}, {}),
    "a gap of a cell": (gap, {
        "dimensions": 2, "pairing": "matching", "cell": 1}, {}),
    "faces 1:4": (faces, {"dimensions": 2, "pairing": "AMI", "ratio": 4}, {}),
    "faces 1:4 in 3D": (faces, {
        "dimensions": 3, "pairing": "AMI", "ratio": 4}, {}),
    "blocks, nu 0.3": (collision, {"nu": 0.3}, {}),
    "blocks, nu 0.499": (collision, {"nu": 0.499}, {}),
    "ten bars in a row": (cradle, {"dimensions": 1, "gap": 0}, {})}


def paper(folder, scene, reconstruction):
    """Impacts as those above, with preset paper. Stretched: waveSpeed."""
    run, parameters, scheme = PAPER[scene]
    return run(folder, **parameters, preset=PRESET, scheme={
        "reconstruction": reconstruction, **scheme})
