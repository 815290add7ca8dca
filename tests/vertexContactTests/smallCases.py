"""Write small cases from Python and run them: block-shaped bodies with any
boundary conditions and initial fields."""

from dataclasses import dataclass, field
from typing import Callable

import numpy as np

from vertexContactTests.caseTools import (PRESET, Case, checked, execute,
                                          solver, timeFolders)

# Sides of a block: direction, corners
SIDES = {"left": (0, "0 4 7 3"), "right": (0, "1 2 6 5"),
         "bottom": (1, "0 1 5 4"), "top": (1, "3 7 6 2"),
         "back": (2, "0 3 2 1"), "front": (2, "4 5 6 7")}

# c_p = 1
ELASTIC = {"type": "linearElastic", "rho": 1, "E": 1, "nu": 0}
RUBBER = {"type": "neoHookean", "rho": 1, "E": 1, "nu": 0.3}

# Tests look at each step
EACH_STEP = {"writeControl": "timeStep", "writeInterval": 1}

SCHEMES = "ddt", "grad", "div", "laplacian", "interpolation", "snGrad"


def text(value):
    """A value as OpenFOAM's dictionaries have it."""
    if isinstance(value, dict):
        return f"\n{{\n{entries(value)}}}\n"
    if isinstance(value, (list, tuple, np.ndarray)):
        return "(" + " ".join(text(v) for v in value) + ")"
    if isinstance(value, (float, np.floating)):
        return f"{value:.17g}"
    return str(value)


def entries(dictionary):
    return "".join(f"{key} {text(value)}" if isinstance(value, dict) else
                   f"{key} {text(value)};\n"
                   for key, value in dictionary.items())


def condition(name, **values):
    """A boundary condition of pointU, as a dictionary."""
    return {"type": name, **values}


def table(*rows):
    """A Function1 from (time, value) rows."""
    return "table " + text(rows)


def interface(minus, plus, law="frictionless", **more):
    """The interface of two sides (region, patch)."""
    law = law if isinstance(law, dict) else {"type": law}
    return {"sides": (minus, plus), "pairing": "matching", "law": law, **more}


# An obstacle
FLOOR = {"type": "plane", "planeType": "pointAndNormal",
         "pointAndNormalDict": {"point": (0, 0, 0), "normal": (0, 1, 0)}}


def smooth(s):
    """A smooth rise from 0 to 1 between 0 and 1."""
    return s**3*(10 - 15*s + 6*s**2)


def slowly(time, *values):
    """Accelerations that change smoothly from one to the next within a time.
    Otherwise vibrations, which have no dissipation, reduce the pressure now
    and then and cause slip."""
    s = np.linspace(0, 1, 201)[1:]
    part = smooth(s)[:, None]
    rows = [(0, tuple(values[0]))]
    for i, (a, b) in enumerate(zip(values, values[1:])):
        rows += zip(time*(i + s), map(tuple, (1 - part)*a + part*b))
    return {"slope": {"type": "uniform", "acceleration": table(*rows)}}


def coulomb(coefficient):
    return {"type": "Coulomb", "frictionCoeff": coefficient}


def friction(coefficient):
    """Coulomb's law, or none."""
    return coulomb(coefficient) if coefficient else "frictionless"


def polar(X):
    """Points whose x is a radius and whose y is an angle."""
    r, angle = X[:, 0], X[:, 1]
    return np.stack((r*np.cos(angle), r*np.sin(angle), X[:, 2]), axis=1)


def turned(r, axis, angle):
    """Points rotated about the origin."""
    axis = np.array(axis)/np.linalg.norm(axis)
    c, s = np.cos(angle), np.sin(angle)
    return c*r + s*np.cross(axis, r) + (1 - c)*np.outer(r @ axis, axis)


