#!/usr/bin/env python3
"""Time per node and step of the kernels, and per simulated time, by dimension,
cells, material, options and size; of the default scheme and of the paper's.

    . etc/bashrc; tests/benchmark/kernel.py [-few] [-page] [-before FOLDER]

One core, a free block that is stretched, steps as long as the scheme takes
them, no output, nothing in contact; the median of three runs, start-up not
counted. Writes kernel.csv, kernel.md and kernel.png beside this file. -before:
also runs the build in another clone of the repository, in turns with this one,
since a machine is faster at one time than at another. -few: one row of each
block, printed only. -page: only the page, from the figures of kernel.csv.
"""

import csv
import re
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from vertexContactTests import arguments
from vertexContactTests.caseTools import checked
from vertexContactTests.smallCases import Body, SmallCase

here = Path(__file__).resolve().parent
root = here.parents[1]

ELASTIC = {"rho": 1, "E": 1, "nu": 0.3}
MATERIALS = {
    "linearElastic": ELASTIC, "neoHookean": ELASTIC,
    "MooneyRivlin": {**ELASTIC, "xi": 0.05},
    "HenckyVonMises": {**ELASTIC, "tauY": 1e-3, "Hardening": 0.1}}
BASE = {"preset": "balanced", "material": "neoHookean", "correction": ""}
VARIANTS = [BASE] + [{**BASE, **change} for change in (
    {"correction": "0"}, {"material": "linearElastic"},
    {"material": "linearElastic", "correction": "0"},
    {"material": "MooneyRivlin"}, {"material": "HenckyVonMises"},
    {"preset": "paper"})]
BLOCKS = {  # dimension, scheme for cells, number of cells in each direction
    "1D": (1, "simplicialSingle", 20000),
    "2D": (2, "simplicial", 150),
    "tetrahedra": (3, "simplicialSingle", 27),
    "hexahedra": (3, "simplicial", 27),
    "hexahedra, native": (3, "native", 27)}
SIZES = (9, 21, 46, 58, 99)     # for blocks of tetrahedra
KEYS = ("block", "cells", *BASE)

TRIAD = """
#include <chrono>
#include <cstdio>
#include <vector>
int main()
{
    const long n = 1 << 25;
    std::vector<double> a(n, 0), b(n, 1), c(n, 2);
    double least = 1e9;
    for (int k = 0; k < 5; ++k)
    {
        const auto start = std::chrono::steady_clock::now();
        for (long i = 0; i < n; ++i) a[i] = b[i] + 3.0*c[i];
        const std::chrono::duration<double> t =
            std::chrono::steady_clock::now() - start;
        if (t.count() < least) least = t.count();
    }
    std::printf("%g %g\\n", 24e-9*n/least, a[n/2]);
}
"""


def bandwidth(folder):
    """Bandwidth of the triad of STREAM on this core [GB/s]."""
    source = folder/"triad.cpp"
    source.write_text(TRIAD)
    checked(["g++", "-O3", "-march=native", str(source), "-o",
             str(folder/"triad")], folder)
    return float(checked([str(folder/"triad")], folder).split()[0])


def make(folder, block, cells, options):
    d, scheme, _ = BLOCKS[block]
    rate = np.diag((0.1, -0.05, -0.05))
    scheme = {"cells": scheme}
    if options["correction"]:
        scheme["correction"] = float(options["correction"])
    body = Body(cells=(cells,)*d, scheme=scheme,
                material={"type": options["material"],
                          **MATERIALS[options["material"]]},
                velocity=lambda X: (X - 0.5) @ rate)
    return SmallCase(folder, body, 1, control={
        "preset": options["preset"],
        "maxCo": 0.6 if options["preset"] == "paper" else 0.9, "deltaT": 0.05/cells, "functions": {},
        "writeControl": "none", "timePrecision": 12})


def run(case, end, where):
    """Figures from the log of a run to a time: µs per node and step, steps,
    nodes, edges, bytes per node."""
    case.set("system/controlDict", {"endTime": end})
    log = checked(["bash", "-c", ". \"$0\"/etc/bashrc; "
                   "exec vertexContactFoam", str(where)], case.path)
    nodes, edges = map(int, re.search(r"(\d+) nodes, (\d+) edges",
                                      log).groups())
    steps, us = re.search(r"Steps: (\d+) in \S+ s, (\S+) us", log).groups()
    return {"us": float(us), "steps": int(steps), "nodes": nodes,
            "edges": round(edges/nodes, 2),
            "bytes": int(re.findall(r"(\d+) bytes per node", log)[-1])}


