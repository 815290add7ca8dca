"""Shallow ironing: forces of a run, and those of five published solutions.

Displacements are those of the top of the block, in mm; forces are in N per mm
of width, on the foundation: H along, V downwards.
"""

from pathlib import Path

import numpy as np

from vertexContactCases import readResults

FILE = (Path(__file__).resolve().parents[1]/"shallowIroning"/"referenceData"
        / "published.csv")
SOURCES = {"Yastrebov": "Yastrebov 2011", "CodeAster": "Code_Aster",
           "FischerWriggers": "Fischer, Wriggers 2006",
           "HartmannOliver": "Hartmann, Oliver et al. 2009",
           "PouliosRenard": "Poulios, Renard 2015"}

# Ratio of the horizontal to the vertical force half of the way along (5 mm),
# as the authors print it; two more authors have no curves here
RATIOS = {"PouliosRenard": 0.30, "Batistic": 0.32, "Houssein": 0.32,
          "CodeAster": 0.34, "HartmannOliver": 0.38, "Yastrebov": 0.47,
          "FischerWriggers": 0.53}


def sources():
    """The published table, with columns down, along, and Source:H,
    Source:V."""
    return readResults.csv(FILE)


def forces(case):
    """The same from a run: down, along, H, V."""
    contact = readResults.table(case, "contactForces", "ironing.dat")
    times, D = readResults.probe(case, "top", "pointD")
    along, up = (np.interp(contact["Time"], times, D[:, i])/1e-3
                 for i in (0, 1))
    Fx, Fy = (contact[f"foundation.surface:F{c}"]/1e3 for c in "xy")
    return -up, along, Fx, -Fy


def at(run, down, along, within=0.02):
    """Means of H and V over a range of displacements in the result of
    forces()."""
    d, a, H, V = run
    near = (np.abs(d - down) < within) & (np.abs(a - along) < within)
    return H[near].mean(), V[near].mean()
