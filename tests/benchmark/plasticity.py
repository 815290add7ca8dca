#!/usr/bin/env python3
"""What plasticity costs: time per node and step of a block of tetrahedra, by
that of a neo-Hookean one, where no node yields and where every node does.

    . etc/bashrc; tests/benchmark/plasticity.py [CELLS [STEPS]]

The block (CELLS^3 hexahedra, default 24, as tetrahedra; one core) is stretched
at a constant rate. Each material runs five times and the fastest counts, less a
run of one step, which has the set-up.
"""

import re
import tempfile
from pathlib import Path

import numpy as np

from vertexContactTests import arguments
from vertexContactTests.caseTools import checked
from vertexContactTests.smallCases import Body, SmallCase

ELASTIC = {"rho": 1, "E": 1, "nu": 0.3}
MATERIALS = {
    "neoHookean": {"type": "neoHookean", **ELASTIC},
    "plastic, elastic so far": {"type": "HenckyVonMises", "tauY": 1e3,
                                **ELASTIC},
    "plastic, every node yields": {"type": "HenckyVonMises", "tauY": 1e-9,
                                   "Hardening": 0.1, **ELASTIC}}
RATE = np.diag((0.1, -0.05, -0.05))


def seconds(folder, material, cells, steps):
    body = Body(cells=(cells,)*3, material=material,
                velocity=lambda X: (X - 0.5) @ RATE)
    deltaT = 0.02/cells
    case = SmallCase(folder, body, steps*deltaT, control={
        "deltaT": deltaT, "adjustTimeStep": "no", "functions": {}})
    log = checked(["vertexContactFoam"], case.path)
    if material["type"] == "HenckyVonMises":
        yielded = np.mean(case.at("epsilonPEq") > 0)
        assert yielded == (material["tauY"] < 1), yielded
    return float(re.findall(r"ExecutionTime = ([0-9.]+)", log)[-1])


def main():
    parser = arguments.parser(__doc__)
    parser.add_argument("cells", type=int, nargs="?", default=24)
    parser.add_argument("steps", type=int, nargs="?", default=100)
    given = parser.parse_args()
    cells, steps = given.cells, given.steps
    nodes = (cells + 1)**3
    # In turns, since a machine is not equally fast at all times
    least = {}
    with tempfile.TemporaryDirectory() as folder:
        for i in range(5):
            for name, material in MATERIALS.items():
                for n in (1, steps):
                    case = Path(folder)/f"{i} {name} {n}".replace(" ", "-")
                    t = seconds(case, material, cells, n)
                    least[name, n] = min(t, least.get((name, n), t))
    times = {name: (least[name, steps] - least[name, 1])/(steps - 1)
             for name in MATERIALS}
    reference = times["neoHookean"]
    print("material,microseconds per node and step,by neo-Hookean")
    for name, time in times.items():
        print(f'"{name}",{1e6*time/nodes:.3f},{time/reference:.3f}')


if __name__ == "__main__":
    main()
