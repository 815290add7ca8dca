"""Two concentric hollow half spheres that are pressed together between rigid
planes, against published forces (compressedSpheres.csv).

Radii 10, 12 and 14 mm; a quarter of them is meshed, and forces are those of
the quarter. The planes have no friction, the spheres have it or not. The top
comes 10 mm down; published forces are those of equilibrium."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

import readResults
from caseTools import DEFAULT
from smallCases import Body, SmallCase, condition, coulomb

FILE = Path(__file__).with_suffix(".csv")
HEIGHT = 14e-3
WAY = 10e-3
DURATION = 0.1
MATERIAL = {"type": "neoHookean", "rho": 1000, "E": 1e6, "nu": 0.3}

# Faces of the surface of a cube, as corners 0 or 1 of the other two directions
PATCHES = {"sideX": "symmetryPlane", "sideY": "symmetryPlane",
           "bottom": "contact", "inside": "contact", "outside": "contact"}


@dataclass
class Shell(Body):
    """An eighth of a hollow sphere, of three blocks: that of a hollow cube,
    moved outwards along rays. Cells: along an edge of a block, and through
    the thickness; size: its two radii."""

    def mesh(self):
        corners = [c for c in np.ndindex(2, 2, 2) if any(c)]
        number = {(c, r): i for i, (r, c) in enumerate(
            (r, c) for r in range(2) for c in corners)}
        n, across = self.cells
        blocks, faces = [], {patch: [] for patch in PATCHES}
        for axis in range(3):
            a, b = (axis + 1) % 3, (axis + 2) % 3

            def at(i, j, r):
                c = [0, 0, 0]
                c[axis], c[a], c[b] = 1, i, j
                return number[tuple(c), r]

            square = (0, 0), (1, 0), (1, 1), (0, 1)
            layers = [tuple(at(*c, r) for c in square) for r in (0, 1)]
            blocks += ["hex", layers[0] + layers[1], (n, n, across),
                       "simpleGrading (1 1 1)"]
            faces["inside"].append(layers[0])
            faces["outside"].append(layers[1])
            for direction, ends in (a, (at(0, 0, 0), at(0, 1, 0), at(0, 1, 1),
                                        at(0, 0, 1))), \
                    (b, (at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1))):
                faces[list(PATCHES)[direction]].append(ends)
        boundary = []
        for patch, sides in faces.items():
            kind = self.condition(patch)["type"]
            kind = kind if kind == "symmetryPlane" else "patch"
            boundary += [patch, {"type": kind, "faces": tuple(sides)}]
        return {"vertices": [r*np.array(c) for r in self.size
                             for c in corners],
                "blocks": blocks, "boundary": boundary}

    @property
    def dimensions(self):
        return 3

    @property
    def patches(self):
        return tuple(PATCHES)

    def condition(self, side):
        return condition(PATCHES[side])


def toSphere(X):
    """Of a cube, with equal angles between the lines of its mesh."""
    r = np.abs(X).max(axis=1, keepdims=True)
    ray = np.tan(np.pi/4*X/r)
    return r*ray/np.linalg.norm(ray, axis=1, keepdims=True)


def shell(name, radii, n, across):
    return Shell((n, across), name=name, size=radii, moved=toSphere,
                 material=dict(MATERIAL))


def plane(body, side, z, normal, **more):
    return {"side": (body, side), "obstacle": {
        "type": "plane", "planeType": "pointAndNormal", "pointAndNormalDict":
        {"point": (0, 0, z), "normal": (0, 0, normal)}}, **more}


def write(folder, friction, duration=DURATION, n=12, across=4):
    """The case, not yet run: cells over an edge of a block of the inner
    sphere, and through the thickness of each."""
    law = coulomb(friction) if friction else {"type": "frictionless"}
    down = {"solidBodyMotionFunction": "linearMotion", "linearMotionCoeffs":
            {"velocity": (0, 0, -WAY/duration)}}
    return SmallCase(
        folder,
        [shell("inner", (10e-3, 12e-3), n, across),
         shell("outer", (12e-3, 14e-3), round(7*n/6), across)],
        duration,
        {"between": {"sides": (("inner", "outside"), ("outer", "inside")),
                     "pairing": "nearestFace", "law": law},
         "floor": plane('".*"', '"(bottom|inside)"', 0, 1),
         "roof": plane("outer", "outside", HEIGHT, -1, motion=down)},
        preset=DEFAULT, functions=("contactForces",),
        control={"writeInterval": duration/10, "maxCo": 0.9})


def forces(case, duration=DURATION):
    """Ways of the roof [mm], and forces on it [N], of a run."""
    contact = readResults.table(case.path, "contactForces", "roof.dat")
    return 1e3*WAY*contact["Time"]/duration, np.abs(
        contact["outer.outside:Fz"])
