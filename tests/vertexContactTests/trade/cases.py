"""The cases of the trade: how each runs with given options, its histories, and
their errors relative to a reference."""

import re
from dataclasses import dataclass, field

import numpy as np

from vertexContactCases import readResults
from vertexContactCases.exactSolution import TwoBarImpact
from vertexContactTests.caseTools import (Case, Scene, copyTutorials, execute,
                                          relativeL1, root)
from vertexContactTests.trade.variants import CONTACT, CONTROL, SCHEME

# Folder of tables, pictures and references
FOLDER = root/"tests"/"benchmark"/"trade"
references = FOLDER/"reference"

# Number of samples of histories, evenly over the run; many if solutions jump
SAMPLES = 400
SAMPLES_OF_JUMPS = 4000
INTERVALS = 100

# The errors whose mean is the error of a run
COMBINED = "velocity", "force", "energy"


class Stopped(RuntimeError):
    """The solver ended the run."""


def meanForce(history):
    """Mean force in each of INTERVALS parts of the run. So the peak does not
    depend on a single step or on the step length."""
    every = len(history["Time"])//INTERVALS
    times, impulse = (history[k][every - 1::every]
                      for k in ("Time", "impulse"))
    return times, np.diff(impulse, prepend=0)/np.diff(times, prepend=0)


