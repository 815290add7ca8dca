#!/usr/bin/env python3
"""Strong scaling on 1 and 2 ranks, what a rank sends in a step, and what that
means for many ranks. Writes scaling.md beside this file.

    . etc/bashrc; tests/benchmark/scaling.py [CELLS [STEPS]]

A free block (CELLS^3 hexahedra as tetrahedra, default 58, neo-Hookean,
defaults) that is stretched; medians of nine runs, start-up not counted. Needs
two free cores. Messages and bytes are
counted by Open MPI's monitoring component (pml_monitoring), point to point and
inside of reductions.
"""

import math
import re
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from foamlib import FoamFile

from vertexContactTests import arguments
from vertexContactTests.smallCases import RUBBER, Body, SmallCase

RATE = np.diag((0.1, -0.05, -0.05))
NETWORK = 2e-6, 10e9        # assumed: latency [s] and bandwidth [bytes/s]
MANY = 1e8, 1e4             # nodes, ranks
EXCHANGES = 4               # gradients, corrections, adjoints, forces


class Block:
    """A case, its time per step, and its messages on a number of ranks."""

    def __init__(self, folder, cells, ranks):
        self.ranks = ranks
        body = Body(cells=(cells,)*3, material=RUBBER,
                    scheme={"cells": "simplicialSingle"},
                    velocity=lambda X: (X - 0.5) @ RATE)
        self.deltaT = 0.1/cells
        self.case = SmallCase(folder, body, self.deltaT, control={
            "preset": "balanced", "deltaT": self.deltaT,
            "adjustTimeStep": "no", "functions": {}, "writeControl": "none"})
        if ranks > 1:
            self.case.decompose(ranks)

    def start(self, steps, *options):
        """The process of a run with so many steps."""
        self.case.set("system/controlDict", {"endTime": steps*self.deltaT})
        command = ["vertexContactFoam"]
        if self.ranks > 1:
            command = ["mpirun", *options, "-np", str(self.ranks), *command,
                       "-parallel"]
        return subprocess.Popen(command, cwd=self.case.path, text=True,
                                stdout=subprocess.PIPE)

    def run(self, steps, *options):
        """Seconds per step."""
        return secondsPerStep(self.start(steps, *options))

    def sent(self, steps=20):
        """Messages and bytes of a rank in a step, as the largest values of all
        ranks: point to point, and within reductions."""
        totals = []
        for n in (1, steps + 1):
            profile = self.case/f"profile{n}"
            self.run(n, "--mca", "pml_monitoring_enable", "1",
                     "--mca", "pml_monitoring_enable_output", "3",
                     "--mca", "pml_monitoring_filename", str(profile))
            total = np.zeros((self.ranks, 2, 2))
            for rank in range(self.ranks):
                for kind, size, count in re.findall(
                        r"^([EI])\s+\d+\s+\d+\s+(\d+) bytes\s+(\d+) msgs sent",
                        Path(f"{profile}.{rank}.prof").read_text(), re.M):
                    total[rank, "EI".index(kind)] += int(count), int(size)
            totals.append(total)
        return ((totals[1] - totals[0])/steps).max(axis=0)

    def sharedNodes(self):
        """Number of nodes that two ranks share."""
        mine, others = (set(np.asarray(FoamFile(
            self.case/f"processor{rank}/constant/body/polyMesh"
            / "pointProcAddressing")[None]).tolist()) for rank in (0, 1))
        return len(mine & others)


def secondsPerStep(process):
    log = process.communicate()[0]
    assert process.returncode == 0, log[-2000:]
    steps, seconds = re.search(r"Steps: (\d+) in (\S+) s", log).groups()
    return float(seconds)/int(steps)


def perStep(one, two, steps, rounds=9):
    """Seconds per step on one rank and on two. The value for one rank is the
    median of its runs. The value for two ranks is this median divided by the
    median of the ratios of runs next to each other, since a machine is not
    equally fast at all times. Also the middle half of the efficiencies."""
    times = np.array([[block.run(steps) for block in (one, two)]
                      for _ in range(rounds)])
    low, ratio, high = np.percentile(times[:, 0]/times[:, 1], (25, 50, 75))
    single = np.median(times[:, 0])
    return single, single/ratio, (low/2, high/2)


def slowedDown(one, other, steps, rounds=9):
    """The factor by which a run slows down beside another run that shares only
    the machine with it."""
    ratios = []
    for _ in range(rounds):
        alone = one.run(steps)
        both = [block.start(steps) for block in (one, other)]
        ratios.append(np.mean([secondsPerStep(p) for p in both])/alone)
    return np.median(ratios)


