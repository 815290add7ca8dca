"""Copy tutorials, change them, run them, and read their results."""

import fcntl
import hashlib
import os
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from foamlib import FoamFile

from vertexContactCases import readResults

root = Path(__file__).resolve().parents[2]
timeLimit = 1200    # time limit of a program, in seconds

# The preset that users get, and the preset of test cases that choose none:
# their asserted figures are those of the paper's scheme
DEFAULT = "balanced"
PRESET = "paper"


def execute(command, folder, **environment):
    """Run a program; never raises for its exit code. .stdout has standard
    output and error together."""
    return subprocess.run(
        command, cwd=folder,
        env={**os.environ, "PWD": str(folder), **environment},
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True, errors="replace",
        timeout=timeLimit)


def checked(command, folder, **environment):
    """The same, but an exit code other than 0 is an error."""
    done = execute(command, folder, **environment)
    if done.returncode != 0:
        raise RuntimeError(f"{command} in {folder}: exit code "
                           f"{done.returncode}\n{done.stdout[-3000:]}")
    return done.stdout


def solver(ranks=1):
    """The command that runs a case, which is decomposed if ranks > 1."""
    program = ["vertexContactFoam"]
    return program if ranks == 1 else [
        "mpirun", "-np", str(ranks), *program, "-parallel"]


def rankFolders(ranks=1):
    """Folders of a case that contain its times."""
    return ["."] if ranks == 1 else [f"processor{i}" for i in range(ranks)]


def copyTutorials(destination):
    """A clean copy of tutorials/, without results."""
    made = shutil.ignore_patterns(
        "0", "[1-9]*", "0.[0-9]*", "processor[0-9]*", "postProcessing",
        "polyMesh", "log.*", "*.msh", "*.png", "*.foam", "caseParameters",
        "presetParameters", "__pycache__", "results")
    return Path(shutil.copytree(root/"tutorials", destination, ignore=made))


TUTORIALS = sorted(
    str(file.parent.relative_to(root/"tutorials"))
    for file in (root/"tutorials").rglob("*/Allrun"))


def coarse(tutorial):
    """Options of Allrun for a coarse mesh."""
    name = tutorial.split("/")[0]
    return {"MESH": {"twoBarImpact": "32", "spinningCube": "2",
                     "twistingColumn": "2", "nonMatchingBars": "1",
                     "torusImpact": "2", "hertzContact": "2",
                     "taylorBar": "2", "newtonsCradle": "1",
                     "hundredDiscs": "2", "dropTest": "2"}.get(name, "4")}


def timeFolders(folder):
    """Names of the time folders, sorted by time."""
    names = [entry.name for entry in Path(folder).iterdir()
             if re.fullmatch(r"[0-9.]+(e[-+]?[0-9]+)?", entry.name)]
    return sorted(names, key=float)


def contents(folder):
    """Contents of all files in a folder, as bytes."""
    return {file.relative_to(folder): file.read_bytes()
            for file in Path(folder).rglob("*") if file.is_file()}


def differingFiles(expected, found):
    """Names of files that differ in pairs of contents(), one pair per rank.
    With several ranks, sums over the ranks are not compared if the straight
    run keeps one per rank: the restarted run continues from the total, which
    is equal to round-off."""
    names = {str(file) for a, b in zip(expected, found)
             for file in a.keys() | b.keys() if a.get(file) != b.get(file)}
    return sorted(names - ({"uniform/solidSystem"} if len(found) > 1 else set()))


