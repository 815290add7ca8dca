#!/usr/bin/env python3
"""Norms of the fields of every tutorial, on a coarse mesh and until its bodies
are in contact, to tell whether work on the code has changed results.

    . etc/bashrc; tests/vertexContactTests/fieldReferences.py

runs them and writes tests/regression/fieldReferences.json, with which
test_decompositions.py compares. To be done only when results are meant to change.
"""

import json
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np

from vertexContactTests.caseTools import (DEFAULT, Runs, Tutorial, root,
                                          timeFolders)

FILE = root/"tests"/"regression"/"fieldReferences.json"

# Path, mesh, end of the run [s], options of Allrun
TUTORIALS = (
    ("twoBarImpact/similar", "32", 0.2, {}),
    ("twoBarImpact/dissimilar", "32", 0.2, {}),
    ("ringCollision", "4", 0.0085, {}),
    ("nearlyIncompressibleBars", "4", 1.1e-4, {}),
    ("nonMatchingBars", "1", 8e-6, {}),
    ("nonMatchingBars", "1", 8e-6, {"PAIRING": "nearestFace"}),
    ("torusImpact", "2", 0.005, {}),
    ("torusImpact/elastoPlastic", "2", 0.005, {}),
    ("hertzContact", "2", 8e-4, {}),
    ("hertzContact", "2", 8e-4, {"SCENE": "spheres"}),
    ("shallowIroning", "4", 3e-4, {}),
    ("newtonsCradle", "1", 1e-3, {}),
    ("selfContact", "3", 0.0035, {}),
    ("taylorBar", "2", 1e-5, {}),
    ("twistingColumn", "2", 0.02, {}),
    ("spinningCube", "3", 0.02, {}),
)
NAMES = [" ".join((path, *options.values()))
         for path, _, _, options in TUTORIALS]


def scene(path, mesh, end, options):
    return Tutorial(path, mesh, control=(("endTime", end),
                                         ("writeInterval", end)),
                    options=tuple(options.items()))


# For the paper's scheme, and for the default scheme
PAPERS = [scene(*t) for t in TUTORIALS]
DEFAULTS = [replace(s, preset=DEFAULT) for s in PAPERS]
REFERENCES = {**dict(zip(NAMES, PAPERS)),
              **{f"{n}, {DEFAULT}": s for n, s in zip(NAMES, DEFAULTS)}}


def norms(case):
    """L2 norm of each field, and its sum with weights that differ between
    points and components."""
    last = timeFolders(case.path)[-1]
    result = {}
    for folder in sorted((case/last).glob("*/pointD")):
        region = folder.parent.name
        X = case.points(region)
        result[f"{region} points"] = [float(np.linalg.norm(X)), len(X)]
        for file in sorted(folder.parent.iterdir()):
            if file.is_file():
                values = case.field(last, region, file.name)
                weights = np.cos(0.7*np.arange(values.size))
                result[f"{region} {file.name}"] = [
                    float(np.linalg.norm(values)),
                    float(values.ravel() @ weights)]
    return result


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(Path(folder))
        FILE.write_text(json.dumps(
            {name: norms(runs.result(s)) for name, s in REFERENCES.items()},
            indent=1) + "\n")
