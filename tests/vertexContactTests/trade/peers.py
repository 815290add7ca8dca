"""The compared programs: their runs of the cases, with errors and costs as for
the solver. The first programs are the plain finite elements of
tests/benchmark/peers/plainFEM, which belong to this project; CalculiX is from
a package."""

import hashlib
import re
import shutil
import tempfile
from pathlib import Path

from vertexContactCases import readResults
from vertexContactTests.caseTools import Case, checked, root
from vertexContactTests.trade.calibration import SHORT
from vertexContactTests.trade.cases import CASES

sources = root/"tests"/"benchmark"/"peers"/"plainFEM"
NAME = "plainFEM"
TITLE = "plain FEM"
# The same with one element after the other, and the number of elements at once
ONE = "plainFEM1"
WIDTH = {NAME: 8, ONE: 1}

# Programs from packages, which tests/benchmark/peers/install installs: their
# titles, and the meshes of the cases that they can do
PACKAGED = {"calculix": "CalculiX"}
PACKAGED_MESHES = {"calculix": {"rings": (5, 10), "taylor": (2, 4, 6)}}

MESHES = {
    "similar": tuple(2**k for k in range(6, 14)),
    "dissimilar": tuple(2**k for k in range(6, 14)),
    "rings": (5, 10, 20, 40),
    "incompressible": (4, 8, 16, 32, 64),
    "nonMatching": (1, 2, 3, 4, 5, 8, 10),
    "taylor": (2, 4, 6, 8)}

# Finest meshes, of their own references
FINEST = {"rings": 80, "incompressible": 128, "nonMatching": 30, "taylor": 12}

KEYS = "program", "case", "mesh"
# 'own': the error relative to the program's own reference
COLUMNS = (*KEYS, "error", "own", "velocity", "force", "peak", "impulse",
           "energy", "rise", "length", "radius", "plasticWork", "nodes",
           "steps", "seconds", "us", "calibration", "cost")


class Failed(RuntimeError):
    """A program from a package ended with an error."""


def program(name=NAME):
    """The path of the program. It is compiled if there is none of these
    sources for this processor."""
    target = checked(["g++", "-march=native", "-Q", "--help=target"], root)
    files = sorted(file for file in sources.iterdir() if file.suffix != ".md")
    key = hashlib.sha256(target.encode() + b"".join(
        file.read_bytes() for file in files)).hexdigest()[:12]
    made = root/".build"/f"{name}-{key}"
    if not made.exists():
        made.parent.mkdir(exist_ok=True)
        with tempfile.TemporaryDirectory(dir=made.parent) as folder:
            checked([str(sources/"build"), f"{folder}/{name}",
                     str(WIDTH[name])], root)
            shutil.move(f"{folder}/{name}", made)
    return made


def run(name, mesh, file, kind=NAME):
    """Write the table of histories; returns the data of its comment."""
    checked([str(program(kind)), name, str(mesh), "-out", str(file)], root)
    with open(file) as lines:
        comment = next(lines)
    return {key: float(value) for key, value in re.findall(
        r"(bodies|nodes|steps|seconds|rise) ([^ ,\n]+)", comment)}


def costs(said):
    """Costs for all bodies. The program computes only one of two mirror
    images."""
    return {"nodes": said["bodies"]*said["nodes"], "steps": said["steps"],
            "seconds": said["bodies"]*said["seconds"],
            "us": 1e6*said["seconds"]/said["steps"]/said["nodes"]}


def once(name, mesh, kind=NAME):
    """Errors and costs of a run."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder)/"histories.csv"
        said = run(name, mesh, file, kind)
        histories = readResults.csv(file)
    case = CASES[name]
    right = case.reference(Case(root/"tutorials"/case.tutorial))
    errors = {**case.difference(histories, right), "rise": said["rise"]}
    own = case.peerReference()
    if own:
        errors["own"] = case.difference(histories, own)["error"]
    return errors, costs(said)


def oncePackaged(program, name, mesh):
    """The same for a program from a package."""
    # Imported here, since others do not need its modules
    from vertexContactTests.peers import calculix
    try:
        histories, said = calculix.run(name, mesh)
    except calculix.Failed as stop:
        raise Failed(f"{program} {name} {mesh}: {stop}") from None
    case = CASES[name]
    right = case.reference(Case(root/"tutorials"/case.tutorial))
    return {**case.difference(histories, right), "rise": said["rise"]}, \
        costs(said)


def meshes(program):
    """Meshes of the cases of a program."""
    return MESHES if program in WIDTH else PACKAGED_MESHES[program]


def measure(name, mesh, calibration, program=NAME):
    """A row of the table."""
    def run():
        return once(name, mesh, program) if program in WIDTH \
            else oncePackaged(program, name, mesh)

    before = calibration.run()
    errors, cost = run()
    repeated = 0
    while cost["seconds"] < SHORT and repeated < 2:
        repeated += 1
        cost = min(cost, run()[1], key=lambda c: c["seconds"])
    unit = (before + calibration.run())/2
    numbers = {**errors, **cost, "calibration": unit,
               "cost": cost["seconds"]/unit}
    return {"program": program, "case": name, "mesh": str(mesh),
            **{k: f"{v:.5g}" for k, v in numbers.items() if k in COLUMNS}}


def makeReference(name):
    """Run the finest mesh and keep its histories as the reference."""
    said = run(name, FINEST[name], CASES[name].peerFile)
    print(f"{name}, {NAME}: {said['seconds']:.0f} s", flush=True)


def agreement(name):
    """Differences of the program's reference from ours; None if one is
    missing."""
    case = CASES[name]
    own = case.peerReference()
    return case.difference(own, case.reference(None)) if own else None