class Case:
    """A case folder with its results."""

    def __init__(self, path):
        self.path = Path(path)

    def __truediv__(self, name):
        return self.path/name

    def set(self, file, entries):
        """Change entries of a dictionary, or remove them if the value is None.
        Keys of sub-dictionaries have slashes, as in 'vertexCentred/cells'."""
        dictionary = FoamFile(self.path/file)
        with dictionary:
            for key, value in entries.items():
                place = tuple(key.split("/"))
                if value is None:
                    del dictionary[place]
                else:
                    dictionary[place] = value

    def replace(self, file, pattern, by):
        """Replace a regular expression, which must match."""
        text = (self.path/file).read_text()
        text, count = re.subn(pattern, by, text)
        if count == 0:
            raise ValueError(f"no '{pattern}' in {self.path/file}")
        (self.path/file).write_text(text)

    def log(self, program="vertexContactFoam"):
        return (self.path/f"log.{program}").read_text(errors="replace")

    @property
    def regions(self):
        start = self.path/"0.orig"
        return sorted(entry.name for entry in
                      (start if start.exists() else self.path/"0").iterdir()
                      if entry.is_dir())

    @property
    def times(self):
        """Names of the written times, without the initial time."""
        return timeFolders(self.path)[1:]

    @cached_property
    def energies(self):
        return readResults.table(self.path, "solidEnergies", "energies.dat")

    @cached_property
    def momentum(self):
        return readResults.table(self.path, "solidEnergies", "momentum.dat")

    def momentumOf(self, owner="total"):
        """Linear momentum of a region, or of all, with a row per time."""
        return np.array([self.momentum[f"{owner}:p{c}"] for c in "xyz"]).T

    def angularMomentumOf(self, owner="total"):
        """Angular momentum about the origin, in the same way."""
        return np.array([self.momentum[f"{owner}:L{c}"] for c in "xyz"]).T

    def contact(self, interface="bars"):
        return readResults.table(
            self.path, "contactForces", f"{interface}.dat")

    def probe(self, functionObject, field):
        return readResults.probe(self.path, functionObject, field)

    @property
    def totalEnergy(self):
        return self.energies["total:kinetic"] + self.energies["total:strain"]

    @property
    def keptEnergy(self):
        """Total energy minus the part that oscillates with the step."""
        return self.totalEnergy - self.energies["total:swing"]

    @property
    def ownEnergy(self):
        """Kept energy minus the works of loads and of contact: only
        dissipation within the bodies changes it."""
        return (self.keptEnergy - self.energies["total:externalWork"]
                - self.energies["total:contactWork"])

    def field(self, time, region, name):
        """Values of a point field, with a row per point."""
        file = FoamFile(self.path/time/region/name)
        nPoints = len(self.points(region))
        values = np.asarray(file["internalField"], dtype=float)
        if values.ndim == 0 or len(values) != nPoints:
            values = np.broadcast_to(values, (nPoints, *values.shape))
        return values.reshape(nPoints, -1)

    def decompose(self, ranks, method="metis"):
        for region in ("", *self.regions):
            (self.path/"system"/region/"decomposeParDict").write_text(
                "FoamFile { version 2.0; format ascii; class dictionary; "
                "object decomposeParDict; }\n"
                f"numberOfSubdomains {ranks}; method {method};\n"
                f'{method}Coeffs {{ dataFile "cellDecomposition"; }}\n')
        checked(["decomposePar", "-allRegions"], self.path)

    def runParallel(self, ranks, method="metis"):
        """Decompose, run, and reconstruct the case."""
        self.decompose(ranks, method)
        checked(solver(ranks), self.path)
        checked(["reconstructPar", "-allRegions", "-newTimes"], self.path)
        return self

    def points(self, region):
        file = self.path/"constant"/region/"polyMesh"/"points"
        return np.asarray(FoamFile(file)[None], dtype=float).reshape(-1, 3)


@dataclass(frozen=True)
class Scene:
    """A two-bar run: a tutorial and its changes."""

    tutorial: str = "similar"
    elements: int = 1024
    dimensions: int = 1
    across: int = 1             # elements over the width (and height)
    scheme: tuple = ()          # ((keyword, value), ...) of vertexCentred
    control: tuple = ()         # ((keyword, value), ...) of controlDict
    ranks: int = 1
    preset: str = PRESET

    def prepare(self, folder):
        """The case folder before the run, with the preset of its
        controlDict."""
        tutorials = copyTutorials(folder/"tutorials")
        case = Case(tutorials/"twoBarImpact"/self.tutorial)
        for bar in "bar1", "bar2":
            case.set(f"system/{bar}/fvSchemes", {
                f"vertexCentred/{k}": v for k, v in self.scheme})
        case.set("system/controlDict", dict(self.control))

        size = self.across*10/self.elements
        block = {}
        if self.dimensions > 1:
            block |= {"nWidth": self.across, "width": size,
                      "widthSides": "symmetryPlane"}
        if self.dimensions > 2:
            block |= {"nHeight": self.across, "height": size,
                      "heightSides": "symmetryPlane"}
        for key, value in block.items():
            case.replace("system/barBlock", rf"(?m)^{key}( +)\S+;",
                         rf"{key}\g<1>{value};")
        for sides, dimension in (r"bottom\|top", 2), (r"front\|back", 3):
            if self.dimensions >= dimension:
                for bar in "bar1", "bar2":
                    case.replace(f"0.orig/{bar}/pointU",
                                 rf'("\({sides}\)"\s*{{\s*type\s+)empty',
                                 r"\1symmetryPlane")
        return case

    def run(self, folder):
        case = self.prepare(folder)
        checked(["./Allrun"], case.path, MESH=str(self.elements),
                PRESET=self.preset, NP=str(self.ranks), PLOT="0")
        return case


