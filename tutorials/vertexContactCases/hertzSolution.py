"""Quasi-static impact of an elastic sphere on a rigid plane, frictionless
(Hertz; Johnson, Contact Mechanics, Sections 4.2 and 11.4): the force is K
delta^(3/2) at the approach delta, and nothing vibrates.

Each of two equal spheres that fly at each other behaves in the same way."""

from math import pi, sqrt

import numpy as np

RADIUS = 0.01       # m
GAP = 1e-4          # gap to the plane [m]
SPEED = 0.2         # m/s
RHO = 1000          # kg/m3
E = 1e6             # Pa
NU = 0.4

PLANE_MODULUS = E/(1 - NU**2)
MASS = 4/3*pi*RADIUS**3*RHO
STIFFNESS = 4/3*PLANE_MODULUS*sqrt(RADIUS)
FIRST_CONTACT = GAP/SPEED
APPROACH = (5*MASS*SPEED**2/(4*STIFFNESS))**0.4     # the largest
FORCE = STIFFNESS*APPROACH**1.5                     # the largest
DURATION = 2.9432752*APPROACH/SPEED


def contactRadius(force):
    return (3*force*RADIUS/(4*PLANE_MODULUS))**(1/3)


def pressure(r, force):
    """Pressure at distances r from the axis."""
    a = contactRadius(force)
    peak = 3*force/(2*pi*a**2)
    return peak*np.sqrt(np.maximum(1 - (np.asarray(r)/a)**2, 0))


def history(steps=2000):
    """Times since the first contact, and the force, until the release."""
    def rate(state):
        delta, speed = state
        return np.array((speed, -STIFFNESS*max(delta, 0)**1.5/MASS))

    times = np.linspace(0, DURATION, steps + 1)
    dt = times[1]
    states = [np.array((0, SPEED))]
    for _ in range(steps):
        s = states[-1]
        a = rate(s)
        b = rate(s + dt/2*a)
        c = rate(s + dt/2*b)
        d = rate(s + dt*c)
        states.append(s + dt/6*(a + 2*b + 2*c + d))
    delta = np.maximum(np.array(states)[:, 0], 0)
    return FIRST_CONTACT + times, STIFFNESS*delta**1.5