@dataclass(frozen=True)
class TradeCase:
    """A tutorial, its meshes, and the observed points."""

    name: str
    title: str
    tutorial: str
    base: str                   # mesh for the variation of options
    meshes: tuple               # other meshes, for the presets
    finest: str                 # mesh of the reference
    region: str                 # of the probe
    point: tuple
    axis: int                   # direction of the impact
    sides: tuple                # (interface, side) whose forces are compared
    choices: dict = field(default_factory=dict)
    more: tuple = ()            # options that only this case varies
    extra: dict = field(default_factory=dict)   # additional probes
    conforming: tuple = ()      # matching meshes, as those of plain FEM

    samples = SAMPLES

    def copy(self, folder, options):
        return Case(copyTutorials(folder/"tutorials")/self.tutorial)

    def prepare(self, folder, options):
        """The case folder before the run."""
        case = self.copy(folder, options)
        chosen = {k: v for k, v in options.items() if v != ""}

        def of(names, prefix=""):
            return {prefix + k: entry(chosen[k]) for k in names
                    if k in chosen}

        end = readEntry(case/"system/controlDict", "endTime")
        case.set("system/controlDict", {
            **of(CONTROL), "writeInterval": end, "logInterval": 100000,
            "functions": self.functions()})
        for region in case.regions:
            case.set(f"system/{region}/fvSchemes",
                     of(SCHEME, "vertexCentred/"))
            if "material" in chosen:
                case.set(f"constant/{region}/mechanicalProperties",
                         {"type": chosen["material"]})
        if "pairing" in chosen:
            file = "constant/contactProperties"
            case.replace(file, r"(?m)^ +pairing +\S+;", " ".join(
                f"{k} {v};" for k, v in of(CONTACT).items()))
            if chosen["pairing"] == "nearestFace":
                # nearestFace uses the normals
                case.replace(file, r"(?m)^( +direction .*)?$", "")
        return case

    def functions(self):
        """Only the function objects whose files are read here."""
        each = {"writeControl": "timeStep", "writeInterval": 1}
        made = {name: {"type": name, "libs": ["vertexContact"], **each}
                for name in ("solidEnergies", "contactForces")}
        for name, point in {"probe": self.point, **self.extra}.items():
            made[name] = {
                "type": "pointProbes", "libs": ["vertexContact"], **each,
                "region": self.region, "points": [list(point)],
                "fields": ["pointU", "pointD", "sigma"]}
        return made

    def run(self, folder, options):
        return self.start(self.prepare(folder, options),
                          options["preset"], options["mesh"])

    def start(self, case, preset, mesh):
        """Run a prepared case."""
        done = execute(["./Allrun"], case.path, PLOT="0", MESH=mesh,
                       PRESET=preset)
        if done.returncode != 0:
            raise Stopped(done.stdout)
        return case

    def times(self, case):
        end = readEntry(case/"system/controlDict", "endTime")
        return end*np.arange(1, self.samples + 1)/self.samples

    def histories(self, case):
        """Histories at the same times for all runs of a case."""
        times = self.times(case)

        def at(name, quantity, component):
            t, values = case.probe(name, quantity)
            return np.interp(times, t, values[:, component])

        impulse = 0
        for interface, side in self.sides:
            table = case.contact(interface)
            impulse = impulse + np.interp(
                times, np.append(0, table["Time"]),
                np.append(0, table[f"{side}:I{'xyz'[self.axis]}"]))
        E0 = case.totalEnergy[0]

        def energy(values):
            return np.interp(times, case.energies["Time"], values/E0)

        return {"Time": times, "velocity": at("probe", "pointU", self.axis),
                # Index in a symmetric tensor: xx xy xz yy yz zz
                "stress": at(self.stressProbe, "sigma",
                             (0, 3, 5)[self.axis]),
                "impulse": impulse,
                "energy": energy(case.totalEnergy),
                "plasticWork": energy(
                    case.energies["total:plasticDissipation"]),
                **{name: at(name, "pointD", component)
                   for name, component in self.displacements.items()}}

    stressProbe = "probe"
    # Names of probes, and components of their displacements
    displacements = {}

    def reference(self, case):
        """Histories of the reference, whose file is kept."""
        return readResults.csv(references/f"{self.name}.csv")

    @property
    def peerFile(self):
        return references/f"{self.name}-plainFEM.csv"

    def peerReference(self):
        """Histories on the finest mesh of peers/plainFEM. None if the exact
        solution is known, or if they were not computed."""
        file = self.peerFile
        return readResults.csv(file) if file.exists() else None

    def errors(self, case):
        """Errors of a run relative to the reference."""
        energy = case.keptEnergy/case.keptEnergy[0]
        ours, peer = self.histories(case), self.peerReference()
        return {
            **self.difference(ours, self.reference(case)),
            **({"peer": self.difference(ours, peer)["error"]} if peer else {}),
            "rise": np.max(energy - np.minimum.accumulate(energy)),
            "penetration": max(
                case.contact(interface)["relativePenetration"].max()
                for interface, _ in self.sides)}

    def difference(self, ours, right):
        """Errors of histories of any program relative to others at the same
        times; of stresses, if both have them."""
        times = right["Time"]

        def off(a, b):
            return abs(a/b - 1)

        (parts, force), (_, rightForce) = map(meanForce, (ours, right))
        found = {
            **{key: relativeL1(times, ours[key], right[key])
               for key in ("velocity", "stress")
               if key in ours and key in right},
            "force": relativeL1(parts, force, rightForce),
            "peak": off(np.abs(force).max(), np.abs(rightForce).max()),
            "impulse": off(ours["impulse"][-1], right["impulse"][-1]),
            # Energy that is not lost; plastic work is not lost either
            "energy": sum(ours[k][-1] - right[k][-1]
                          for k in ("energy", "plasticWork"))}
        found |= self.moreErrors(ours, right)
        found["error"] = np.mean([abs(found[k]) for k in COMBINED])
        return found

    def moreErrors(self, ours, right):
        return {}