@dataclass
class Body:
    """A block and its conditions. The number of cell counts is its dimension.
    Directions that are left out are one metre wide, so that energies and
    momenta are per square metre or per metre. Sides: left right bottom top
    back front."""

    cells: tuple
    name: str = "body"
    start: tuple = (0, 0, 0)
    size: tuple = (1, 1, 1)
    sides: dict = field(default_factory=dict)   # default tractionFree
    material: dict = field(default_factory=lambda: dict(RUBBER))
    scheme: dict = field(default_factory=dict)
    velocity: Callable | tuple = (0, 0, 0)      # of reference points
    displacement: Callable | None = None
    deformation: Callable | None = None         # F; else that of displacement
    forces: dict = field(default_factory=dict)  # of bodyForces, by name
    moved: Callable | None = None               # of the points of the block
    edges: tuple = ()                           # entries of blockMesh

    @property
    def dimensions(self):
        return len(self.cells)

    def mesh(self):
        corners = np.array(((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)))
        corners = np.vstack((corners, corners + (0, 0, 1)))
        points = np.array(self.start) + corners*np.array(self.size)
        cells = (*self.cells, 1, 1)[:3]
        return {"vertices": points, "edges": self.edges,
                "blocks": ("hex", tuple(range(8)), cells,
                           "simpleGrading (1 1 1)"),
                "boundary": self.boundary({
                    side: f"(({face}))" for side, (_, face) in SIDES.items()})}

    def boundary(self, faces):
        """The boundary of blockMesh, from the faces of each side."""
        entries = []
        for side, those in faces.items():
            kind = self.condition(side)["type"]
            kind = kind if kind in ("empty", "symmetryPlane") else "patch"
            entries += [side, {"type": kind, "faces": those}]
        return entries

    def makeMesh(self, case):
        case.dictionary(f"system/{self.name}/blockMeshDict", self.mesh())
        checked(["blockMesh", "-region", self.name], case.path)

    @property
    def patches(self):
        return tuple(SIDES)

    def condition(self, side):
        if SIDES[side][0] >= self.dimensions:
            return condition("empty")
        given = self.sides.get(side, "tractionFree")
        return given if isinstance(given, dict) else condition(given)


@dataclass
class GmshBody(Body):
    """A body of tetrahedra. Its sides are the physical surfaces of a geometry
    that gmsh reads."""

    cells: tuple = ()
    geometry: str = ""

    @property
    def dimensions(self):
        return 3

    @property
    def patches(self):
        return tuple(self.sides)

    def condition(self, side):
        given = self.sides[side]
        return given if isinstance(given, dict) else condition(given)

    def makeMesh(self, case):
        (case/f"{self.name}.geo").write_text(self.geometry)
        checked(["gmsh", "-3", "-format", "msh2", "-nt", "1", "-o",
                 f"{self.name}.msh", f"{self.name}.geo"], case.path)
        checked(["gmshToFoam", "-region", self.name, f"{self.name}.msh"],
                case.path)
        for side in self.patches:
            if self.condition(side)["type"] == "symmetryPlane":
                case.replace(
                    f"constant/{self.name}/polyMesh/boundary",
                    rf"(\b{side}\s*{{\s*type\s+)patch;"
                    r"(\s*physicalType\s+\w+;)?", r"\1symmetryPlane;")


def distorted(amplitude, size=(1, 1, 1), dimensions=3, start=(0, 0, 0)):
    """A map of the points of a block that distorts its inside and keeps its
    sides flat, in the same way on opposite sides. The amplitude is below 1,
    where the block would fold."""
    def move(X):
        s = (X - np.array(start))/np.array(size)
        out = X.copy()
        for i in range(dimensions):
            shift = np.sin(np.pi*s[:, i])
            for j in range(dimensions):
                if j != i:
                    shift = shift*np.cos(2*np.pi*s[:, j] + i + 1)
            out[:, i] += amplitude*size[i]/np.pi*shift
        return out
    return move


class OnePatch(Body):
    """A block whose sides are one patch, as in most meshes."""

    @property
    def patches(self):
        return ("outer", *list(SIDES)[2*self.dimensions:])

    def condition(self, side):
        return condition("contact") if side == "outer" \
            else super().condition(side)

    def mesh(self):
        outer = " ".join(f"({face})" for direction, face in SIDES.values()
                         if direction < self.dimensions)
        faces = {side: f"(({SIDES[side][1]}))" for side in self.patches[1:]}
        return {**super().mesh(), "boundary": self.boundary(
            {"outer": f"({outer})", **faces})}


