#!/usr/bin/env python3
"""Time from the command to the first step, and peak memory, by number of nodes:
one body, and two bodies whose meshes do not match.

    . etc/bashrc; tests/benchmark/startup.py [CELLS]

Blocks of up to CELLS^3 hexahedra (default 99, a million nodes) as tetrahedra,
one core. Writes startup.md beside this file.
"""

import os
import re
import subprocess
import tempfile
import time
from pathlib import Path

from vertexContactTests import arguments
from vertexContactTests.smallCases import RUBBER, Body, SmallCase, interface

here = Path(__file__).resolve().parent

CONTROL = {"preset": "balanced", "adjustTimeStep": "no", "functions": {},
           "writeControl": "none", "timePrecision": 12, "deltaT": 1e-5,
           "endTime": 3.5e-5, "logInterval": 1}


def one(folder, cells):
    body = Body(cells=(cells,)*3, material=RUBBER, velocity=(0.1, 0, 0))
    return SmallCase(folder, body, 1, control=CONTROL)


def two(pairing):
    def make(folder, cells):
        # Both bodies together have as many nodes as the single body
        n = round(cells/2**(1/3))
        bodies = (Body(cells=(n,)*3, name="below", velocity=(0.1, 0.1, 0),
                       sides={"top": "contact"}),
                  Body(cells=(n - 1,)*3, name="above", start=(0, 1, 0),
                       sides={"bottom": "contact"}))
        return SmallCase(folder, bodies, 1, {"contact": interface(
            ("below", "top"), ("above", "bottom"), pairing=pairing)},
            control=CONTROL)
    return make


SCENES = {"one body": one, "two bodies, AMI": two("AMI"),
          "two bodies, nearestFace": two("nearestFace")}


def start(case):
    """Number of nodes, seconds without the steps, and memory [MB]: the peak,
    and during the steps."""
    begin = time.perf_counter()
    with open(case/"log", "w") as log:
        process = subprocess.Popen(["vertexContactFoam"], cwd=case.path,
                                   stdout=log, stderr=subprocess.STDOUT)
        # Resident memory after a step
        held = 0
        while not (ended := os.wait4(process.pid, os.WNOHANG))[0]:
            resident = re.search(r"VmRSS:\s+(\d+)", Path(
                f"/proc/{process.pid}/status").read_text())
            if not held and resident and "\nStep 1 " in (
                    case/"log").read_text():
                held = int(resident[1])/1024
            time.sleep(0.005)
        _, status, usage = ended
    seconds = time.perf_counter() - begin
    text = (case/"log").read_text()
    assert status == 0, text[-2000:]
    nodes = sum(map(int, re.findall(r"(\d+) nodes,", text)))
    steps = float(re.search(r"Steps: \d+ in (\S+) s", text)[1])
    return nodes, seconds - steps, usage.ru_maxrss/1024, held


def main():
    parser = arguments.parser(__doc__)
    parser.add_argument("cells", type=int, nargs="?", default=99)
    cells = parser.parse_args().cells
    lines = []
    with tempfile.TemporaryDirectory() as folder:
        for name, make in SCENES.items():
            for n in (cells//4, cells//2, cells):
                case = make(Path(folder)/f"{len(lines)}", n)
                nodes, seconds, peak, held = start(case)
                lines.append(f"| {name} | {nodes:,} | {seconds:.1f} | "
                             f"{1e6*seconds/nodes:.1f} | {peak:,.0f} | "
                             f"{held:,.0f} | {1048576*held/nodes:,.0f} |")
                print(lines[-1], flush=True)
        # The last case has two bodies
        begin = time.perf_counter()
        case.decompose(2)
        decomposition = time.perf_counter() - begin
    (here/"startup.md").write_text(f"""# Start-up

Written by `tests/benchmark/startup.py {cells}`: from the command until the first step has begun, with the end of the run (nothing is written);
one core. In the memory is all of OpenFOAM and its mesh. Meshes as blockMesh writes them.

| scene | nodes | seconds | µs per node | peak memory [MB] | in steps [MB] | in steps, bytes per node |
|---|---|---|---|---|---|---|
""" + "\n".join(lines) + f"""

`decomposePar` of the last one, METIS, 2 ranks: {decomposition:.1f} s.
""")


if __name__ == "__main__":
    main()