class TwoBars(TradeCase):
    """Two bars, whose exact solution is known."""

    samples = SAMPLES_OF_JUMPS

    def copy(self, folder, options):
        return Scene(self.tutorial.split("/")[1], int(options["mesh"]),
                     int(options["dimension"])).prepare(folder)

    def reference(self, case):
        exact = TwoBarImpact.fromCase(case.path)
        times = self.times(case)
        X = exact.bars[0].end
        # For a cross-section of one square metre; fine enough for the jumps
        fine = np.linspace(0, exact.endTime, 100*self.samples + 1)
        force = np.minimum(exact.stress(0, X, fine), 0)
        integral = np.append(0, np.cumsum(
            (force[1:] + force[:-1])/2*np.diff(fine)))
        return {"Time": times, "velocity": exact.velocity(0, X, times),
                "stress": exact.stress(0, X, times),
                "impulse": np.interp(times, fine, integral),
                "energy": np.ones_like(times),
                "plasticWork": np.zeros_like(times)}

    def histories(self, case):
        """Histories per square metre of cross-section, in any dimension."""
        exact = TwoBarImpact.fromCase(case.path)
        area = case.totalEnergy[0]/sum(
            exact.energies(bar, [0])[0][0] for bar in (0, 1))
        found = super().histories(case)
        return {**found, "impulse": found["impulse"]/area}


class Taylor(TradeCase):
    """A rod that becomes shorter and wider. The velocity is that of its free
    end, the stress that of its foot."""

    stressProbe = "foot"
    displacements = {"probe": 1, "rim": 0}
    LENGTH, RADIUS = 32.4e-3, 3.2e-3

    def moreErrors(self, ours, right):
        def off(size, key):
            return abs((size + ours[key][-1])/(size + right[key][-1]) - 1)

        return {"length": off(self.LENGTH, "probe"),
                "radius": off(self.RADIUS, "rim"),
                "plasticWork": ours["plasticWork"][-1]
                - right["plasticWork"][-1]}


def entry(text):
    """A value as foamlib needs it: numbers and switches are not words."""
    if text in ("yes", "no"):
        return text == "yes"
    try:
        return float(text)
    except ValueError:
        return text


def readEntry(file, key):
    """A number from a dictionary."""
    return float(re.search(rf"(?m)^{key}\s+(\S+);", file.read_text())[1])


def bars(name, title):
    return TwoBars(
        name, title, f"twoBarImpact/{name}", base="256",
        meshes=("64", "128", "512"), finest="", region="bar1",
        point=(10, 0, 0), axis=0, sides=(("bars", "bar1.right"),),
        choices={"material": "linearElastic", "dimension": "1",
                 "pairing": "matching"},
        more=({"material": "neoHookean"}, {"pairing": "AMI"},
              {"pairing": "nearestFace"}, {"mesh": "64", "dimension": "2"},
              {"mesh": "64", "dimension": "3"}))


CASES = {case.name: case for case in (
    bars("similar", "two similar bars"),
    bars("dissimilar", "two dissimilar bars"),
    TradeCase(
        "rings", "rings", "ringCollision", base="10", meshes=("5", "20"),
        finest="40", region="ring1", point=(0.04, 0, 0), axis=0,
        sides=(("rings", "ring1.outer"),),
        choices={"pairing": "matching"}, more=({"pairing": "nearestFace"},)),
    TradeCase(
        "incompressible", "nearly incompressible bars",
        "nearlyIncompressibleBars", base="8", meshes=("4", "16", "32"),
        finest="64", region="bar1", point=(0.0324, 0, 0), axis=0,
        sides=(("bars", "bar1.right"),), choices={"pairing": "matching"},
        more=({"pairing": "AMI"}, {"pairing": "nearestFace"})),
    TradeCase(
        "nonMatching", "non-matching bars", "nonMatchingBars", base="2",
        meshes=("1", "3", "4"), finest="10", region="bar2",
        # For the free end: touching corners converge much more slowly
        point=(0.0652, 0.0032, 0.0032), axis=0,
        sides=(("bars", "bar2.left"),), choices={"pairing": "AMI"},
        more=({"pairing": "nearestFace"},
              {"preset": "paper", "transfer": "twoWay"}),
        conforming=("conforming2", "conforming3", "conforming4",
                    "conforming6")),
    Taylor(
        "taylor", "Taylor bar", "taylorBar", base="4", meshes=("2", "6"),
        finest="12", region="rod", point=(0, 0.0324, 0), axis=1,
        sides=(("wall", "rod.foot"), ("mantle", "rod.mantle")),
        extra={"rim": (0.0032, 0, 0), "foot": (0, 0, 0)}))}
