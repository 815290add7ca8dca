"""Rigid regions: against theory, against obstacles, and with deformable bodies
that they touch."""

import numpy as np
import pytest

from caseTools import DEFAULT
from smallCases import (FLOOR, RUBBER, Body, SmallCase, coulomb, interface,
                        largest, table)

# The run of one rigid region has no step of its own
FIXED = {"adjustTimeStep": "no"}
GRAVITY = 9.81


def rigid(**more):
    return {"type": "rigid", "rho": 1, **more}


def spinning(center, spin, velocity=(0, 0, 0)):
    """Initial velocity of a body that turns."""
    return lambda X: np.cross(spin, X - np.array(center)) + np.array(velocity)


def angularMomentum(case, owner="total"):
    return np.array([case.momentum[f"{owner}:L{c}"] for c in "xyz"]).T


def test_compound_pendulum(tmp_path, figures):
    """Period of a rod on a pivot, small angles: 2 pi sqrt(I/(m g d))."""
    length, width, angle = 1.0, 0.1, 1e-3
    inertia = (length**2 + width**2)/12 + (length/2)**2
    period = 2*np.pi*np.sqrt(inertia/(GRAVITY*length/2))

    def tilted(X):
        c, s = np.cos(angle), np.sin(angle)
        return np.stack((c*X[:, 0] - s*X[:, 1] - X[:, 0],
                         s*X[:, 0] + c*X[:, 1] - X[:, 1], 0*X[:, 2]), axis=1)

    body = Body(cells=(2, 8, 2), start=(-width/2, -length, -width/2),
                size=(width, length, width), displacement=tilted,
                material=rigid(pivot=(0, 0, 0), freeRotation="(z)"))
    case = SmallCase(tmp_path, body, 2.2*period, gravity=(0, -GRAVITY, 0),
                     control={**FIXED, "deltaT": period/2000},
                     preset=DEFAULT).run()
    L = case.momentum["body:Lz"]
    t = case.momentum["Time"]
    up = np.flatnonzero((L[:-1] < 0) & (L[1:] >= 0))
    zero = t[up] - L[up]*(t[up + 1] - t[up])/(L[up + 1] - L[up])
    with figures("compound pendulum") as f:
        f.within("period / theory", np.diff(zero).mean()/period, 1, 1e-5)
        f.atMost("energy balance", largest(case.energies["total:balance"])
                / largest(case.energies["total:kinetic"]), 1e-4)


def test_bounce(tmp_path, figures):
    """A spinning rigid cuboid bounces on a soft block that is free, off
    centre: linear and angular momentum of the pair stay, and it takes energy
    only."""
    tool = Body(cells=(3, 3, 3), name="tool", start=(0.5, 1.02, 0.4),
                size=(0.5, 0.3, 0.7), sides={"bottom": "contact"},
                velocity=spinning((0.75, 1.17, 0.75), (0.1, 2.0, 0.05),
                                  (0, -0.1, 0)),
                material=rigid(rho=2))
    block = Body(cells=(5, 4, 6), name="block", size=(1.2, 1, 1.5),
                 sides={"top": "contact"})
    case = SmallCase(tmp_path, [tool, block], 4,
                     interfaces={"both": interface(
                         ("tool", "bottom"), ("block", "top"), coulomb(0.3),
                         pairing="nearestFace")},
                     functions=("contactForces",), preset=DEFAULT).run()
    p, L = case.momentumOf(), angularMomentum(case)
    E = case.energies["total:kinetic"] + case.energies["total:strain"]
    assert largest(case.contact("both")["tool.bottom:Fy"]) > 0
    with figures("spinning rigid cuboid bounces on a soft block") as f:
        f.atMost("linear momentum, change / initial",
                largest(p - p[0])/np.linalg.norm(p[0]), 1e-12)
        f.atMost("angular momentum, change / initial",
                largest(L - L[0])/np.linalg.norm(L[0]), 1e-12)
        f.atMost("energy / initial", E.max()/E[0], 1 + 1e-6)
        f.within("energy at the end / initial", E[-1]/E[0], 0.95, 0.05)
        f.atMost("energy balance / initial",
                largest(case.energies["total:balance"])/E[0], 1e-3)
