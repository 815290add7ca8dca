"""Cases of blocks with the default scheme, and what they have in common."""

import numpy as np

from smallCases import RUBBER, SmallCase, condition

HARD = dict(RUBBER, nu=0.4)
STEEP = dict(RUBBER, nu=0.4995)             # the Jacobian is smoothed
# Of pressure waves in HARD
SPEED = np.sqrt((1 - 0.4)/((1 + 0.4)*(1 - 0.8)))
CLAMPED = {"bottom": condition("fixedVelocity", velocity=(0, 0, 0))}


def defaultCase(folder, bodies, endTime, control=None, every=None, **more):
    """A SmallCase with rows of energies, and of forces if there is contact, in
    each of so many steps."""
    functions = {name: {"type": name, "libs": "(vertexContact)",
                        "writeControl": "timeStep",
                        "writeInterval": every or 1}
                 for name in ("solidEnergies", "contactForces")
                 if name == "solidEnergies" or more.get("interfaces")}
    return SmallCase(folder, bodies, endTime, control={
        "preset": "balanced", "maxCo": 0.9, "logInterval": 100000,
        "functions": functions, **(control or {})}, **more)


def rough(dimensions, spin=0.1, noise=0.02, seed=1):
    """A rotation and a velocity that is different at each point."""
    def velocity(X):
        place = np.round(X[:, :dimensions]*1e6).astype(int)
        _, which = np.unique(place, axis=0, return_inverse=True)
        random = np.random.default_rng(seed).standard_normal(
            (which.max() + 1, 3))[which.ravel()]
        v = spin*np.cross((0, 0, 1), X - 0.5) + noise*random
        v[:, dimensions:] = 0
        return v
    return velocity
