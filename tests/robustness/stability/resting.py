"""Bodies that slide on another and come to rest, and that rest for long."""

import numpy as np

from smallCases import (ELASTIC, Body, condition, coulomb, interface, largest)

from .free import rubber
from .judge import outcome, ownEnergy, small

FLOOR = {"type": "plane", "planeType": "pointAndNormal",
         "pointAndNormalDict": {"point": (0, 0, 0), "normal": (0, 1, 0)}}


def every(steps):
    """Energies and contact forces once in so many steps."""
    return {"functions": {name: {
        "type": name, "libs": "(vertexContact)", "writeControl": "timeStep",
        "writeInterval": steps} for name in ("solidEnergies",
                                             "contactForces")}}


def clamp(side):
    return {side: condition("fixedVelocity", velocity=(0, 0, 0))}


def support(on, law, base):
    """The interface of the block with what it lies on, and the bodies that
    there are in addition."""
    if on == "clamp":
        return None, []
    if on == "plane":
        return {"contact": {"side": ("block", "bottom"), "obstacle": FLOOR,
                            "law": law}}, []
    return {"contact": interface(
        ("block", "bottom"), ("base", "top"), law,
        pairing="AMI" if law["type"] == "tied" else "nearestFace")}, [base]


def friction(folder, on, coefficient, maxCo=None):
    """A block under its weight, in equilibrium, slides on a plane or on a
    clamped base. Its way is that of a rigid block, v t - k g t^2/2 until it
    stops, but for what it shears and rocks."""
    speed, g, height, time = 0.06, 0.02, 0.5, 10

    def settled(X):
        # sigma_yy = -rho g (top - y)
        return -g*(height*X[:, 1:2] - X[:, 1:2]**2/2)*(0, 1, 0)

    block = Body(cells=(8, 3), name="block", size=(2, height, 1),
                 material=ELASTIC, velocity=(speed, 0, 0),
                 displacement=settled, sides={"bottom": "contact"})
    base = Body(cells=(15, 3), name="base", start=(-0.5, -height, 0),
                size=(3.5, height, 1), material=ELASTIC, sides={
                    **clamp("bottom"), "top": "contact"})
    interfaces, more = support(on, coulomb(coefficient), base)
    case = small(folder, [block, *more], time, maxCo, gravity=(0, -g, 0),
                 interfaces=interfaces, functions=("contactForces",))
    start = 0.5*2*height*speed**2

    def check(case):
        stop = speed/(coefficient*g) if coefficient else np.inf
        t = min(time, stop)
        way = speed*t - coefficient*g*t**2/2
        slid = case.at("pointD", region="block")[
            np.abs(case.X("block")[:, 1]) < 1e-9, 0].mean()
        yield "way/(v t)", slid/(speed*time), *(
            way/(speed*time) + np.array((-0.1, 0.1)))
        yield ("work of contact", largest(np.maximum(
            case.energies["total:contactWork"], 0))/start, 0, 1e-2)
        yield ("penetration", case.contact("contact")["penetration"].max()
               / height*3, 0, 0.1)
    return outcome(case, check, scale=start)


def settling(folder, on, friction, cells, steps, weight=0.05, ratio=2,
             maxCo=None):
    """Gravity is set on at once: a block on a plane, on a clamped base, or
    clamped itself, bounces in itself until its own dissipation brings it to
    rest. In the second half of the time nothing may happen: creep is the rise
    of the energy, by the largest kinetic one, drift the change of the
    displacement of any node, by a cell. The first bounces are strong, against
    which the limits of rise and balance are wide. weight: of the block on its
    base, over Young's modulus; ratio: base cells by length to those of the
    block; on 'tied': to the base, paired by AMI."""
    dimensions, g = len(cells.split("x")), weight
    counts = tuple(int(n) for n in cells.split("x"))
    material, cp, _ = rubber(0.3)
    block = Body(cells=counts, name="block", material=material, sides=clamp(
        "bottom") if on == "clamp" else {"bottom": "contact"})
    base = Body(cells=(round(ratio*counts[0]), *counts[1:]), name="base",
                start=(-0.5, -1, 0), size=(2, 1, 1), material=material,
                sides={**clamp("bottom"), "top": "contact"})
    interfaces, more = support(
        on, {"type": "tied"} if on == "tied" else coulomb(friction), base)
    # A step in transits of a cell
    time = steps*{2: 0.155, 3: 0.11}[dimensions]/counts[0]/cp
    case = small(
        folder, [block, *more], time, maxCo,
        {"writeInterval": time/4, **every(max(1, steps//5000))},
        interfaces=interfaces, gravity=(0, -g, 0))

    def check(case):
        kinetic = case.energies["total:kinetic"]
        own, half = ownEnergy(case), len(kinetic)//2
        top = kinetic.max()
        yield "creep", (own[half:] - own[half]).max()/top, -1, 1e-3
        yield "kinetic at the end", kinetic[half:].max()/top, 0, 1e-3
        first, last = (case.at("pointD", case.times[i], "block")
                       for i in (1, 3))
        yield "drift", largest(last - first)*counts[1], 0, 0.01
        if on in ("plane", "body"):
            # That of a corner that digs in
            yield ("penetration", case.contact("contact")[
                "penetration"].max()*counts[1], 0, 0.15)
    return outcome(
        case, check, lambda case: case.energies["total:kinetic"].max(),
        riseLimit=0.05, balanceLimit=0.15)
