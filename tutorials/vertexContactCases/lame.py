"""Two elastic rings in plane strain, one pressed onto the other (G. Lame and
B. Clapeyron, Mem. div. sav. 4 (1833) 465-562; any book on the theory of
elasticity)."""

import numpy as np

A, B, C = 0.012, 0.020, 0.030       # bore, fit, outside [m]
INTERFERENCE = 20e-6                # of the radii [m]
SHAFT = 210e9, 0.3                  # Young's modulus [Pa], Poisson's ratio
HUB = 70e9, 0.33


def planeStrain(E, nu):
    """Constants with which the formulas of plane stress give plane strain."""
    return E/(1 - nu**2), nu/(1 - nu)


def compliances():
    """Growth of the radius of the hub and shrinkage of that of the shaft, per
    pressure [m/Pa]."""
    E, nu = planeStrain(*HUB)
    hub = B/E*((C**2 + B**2)/(C**2 - B**2) + nu)
    E, nu = planeStrain(*SHAFT)
    return hub, B/E*((B**2 + A**2)/(B**2 - A**2) - nu)


PRESSURE = INTERFERENCE/sum(compliances())      # between them [Pa]
BORE_GROWTH = PRESSURE*compliances()[0]         # of the hub [m]


def stresses(r):
    """Radial and hoop stress at radii [Pa]; at the fit, those of the hub."""
    r = np.asarray(r, dtype=float)
    hub = PRESSURE*B**2/(C**2 - B**2)
    shaft = -PRESSURE*B**2/(B**2 - A**2)
    mean = np.where(r < B, shaft, hub)
    part = np.where(r < B, shaft*A**2, hub*C**2)/r**2
    return mean - part, mean + part