def main():
    parser = arguments.parser(__doc__)
    parser.add_argument("cells", type=int, nargs="?", default=58)
    parser.add_argument("steps", type=int, nargs="?", default=20)
    given = parser.parse_args()
    cells, steps = given.cells, given.steps
    nodes = (cells + 1)**3
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        one, two = (Block(folder/str(n), cells, n) for n in (1, 2))
        t1, t2, spread = perStep(one, two, steps)
        slower = slowedDown(one, Block(folder/"other", cells, 1), steps)
        (messages, size), (reductions, reduced) = two.sent()
        shared = two.sharedNodes()
        # For blocks so small that messages determine the time
        small = [Block(folder/f"small{n}", 4, n) for n in (1, 2)]
        s1, s2, _ = perStep(*small, 2000)
        (fewMessages, _), (fewReductions, _) = small[1].sent()
    latency = max(s2 - s1/2, 0)/(fewMessages + fewReductions)

    perNode = t1/nodes
    bytesShared = size/shared

    def predicted(many, ranks):
        own = many/ranks
        # A cube of nodes has six neighbours across faces, and 26 in all. It
        # shares its surface with them. A reduction goes up a tree and down
        # again
        surface = 6*own**(2/3)
        toNeighbours = 26*EXCHANGES
        inTrees = 2*math.log2(ranks)*(collective + 1)
        return (own*perNode, toNeighbours, inTrees,
                surface*bytesShared/NETWORK[1])

    # For few ranks OpenFOAM passes the data of a reduction from rank to rank
    collective = messages + reductions - EXCHANGES
    compute, toNeighbours, inTrees, sending = predicted(*MANY)
    waiting = (toNeighbours + inTrees)*NETWORK[0]
    efficiency = compute/(compute + waiting + sending)
    page = f"""# Strong scaling

Written by `tests/benchmark/scaling.py {cells} {steps}`: a free block of {nodes:,} nodes, tetrahedra, neo-Hookean, defaults, no output. One
machine, nothing else running.

| ranks | seconds a step | µs per node and step | efficiency |
|---|---|---|---|
| 1 | {t1:.4f} | {1e6*t1/nodes:.3f} | 1 |
| 2 | {t2:.4f} | {2e6*t2/nodes:.3f} | {t1/(2*t2):.3f} |

The median of nine pairs of runs, next to each other in time; the middle half of their efficiencies is {spread[0]:.3f} to {spread[1]:.3f}.
Two runs on one rank each, at the same time, take {slower:.3f} times as long as one alone: that much is not the program's.

What a rank of the two sends in a step (Open MPI's `pml_monitoring`): {messages + reductions:.1f} messages and {size + reduced:,.0f} bytes to its
neighbour: {EXCHANGES} exchanges, of gradients, corrections, adjoints and forces, {bytesShared:,.0f} bytes for each of the {shared:,} nodes that it shares, and {collective:.1f} messages of
reductions (the check of the state, with signals and pairings; a step that adjusts itself needs one more).
Blocks of 125 nodes take {1e6*s1:.1f} µs a step on one rank and {1e6*s2:.1f} µs on two: {1e6*latency:.2f} µs a message between cores of one machine.

## {MANY[0]:.0e} nodes on {MANY[1]:.0e} ranks, on paper

Every rank has a cube of {MANY[0]/MANY[1]:,.0f} nodes, shares its surface, and sends in each exchange to 26 neighbours. With the measured cost of a
node and bytes of a shared node, and an assumed network with {1e6*NETWORK[0]:.0f} µs a message and {NETWORK[1]/1e9:.0f} GB/s:

| | ms a step |
|---|---|
| nodes | {1e3*compute:.2f} |
| messages, one after the other: {toNeighbours} to neighbours, {inTrees:.0f} up and down the trees of reductions | {1e3*waiting:.2f} |
| bytes | {1e3*sending:.2f} |
| efficiency | {efficiency:.2f} |

Exchanges are not overlapped with the edges between own nodes: that could save {100*(toNeighbours*NETWORK[0] + sending)/(compute + waiting + sending):.1f} % of such a step at most.

Not measured: contention of the network, imbalance of the decomposition, contact (an interface adds one message to each rank opposite and
back, however many pairs of surfaces it has, and with friction another one).
"""
    (Path(__file__).parent/"scaling.md").write_text(page)
    print(page)


if __name__ == "__main__":
    main()
