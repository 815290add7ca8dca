"""Cases of blocks with the default scheme, and their common parts."""

import numpy as np

from vertexContactTests.smallCases import (FLOOR, RUBBER, Body, SmallCase,
                                           condition, interface)

HARD = dict(RUBBER, nu=0.4)
STEEP = dict(RUBBER, nu=0.4995)             # its Jacobian is smoothed
# speed of pressure waves in HARD
SPEED = np.sqrt((1 - 0.4)/((1 + 0.4)*(1 - 0.8)))
CLAMPED = {"bottom": condition("fixedVelocity", velocity=(0, 0, 0))}


def defaultCase(folder, bodies, endTime, control=None, every=None, **more):
    """A SmallCase that writes a row of energies, and of forces if there is
    contact, every so many steps."""
    functions = {name: {"type": name, "libs": "(vertexContact)",
                        "writeControl": "timeStep",
                        "writeInterval": every or 1}
                 for name in ("solidEnergies", "contactForces")
                 if name == "solidEnergies" or more.get("interfaces")}
    return SmallCase(folder, bodies, endTime, control={
        "preset": "balanced", "maxCo": 0.9, "logInterval": 100000,
        "functions": functions, **(control or {})}, **more)


def rough(dimensions, spin=0.1, noise=0.02, seed=1):
    """A rotation plus a different random velocity at each point."""
    def velocity(X):
        place = np.round(X[:, :dimensions]*1e6).astype(int)
        _, which = np.unique(place, axis=0, return_inverse=True)
        random = np.random.default_rng(seed).standard_normal(
            (which.max() + 1, 3))[which.ravel()]
        v = spin*np.cross((0, 0, 1), X - 0.5) + noise*random
        v[:, dimensions:] = 0
        return v
    return velocity


# F behind the shock, by the speed of a bar relative to SPEED
BEHIND = {0.5: 0.5514, 1.0: 0.2831, 1.2: 0.2259}


def barAgainst(folder, against, cells, speed):
    """A bar of cubic cells, one metre long, with mirrors on its sides. It hits
    its mirror image, a plane, or an equal body at speed times SPEED. The run
    ends when shocks have travelled along a third of it."""
    across = [n/cells[0] for n in cells[1:]]
    mirrors = ("bottom", "top", "back", "front")[:2*len(across)]
    v = speed*SPEED

    def bar(name, start, direction, touching):
        return Body(cells, name=name, start=(start, 0, 0),
                    size=(1, *across, 1, 1)[:3], material=HARD,
                    velocity=(direction*v, 0, 0), sides={
                        **dict.fromkeys(mirrors, "symmetryPlane"),
                        ("right" if direction > 0 else "left"): touching})
    bodies, interfaces = [bar("body", 0, 1, "contact")], None
    if against == "mirror":
        bodies = [bar("body", 0, 1, "symmetryPlane")]
    elif against == "plane":
        interfaces = {"wall": {"side": ("body", "right"), "obstacle": {
            **FLOOR, "pointAndNormalDict": {"point": (1, 0, 0),
                                            "normal": (-1, 0, 0)}}}}
    else:
        bodies.append(bar("other", 1, -1, "contact"))
        interfaces = {"bars": interface(("body", "right"), ("other", "left"))}
    return defaultCase(folder, bodies, 0.35/(SPEED + v),
                       interfaces=interfaces).run()


def checkShock(f, run, speed, y=0):
    """Check that there is no saw-tooth behind the shock of such a bar, along a
    line of its nodes with equal y and z."""
    X = run.X("body")
    line = np.isclose(X[:, 1], y) & np.isclose(X[:, 2], y)
    x, F = X[line, 0], run.at("F", region="body")[line, 0]
    behind = F[np.argsort(x)][(np.sort(x) > 0.85) & (np.sort(x) < 0.97)]
    saw = np.abs(behind[1:-1] - (behind[2:] + behind[:-2])/2)/2
    f.within("F behind the shock", behind.mean(), BEHIND[speed], 2e-3)
    f.atMost("saw-tooth / strain", saw.max()/(1 - behind.mean()), 3e-3)
