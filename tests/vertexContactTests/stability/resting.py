"""Bodies that slide on another and come to rest, and that rest for long."""

from itertools import product

import numpy as np

from vertexContactCases import readResults
from vertexContactTests.smallCases import (ELASTIC, FLOOR, Body, condition,
                                           coulomb, interface, largest, table)

from .free import STEP, counts, rubber
from .judge import outcome, ownEnergy, small


def every(steps, points):
    """Write energies, contact forces, and displacements of points of the
    block, once in so many steps."""
    functions = {name: {"type": name} for name in ("solidEnergies",
                                                   "contactForces")}
    functions["block"] = {"type": "pointProbes", "region": "block",
                          "points": points, "fields": "(pointD)"}
    return {"functions": {name: {
        **function, "libs": "(vertexContact)", "writeControl": "timeStep",
        "writeInterval": steps} for name, function in functions.items()}}


def clamp(side):
    return {side: condition("fixedVelocity", velocity=(0, 0, 0))}


def support(on, law, base):
    """The interface between the block and its support, and the additional
    bodies."""
    if on == "plane":
        return {"contact": {"side": ("block", "bottom"), "obstacle": FLOOR,
                            "law": law}}, []
    return {"contact": interface(
        ("block", "bottom"), ("base", "top"), law,
        pairing="AMI" if law["type"] == "tied" else "nearestFace")}, [base]


def friction(folder, on, coefficient, **how):
    """A block in equilibrium under its weight slides on a plane or on a
    clamped base. Its path is that of a rigid block, v t - k g t^2/2 until it
    stops, apart from its shearing and rocking."""
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
    case = small(folder, [block, *more], time, gravity=(0, -g, 0),
                 interfaces=interfaces, functions=("contactForces",), **how)
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


def resting(folder, **how):
    """The scene of the last section, with a damping in the first quarter of the
    time. Then all is at rest, and in a million steps nothing may disturb it;
    all rows have the same limits. slope: of the base, by the angle of
    friction."""
    return settling(folder, helped=True, **how)


def settling(folder, on, friction, cells, ratio, weight, steps, slope=0,
             helped=False, **how):
    """Gravity is switched on at once. A block on a plane, or on a clamped
    base, vibrates until the dissipation of its waves brings it to rest. Then
    nothing may happen. Drift: largest distance of a corner of the block from its final
    place in the second half of the time, by the length of a cell. Kinetic
    energy: by the largest one. Creep: rise of the kept energy in the second
    half. Rise: that of the largest energies of each hundredth of the time,
    since contact stores some energy and returns it. Both are relative to the
    energy that is lost from the start to the end. weight: stress of the block
    on its base, over Young's modulus; ratio: length of the block's cells over
    that of the base's; on 'tied': tied to the base, paired by AMI. Without
    friction no block rests on a body for ever: the base is softer towards its
    edges, and the block slides off, as physics has it. Here symmetry holds it
    in the middle, and it has only to lose energy. Swinging along the base dies
    out slowly, on fine bases not within a million steps."""
    n, g = counts(cells), weight
    material, cp, _ = rubber(0.3)
    fine = round(2*ratio*n[0]), n[1], *(round(ratio*m) for m in n[2:])
    half = ({"left": "symmetryPlane"} if on == "body" and friction == 0
            else {})
    block = Body(cells=n, name="block", material=material,
                 sides={**half, "bottom": "contact"})
    base = Body(cells=fine, name="base", start=(0 if half else -0.5, -1, 0),
                size=(2, 1, 1), material=material,
                sides={**half, **clamp("bottom"), "top": "contact"})
    interfaces, more = support(
        on, {"type": "tied"} if on == "tied" else coulomb(friction), base)
    time = steps*STEP[len(n)]/n[0]/cp
    if on != "plane":
        # From the mean of the squares of the inverse lengths of the base cells
        time /= np.sqrt(((len(n) - 1)*ratio**2 + 1)/len(n))
    corners = tuple(product((0, 1), (0, 1), (0, 1)[:len(n) - 1]))
    control = every(max(1, steps//5000), corners)
    if helped:
        # For the slowest waves, whose period is some units of time
        control["damping"] = {'".*"': {"coefficient": table(
            (0, 1), (0.2*time, 1), (0.25*time, 0))}}
    angle = slope*np.arctan(friction)
    case = small(folder, [block, *more], time, control, interfaces=interfaces,
                 gravity=(g*np.sin(angle), -g*np.cos(angle), 0), **how)

    rests = steps >= 10**6
    swings = on == "body" and friction == 0 and not helped

    def check(case):
        kinetic = case.energies["total:kinetic"]
        own, half = ownEnergy(case), len(kinetic)//2
        top = kinetic.max()
        creep = (own[half:] - own[half]).max()/-own[-1]
        late = [D[len(D)//2:] - D[-1] for D in (readResults.probe(
            case.path, "block", "pointD", i)[1] for i in range(len(corners)))]
        yield "creep", creep, -1, 1e-3
        yield ("kinetic at the end", kinetic[-half//10:].max()/top, 0,
               1 if swings else 1e-12 if rests else 1e-3)
        yield ("drift", largest(late)*n[1], 0,
               None if swings else 1e-9 if rests else 0.01)
        if on in ("plane", "body"):
            # The penetration of a corner that digs in
            yield ("penetration", case.contact("contact")[
                "penetration"].max()*n[1], 0, 1e-12 if on == "plane" else 0.15)
    return outcome(case, check, lambda case: -ownEnergy(case)[-1],
                   riseLimit=0.01, balanceLimit=0.15, parts=100)
