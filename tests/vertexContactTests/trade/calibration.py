"""A small fixed case of the solver, which is the unit of costs."""

import re
import tempfile
from pathlib import Path

import numpy as np

from vertexContactTests.caseTools import checked
from vertexContactTests.smallCases import RUBBER, Body, SmallCase

# Runs shorter than this are repeated, and the fastest counts [s]
SHORT = 0.3

CELLS = 16
STEPS = 40
RATE = np.diag((0.1, -0.05, -0.05))


class Calibration:
    """A free block of rubber that is stretched, with a fixed step and the
    default options written out, so that no other default changes the unit."""

    def __init__(self):
        self.folder = tempfile.TemporaryDirectory()
        deltaT = 0.05/CELLS
        body = Body(cells=(CELLS,)*3, material=RUBBER,
                    velocity=lambda X: (X - 0.5) @ RATE,
                    scheme={"cells": "simplicial", "reconstruction": "full",
                            "limiter": "BarthJespersen", "kinematics": "FHJ"})
        self.case = SmallCase(
            Path(self.folder.name)/"block", body, (STEPS + 0.5)*deltaT,
            control={"deltaT": deltaT, "adjustTimeStep": "no",
                     "functions": {}, "writeControl": "none",
                     "timePrecision": 12})

    def run(self):
        """Seconds of all steps."""
        log = checked(["vertexContactFoam"], self.case.path)
        return float(re.search(r"Steps: \d+ in (\S+) s", log)[1])