def measure(folder, block, cells, options, before):
    """A row of the table. 'crossing' is the time per node to simulate the time
    that a pressure wave needs for a cell."""
    case = make(folder, block, cells, options)
    nodes = (cells + 1)**BLOCKS[block][0]
    end = max(20, 2e6/nodes)*0.3/cells
    here_, there = [], []
    for _ in range(3):
        here_.append(run(case, end, root))
        if before:
            there.append(run(case, end, before))
    us = float(np.median([r["us"] for r in here_]))
    old = float(np.median([b["us"]/a["us"] for a, b in zip(here_, there)])) \
        if before else ""
    cp = np.sqrt((1 - 0.3)/((1 + 0.3)*(1 - 2*0.3)))
    return {"block": block, "cells": cells, **options, **here_[0],
            "us": round(us, 4),
            "crossing": round(us*here_[0]["steps"]/(end*cells*cp), 4),
            "before": round(old, 3) if before else ""}


def name(row):
    """The options that differ from the defaults."""
    said = ["`paper`"] if row["preset"] == "paper" else []
    if row["correction"]:
        said.append(f"`correction` {row['correction']}")
    return ", ".join([row["material"], *said])


def table(rows):
    lines = ["| block | nodes | edges a node | law, options | "
             "µs per node and step | µs per node and crossing of a cell | "
             "bytes a node | ratio to the build before |", "|" + "---|"*8]
    for r in rows:
        ratio = f"{1/float(r['before']):.2f}" if r["before"] else ""
        lines.append(
            f"| {r['block']} | {r['nodes']:,} | {r['edges']} | {name(r)} | "
            f"{r['us']:.3f} | {r['crossing']:.3f} | {r['bytes']:,} | {ratio} |")
    return "\n".join(lines)


def elements():
    """µs per node and step of the plain finite elements, hexahedra and
    quadrangles."""
    from vertexContactTests.trade import peers
    lines = ["| plain finite elements | nodes | µs per node and step |",
             "|---|---|---|"]
    with tempfile.TemporaryDirectory() as folder:
        for what, mesh in (("rings", 20), ("rings", 40), ("nonMatching", 2),
                           ("nonMatching", 10), ("nonMatching", 16),
                           ("taylor", 4)):
            costs = peers.costs(peers.run(what, mesh, Path(folder)/"o.csv"))
            lines.append(f"| {what}, {mesh} elements | "
                         f"{costs['nodes']:,.0f} | {costs['us']:.3f} |")
    return "\n".join(lines)


def picture(rows):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(figsize=(7, 5))
    for law, marker in (("balanced", "o-"), ("paper", "s-")):
        mine = [r for r in rows if r["block"] == "tetrahedra"
                and r["material"] == "neoHookean" and not r["correction"]
                and r["preset"] == law]
        mine.sort(key=lambda r: r["nodes"])
        axes.plot([r["nodes"] for r in mine], [r["us"] for r in mine], marker,
                  label=law)
    axes.set(xlabel="nodes, tetrahedra", ylabel="µs per node and step",
             xscale="log")
    axes.set_ylim(bottom=0)
    axes.legend()
    figure.tight_layout()
    figure.savefig(here/"kernel.png", dpi=120)


def page(rows, stream):
    picture(rows)
    commit = subprocess.run(["git", "-C", str(root), "describe", "--always",
                             "--dirty"], capture_output=True, text=True)
    (here/"kernel.md").write_text(f"""# Speed of the kernels

Written by `tests/benchmark/kernel.py`, build {commit.stdout.strip() or "unknown"}. One core, no output, nothing in contact; the median of three runs.
`paper` evaluates its fluxes twice in a step. A crossing is the time that a pressure wave needs for the width of a cell. So this column is the cost per
simulated time, which does not depend on the length of the steps. The triad of STREAM on this core moves {stream:.1f} GB/s.

{table(rows)}

![µs per node and step by nodes](kernel.png)

{elements()}
""")


def main():
    parser = arguments.parser(__doc__)
    parser.add_argument("-few", action="store_true")
    parser.add_argument("-page", action="store_true")
    parser.add_argument("-before", type=lambda name: Path(name).resolve(),
                        metavar="FOLDER")
    given = parser.parse_args()
    tets = "tetrahedra"
    wanted = [(block, BLOCKS[block][2], options) for block in BLOCKS
              for options in (VARIANTS[:1] if given.few else VARIANTS)]
    wanted += [(tets, n, options) for n in SIZES
               for options in (BASE, {**BASE, "correction": "0"},
                               {**BASE, "preset": "paper"})
               if not given.few or n == 58]
    if given.page:
        with open(here/"kernel.csv") as file:
            rows = list(csv.DictReader(file))
        for row in rows:
            row.update({k: int(row[k]) for k in ("nodes", "bytes")})
            row.update({k: float(row[k]) for k in ("us", "crossing")})
        with tempfile.TemporaryDirectory() as folder:
            page(rows, bandwidth(Path(folder)))
        return
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        stream = bandwidth(folder)
        for i, (block, cells, options) in enumerate(wanted):
            rows.append(measure(folder/str(i), block, cells, options,
                                given.before))
            print(*rows[-1].values(), flush=True)
        stream = max(stream, bandwidth(folder))
    if given.few:
        return
    with open(here/"kernel.csv", "w", newline="") as out:
        writer = csv.DictWriter(out, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)
    page(rows, stream)


if __name__ == "__main__":
    main()
