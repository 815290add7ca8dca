"""The drop test reduced to a mass on a spring: a rigid box on four feet, each in
uniform compression along its height.

The feet stick at both ends, which makes them stiffer by 1 + 2 S^2, with S the
loaded over the free area of a foot (A. N. Gent and P. B. Lindley, Proc. Inst.
Mech. Eng. 173 (1959) 111-122)."""

from dataclasses import dataclass

import numpy as np

SIDE = HEIGHT = 0.008       # of a foot [m]
FEET = 4
RHO, E, NU = 1100, 2e6, 0.45
BOX = 1050*(0.06*0.04*0.03 - 0.052*0.032*0.022)     # [kg]
FEET_MASS = FEET*RHO*SIDE**2*HEIGHT
SPEED = 2                   # [m/s]
GAP = 1e-4                  # [m]
GRAVITY = 9.81
STIFFER = 1 + 2*(SIDE**2/(4*SIDE*HEIGHT))**2

# The mass of a uniformly stretched spring counts a third at its end
MASS = BOX + FEET_MASS/3
FIRST_CONTACT = GAP/SPEED


def stress(stretch):
    """Force over undeformed area [Pa] of a neo-Hookean body with free sides,
    at a given ratio of its length to its undeformed length. Positive in
    tension."""
    mu, kappa = E/(2*(1 + NU)), E/(3*(1 - 2*NU))

    def along(i, lengths):
        J = np.prod(lengths)
        return (mu*J**(-2/3)*(lengths[i] - lengths @ lengths/(3*lengths[i]))
                + kappa*(J - 1)*J/lengths[i])

    # The sides are free: their force is a falling function of the width
    least, most = 0.5, 2.0
    while most - least > 1e-12:
        width = (least + most)/2
        if along(1, np.array((stretch, width, width))) > 0:
            most = width
        else:
            least = width
    return along(0, np.array((stretch, width, width)))


def force(shorter):
    """Force of all feet [N] at a given shortening [m]; positive in
    compression."""
    if shorter <= 0:
        return 0.0
    return -STIFFER*FEET*SIDE**2*stress(1 - shorter/HEIGHT)


@dataclass
class Drop:
    """Times since the first contact [s], forces of the floor [N], and the
    velocity at the end [m/s], upwards."""

    times: np.ndarray
    forces: np.ndarray
    away: float

    @property
    def duration(self):
        return self.times[-1]


def drop(dt=2e-6):
    """Integrate until the feet have their initial length again."""
    x, v, t = 0.0, SPEED, 0.0
    times, forces = [0.0], [0.0]
    while x > 0 or t == 0:
        F = forces[-1]
        v += dt*(GRAVITY - F/MASS)
        x += dt*v
        t += dt
        times.append(t)
        forces.append(force(x))
    return Drop(np.array(times), np.array(forces), -v)