class SmallCase(Case):
    """A case folder made of bodies and interfaces."""

    def __init__(self, path, bodies, endTime, interfaces=None, gravity=None,
                 control=None, functions=(), probes=None, preset=PRESET):
        super().__init__(path)
        self.bodies = [bodies] if isinstance(bodies, Body) else list(bodies)
        functions = {name: {"type": name, "libs": "(vertexContact)", **EACH_STEP}
                     for name in ("solidEnergies", *functions)}
        for name, (region, point) in (probes or {}).items():
            functions[name] = {
                "type": "pointProbes", "libs": "(vertexContact)", **EACH_STEP,
                "region": region, "points": (point,),
                "fields": "(pointU pointD sigma pressure)"}
        self.dictionary("system/controlDict", {
            "application": "vertexContactFoam", "libs": "(vertexContact)",
            "startFrom": "latestTime", "startTime": 0, "stopAt": "endTime",
            "endTime": endTime, "deltaT": endTime, "adjustTimeStep": "yes",
            "preset": preset, "maxCo": 0.3,
            "writeControl": "adjustableRunTime", "writeInterval": endTime,
            "writeFormat": "binary",
            "writePrecision": 16, "timePrecision": 10, "logInterval": 1000,
            "functions": functions, **(control or {})})
        names = tuple(body.name for body in self.bodies)
        self.dictionary("constant/regionProperties",
                        {"regions": ("solid", names)})
        if interfaces:
            self.dictionary("constant/contactProperties",
                            {"interfaces": interfaces})
        if gravity is not None:
            self.write("constant/g", "uniformDimensionedVectorField", entries({
                "dimensions": "[0 1 -2 0 0 0 0]", "value": gravity}))
        for body in self.bodies:
            self.writeBody(body)

    def write(self, file, kind, contents):
        file = self.path/file
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(
            f"FoamFile\n{{\nversion 2.0;\nformat ascii;\nclass {kind};\n"
            f"object {file.name};\n}}\n{contents}\n")

    def dictionary(self, file, contents):
        self.write(file, "dictionary", entries(contents))

    def writeBody(self, body):
        name = body.name
        self.dictionary(f"system/{name}/fvSchemes", {
            "vertexCentred": body.scheme,
            **{f"{kind}Schemes": {} for kind in SCHEMES}})
        self.dictionary(f"system/{name}/fvSolution", {})
        self.dictionary(f"constant/{name}/mechanicalProperties", body.material)
        if body.forces:
            self.dictionary(f"constant/{name}/bodyForces", body.forces)
        body.makeMesh(self)
        if body.moved:
            X = body.moved(self.points(name))
            self.write(f"constant/{name}/polyMesh/points", "vectorField",
                       listed(X))

        X = self.points(name)
        self.writePointField(body, "pointU", "[0 1 -1 0 0 0 0]",
                             values(body.velocity, X))
        if body.displacement is not None:
            self.writePointField(body, "pointD", "[0 1 0 0 0 0 0]",
                                 values(body.displacement, X))
        if body.deformation is not None:
            self.writePointField(body, "F", "[0 0 0 0 0 0 0]",
                                 body.deformation(X).reshape(-1, 9), "tensor")

    def writePointField(self, body, name, dimensions, U, kind="vector"):
        patches = {}
        for side in body.patches:
            patch = body.condition(side)
            if name != "pointU" and patch["type"] not in (
                    "empty", "symmetryPlane", "slip"):
                patch = condition("calculated")
            patches[side] = patch
        self.write(
            f"0/{body.name}/{name}", f"point{kind[0].upper()}{kind[1:]}Field",
            f"dimensions {dimensions};\ninternalField nonuniform "
            f"List<{kind}>\n{listed(U)};\nboundaryField{text(patches)}")

    def run(self):
        """Run in serial; any failure is an error."""
        checked(solver(), self.path)
        return self

    def attempt(self, ranks=1):
        """Run whatever happens; returns exit code and output."""
        if ranks > 1:
            self.decompose(ranks)
        done = execute(solver(ranks), self.path)
        return done.returncode, done.stdout

    @property
    def last(self):
        """Name of the last time written."""
        return timeFolders(self.path)[-1]

    def at(self, name, time=None, region=None):
        """Values of a point field. Default: at the last time, and of the first
        body."""
        return self.field(time or self.last, region or self.bodies[0].name,
                          name)

    def X(self, region=None):
        return self.points(region or self.bodies[0].name)


def largest(values):
    """Largest magnitude."""
    return float(np.max(np.abs(values)))


def values(function, X):
    U = function(X) if callable(function) else function
    return np.broadcast_to(np.asarray(U, dtype=float), X.shape)


def listed(X):
    """Rows of vectors, tensors or single numbers, as a list for OpenFOAM."""
    rows = (" ".join(f"{x:.17g}" for x in row) for row in X)
    rows = "\n".join(rows if len(X[0]) == 1 else (f"({row})" for row in rows))
    return f"{len(X)}\n(\n{rows}\n)\n"