@dataclass(frozen=True)
class Tutorial:
    """A tutorial as a user runs it, and its changes."""

    path: str
    mesh: str = "I"
    scheme: tuple = ()          # ((keyword, value), ...) of vertexCentred
    material: tuple = ()        # of all mechanicalProperties
    control: tuple = ()         # of controlDict
    options: tuple = ()         # ((variable, value), ...) of its Allrun
    ranks: int = 1
    preset: str = PRESET

    def run(self, folder):
        tutorials = copyTutorials(folder/"tutorials")
        case = Case(tutorials/self.path)
        for region in case.regions:
            case.set(f"system/{region}/fvSchemes", {
                f"vertexCentred/{k}": v for k, v in self.scheme})
            case.set(f"constant/{region}/mechanicalProperties",
                     {k: dict(v) if isinstance(v, tuple) else v
                      for k, v in self.material})
        case.set("system/controlDict", dict(self.control))
        checked(["./Allrun"], case.path, MESH=self.mesh, PRESET=self.preset,
                NP=str(self.ranks), PLOT="0", **dict(self.options))
        return case


class Runs:
    """Runs scenes in the background, each once, even if several processes use
    the same folder."""

    def __init__(self, folder, nThreads=len(os.sched_getaffinity(0))):
        self.folder = Path(folder)
        self.folder.mkdir(exist_ok=True)
        self.pool = ThreadPoolExecutor(nThreads)
        self.futures = {}

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.pool.shutdown(cancel_futures=True)

    def _run(self, scene):
        name = hashlib.sha1(repr(scene).encode()).hexdigest()
        done = self.folder/f"{name}.done"
        with (self.folder/f"{name}.lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if done.exists():
                return Case(done.read_text())
            folder = self.folder/name
            shutil.rmtree(folder, ignore_errors=True)   # of one that failed
            case = scene.run(folder)
            done.write_text(str(case.path))
            return case

    def start(self, scene):
        if scene not in self.futures:
            self.futures[scene] = self.pool.submit(self._run, scene)
        return self.futures[scene]

    def result(self, scene):
        return self.start(scene).result()


def runAgain(case, ranks=1, look=lambda case, output: None):
    """Run a case, remove everything that it wrote after the middle one of its
    times, and run it again from there. Returns for each run the contents of
    its last time, by rank, and the result of a function of the case and the
    output."""
    if ranks > 1:
        case.decompose(ranks)
    folders = rankFolders(ranks)
    results = []
    for _ in range(2):
        output = checked(solver(ranks), case.path)
        times = timeFolders(case/folders[0])
        results.append((
            [contents(case/folder/times[-1]) for folder in folders],
            look(Case(case.path), output)))
        if len(results) == 1:
            for folder in folders:
                for time in times[(len(times) + 1)//2:]:
                    shutil.rmtree(case/folder/time)
    return results


def meansAround(x, values, places, way):
    """Means of values along the last axis, where x is within a distance of
    each of the places."""
    return np.stack([values[..., np.abs(x - place) < way].mean(axis=-1)
                     for place in places], axis=-1)


def rise(energy, scale=None):
    """Largest rise above any earlier value, relative to the initial value or
    to a scale."""
    return float(np.max(energy - np.minimum.accumulate(energy))
                 / (energy[0] if scale is None else scale))


def checkEnergies(f, case, interface=None, *, balance, total=None, own=None,
                  penetration=None):
    """Check how contact conserves energy, with limits for the residual of its
    balance, for rises of the total energy and of this energy minus all works,
    and for the penetration of faces."""
    initial = case.totalEnergy[0]
    if total is not None:
        f.atMost("largest rise of the total energy / initial",
                 rise(case.keptEnergy), total)
    if own is not None:
        f.atMost("largest rise of the energy less works / initial",
                 rise(case.ownEnergy), own)
    if penetration is not None:
        f.atMost("largest penetration / face",
                 case.contact(interface)["relativePenetration"].max(),
                 penetration)
    f.atMost("residual of the energy balance / initial", float(
        np.abs(case.energies["total:balance"]).max()/initial), balance)


def relativeL1(times, values, exact):
    """Integral of |values - exact| over the integral of |exact|, in time."""
    times = np.asarray(times)
    return (np.trapezoid(np.abs(values - exact), times)
            / np.trapezoid(np.abs(exact), times))


def checkerboard(p, edges):
    """|p - mean over the neighbours| / |p - mean over all|, from nodal values
    and pairs of neighbours."""
    total, count = np.zeros_like(p), np.zeros_like(p)
    for here, there in ((0, 1), (1, 0)):
        np.add.at(total, edges[:, here], p[edges[:, there]])
        np.add.at(count, edges[:, here], 1)
    return np.linalg.norm(p - total/count)/np.linalg.norm(p - p.mean())
