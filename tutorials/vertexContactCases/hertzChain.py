"""A row of equal spheres with gaps as point masses, and the same quantities of
a run. Between neighbours acts the force of Hertz, K d^(3/2) at the approach d
(Herrmann and Schmaelzle, Am. J. Phys. 49 (1981) 761), with or without the
terms of first order in the ratio of the contact radius to the sphere
radius."""

from math import pi, sqrt

import numpy as np

from vertexContactCases import readResults

SPHERES = 5
RADIUS = 0.01       # m
SPEED = 0.1         # velocity of the first sphere [m/s]
RHO = 1000          # kg/m3
E = 1e6             # Pa
NU = 0.4
GAP = 5e-6          # unless Allrun has another value [m]

MASS = 4/3*pi*RADIUS**3*RHO
# Two equal spheres: half of the modulus, half of the radius
STIFFNESS = 4/3*E/(2*(1 - NU**2))*sqrt(RADIUS/2)
# For two spheres alone
APPROACH = (5*MASS*SPEED**2/(8*STIFFNESS))**0.4
FORCE = STIFFNESS*APPROACH**1.5
DURATION = 2.9432752*APPROACH/SPEED


def compliances(a=0.1*RADIUS, terms=20000):
    """Displacements by a unit load on one end of a sphere, in addition to
    Hertz [m/N]: of this end, and of the opposite end towards the centre of
    mass. Series of Legendre for a sphere that its inertia holds, with Hertz's
    pressure on the radius a, minus the half space. Between 0.05 and 0.15
    radii, a changes the former by 5 % and the latter by 1 %."""
    n = np.arange(terms + 1.0)
    n[1] = np.nan       # The whole sphere is accelerated
    g = ((4*(1 - NU)*n**2 + 2*NU*n - 2 + 4*NU)
         / (2*(n - 1)*(n**2 + n + 1 + NU*(2*n + 1))))
    s = (n + 0.5)*a/RADIUS
    c = (2*n + 1)*g*3*(np.sin(s) - s*np.cos(s))/s**3
    inertia = 1.8*(1 - 2*NU)/(1 + NU)
    own = np.nansum(c) + inertia - 3*pi*(1 - NU)*RADIUS/a
    opposite = np.nansum(c*(-1)**np.arange(terms + 1)) - inertia
    unit = 8*pi*RADIUS*E/(2*(1 + NU))
    return own/unit, opposite/unit


def chain(end, gap=GAP, finite=False, spheres=SPHERES, speed=SPEED,
          a=0.1*RADIUS, steps=4000):
    """Times, velocities of the spheres / that of the first at the start, and
    forces of the contacts.

    finite      spheres are no half spaces: with compliances(a)
    """
    own, opposite = compliances(a) if finite else (0, 0)
    dt = end/steps
    x, v = np.zeros((2, spheres))
    v[0] = speed
    # Forces of the contacts, between two zeros
    F = np.zeros(spheres + 1)

    def solve():
        """Forces at given displacements, from the forces of the previous
        step."""
        for _ in range(100):
            old = F.copy()
            local = (x[:-1] - x[1:] - gap - 2*own*F[1:-1]
                     - opposite*(F[:-2] + F[2:]))
            F[1:-1] = STIFFNESS*np.maximum(local, 0)**1.5
            if np.abs(F - old).max() <= 1e-12*FORCE:
                return
        raise RuntimeError("forces do not converge")

    velocities, forces = [v], [F[1:-1].copy()]
    for _ in range(steps):
        v = v - dt/2*np.diff(F)/MASS
        x = x + dt*v
        solve()
        v = v - dt/2*np.diff(F)/MASS
        velocities.append(v)
        forces.append(F[1:-1].copy())
    return (np.linspace(0, end, steps + 1), np.array(velocities)/speed,
            np.array(forces))


def velocities(case):
    """Times, and velocities of the centres of mass relative to that of the
    first sphere at the start, from a run; the masses are equal."""
    data = readResults.table(case, "solidEnergies", "momentum.dat")
    p = np.array([data[f"sphere{i}:px"] for i in range(1, SPHERES + 1)]).T
    return data["Time"], p/p[0, 0]


def contactForces(case):
    """{i: (times, forces)} of the contacts between the spheres i and i + 1,
    from a run; the model is a quarter."""
    data = readResults.table(case, "contactForces", "all.dat")
    first = np.minimum(*(
        [int(side.split(".")[0][len("sphere"):]) for side in data[name]]
        for name in ("minus", "plus")))
    force = 4*np.abs(data["minus:Fx"])
    return {int(i): (data["Time"][first == i], force[first == i])
            for i in np.unique(first)}
