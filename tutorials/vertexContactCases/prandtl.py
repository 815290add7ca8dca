"""The limit load of a block of non-hardening metal under a flat stamp, in
plane strain: the pressure (2 + pi) k, with k the yield stress in shear (L.
Prandtl, Nachr. Ges. Wiss. Goettingen (1920) 74-85)."""

import numpy as np

WIDTH = 0.004           # of the stamp [m]
YIELD = 200e6           # tensile [Pa]
MASS = 8                # of the ram [kg/m]
LIMIT = WIDTH*(2 + np.pi)*YIELD/np.sqrt(3)      # [N/m]

# The force on the stamp
TIMES = 0, 100e-6, 150e-6, 200e-6
FORCES = 0, 3.09e6, 3.09e6, 0


def force(time):
    """Force on the stamp, downwards [N/m]."""
    return np.interp(time, TIMES, FORCES)
