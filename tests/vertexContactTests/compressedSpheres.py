"""Two concentric hollow half spheres that are pressed together between rigid
planes, against published forces (compressedSpheres.csv).

Radii 10, 12 and 14 mm; a quarter of them is meshed, and forces are those of
the quarter. Their edges slide on the plane of symmetry below, and the
inner one meets a floor there; the roof comes 10 mm down. Only the spheres have
friction, or not. Published forces are those of equilibrium. Run, it makes
compressedSpheres.png."""

import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from vertexContactCases import drawHistories, readResults
from vertexContactCases.drawHistories import plt
from vertexContactTests.caseTools import DEFAULT, meansAround, root
from vertexContactTests.smallCases import (Body, SmallCase, condition,
                                           friction, interface)

FOLDER = root/"tests"/"verification"/"publishedContact"
FILE = FOLDER/"compressedSpheres.csv"
HEIGHT = 14e-3
WAY = 10e-3
DURATION = 0.05
FRICTION = "0", "0.5"
SOURCES = {"0": ("Abaqus", "Areias", "FEBio", "PusoLaursen"),
           "0.5": ("Abaqus", "Areias", "FEBio")}
MATERIAL = {"type": "neoHookean", "rho": 1000, "E": 1e6, "nu": 0.3}

# The first three corners lie in the planes of the axes
PATCHES = {"sideX": "symmetryPlane", "sideY": "symmetryPlane",
           "bottom": "symmetryPlane", "inside": "contact", "outside": "contact"}


@dataclass
class Shell(Body):
    """An eighth of a hollow sphere, of three blocks: a hollow cube that is
    moved outwards along rays. Cells: along an edge of a block, and through the
    thickness; size: its two radii."""

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
            for direction, (i, j) in (a, (0, 1)), (b, (1, 0)):
                faces[list(PATCHES)[direction]].append(
                    (at(0, 0, 0), at(i, j, 0), at(i, j, 1), at(0, 0, 1)))
        return {"vertices": [r*np.array(c) for r in self.size
                             for c in corners],
                "blocks": blocks, "boundary": self.boundary(faces)}

    @property
    def dimensions(self):
        return 3

    @property
    def patches(self):
        return tuple(PATCHES)

    def condition(self, side):
        return condition(PATCHES[side])


def toSphere(X):
    """Points of a sphere from those of a cube, with equal angles between mesh
    lines."""
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


def write(folder, k, duration=DURATION, n=6, across=2):
    """The case, not run yet. n: cells over an edge of a block of the inner
    sphere; across: cells through the thickness of each sphere."""
    down = {"solidBodyMotionFunction": "linearMotion", "linearMotionCoeffs":
            {"velocity": (0, 0, -WAY/duration)}}
    return SmallCase(
        folder,
        [shell("inner", (10e-3, 12e-3), n, across),
         shell("outer", (12e-3, 14e-3), round(7*n/6), across)],
        duration,
        {"between": interface(("inner", "outside"), ("outer", "inside"),
                              friction(float(k)), pairing="nearestFace"),
         "floor": plane("inner", "inside", 0, 1),
         "roof": plane("outer", "outside", HEIGHT, -1, motion=down)},
        preset=DEFAULT, functions=("contactForces",),
        control={"writeInterval": duration/10, "maxCo": 0.9})


def theirs():
    """The published table, with columns displacement and k:source; nan after
    the end of a curve."""
    return readResults.csv(FILE)


def history(case, duration=DURATION):
    """Displacements of the roof [mm], and forces on it [N], from a run."""
    contact = readResults.table(case.path, "contactForces", "roof.dat")
    return 1e3*WAY*contact["Time"]/duration, np.abs(
        contact["outer.outside:Fz"])


def forces(case, duration=DURATION, way=0.1):
    """Displacements of theirs(), and means of the force over this distance in
    mm before and after them."""
    places = theirs()["displacement"]
    return places, meansAround(*history(case, duration), places, way)


def plot(file, cases, duration):
    """Plot the forces of {k: case} over the published ones."""
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.5), sharey=True,
                                layout="constrained")
    data = theirs()
    for ax, (k, case) in zip(axes, cases.items()):
        for source, marker in zip(SOURCES[k], "o^sD"):
            ax.plot(data["displacement"], data[f"{k}:{source}"], marker,
                    color="0.5", markerfacecolor="none", markersize=5,
                    label=source)
        x, F = history(case, duration)
        ax.plot(x, F, color="C0", linewidth=1, label="vertexContact")
        ax.set(xlabel="displacement of the top [mm]", title=f"k = {k}",
               xlim=(0, 9.7), ylim=(0, 7))
        ax.grid(color="0.9")
    axes[0].set_ylabel("force on a quarter [N]")
    axes[0].legend()
    figure.savefig(file, dpi=drawHistories.DPI)
    plt.close(figure)


if __name__ == "__main__":
    SLOW = 0.1
    with tempfile.TemporaryDirectory() as folder:
        plot(FILE.with_suffix(".png"), {
            k: write(Path(folder)/k, k, SLOW, 8, 3).run()
            for k in FRICTION}, SLOW)
