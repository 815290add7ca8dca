"""Small collisions with every kind of contact and material, in three
dimensions, for tests of restart and decomposition."""

from vertexContactTests.caseTools import PRESET
from vertexContactTests.smallCases import (RUBBER, Body, SmallCase, coulomb,
                                           interface)

COPPER = {"type": "HenckyVonMises", "rho": 1, "E": 1, "nu": 0.35,
          "tauY": 0.01, "Hardening": 0.05}
INTERVALS = 4
END = 1.2


def blocks(pairing, cells, law="frictionless", material=RUBBER):
    """Two blocks slide along each other as they collide. One is shifted, if
    the meshes need not match."""
    shift = 0 if pairing == "matching" else 0.3
    below = Body(cells=(4, 4, 4), name="below", material=material,
                 velocity=(0.02, 0.05, 0), sides={"top": "contact"})
    above = Body(cells=cells, name="above", start=(shift, 1.01, shift/2),
                 material=material, velocity=(-0.02, -0.05, 0),
                 sides={"bottom": "contact"})
    return (below, above), {"contact": interface(
        ("below", "top"), ("above", "bottom"), law, pairing=pairing)}


def onSphere(material=RUBBER, **motion):
    """A block falls on a rigid sphere."""
    block = Body(cells=(5, 5, 5), name="block", start=(0, 0.01, 0),
                 material=material, velocity=(0, -0.1, 0),
                 sides={"bottom": "contact"})
    return (block,), {"contact": {
        "side": ("block", "bottom"), "law": coulomb(0.3),
        "obstacle": {"type": "sphere", "origin": (0.4, -1, 0.5), "radius": 1},
        **motion}}


RISING = {"motion": {"solidBodyMotionFunction": "linearMotion",
                     "linearMotionCoeffs": {"velocity": (0, 0.05, 0)}}}
SCENES = {
    "elastic, matching": lambda: blocks("matching", (4, 4, 4)),
    "friction, AMI": lambda: blocks("AMI", (5, 5, 5), coulomb(0.3)),
    "friction, nearestFace": lambda: blocks("nearestFace", (5, 5, 5),
                                            coulomb(0.3)),
    "plastic, nearestFace": lambda: blocks("nearestFace", (5, 5, 5),
                                           material=COPPER),
    "plastic, sphere": lambda: onSphere(COPPER),
    "elastic, rising sphere": lambda: onSphere(**RISING),
}


def collision(folder, name, endTime=END, preset=PRESET):
    """The case of a scene with INTERVALS written times; not run yet."""
    bodies, interfaces = SCENES[name]()
    return SmallCase(folder, bodies, endTime, interfaces=interfaces,
                     functions=("contactForces",), preset=preset,
                     control={"writeInterval": endTime/INTERVALS})
