#!/usr/bin/env python3
"""Time per node and step of the kernels, by dimension, cells, material,
reconstruction, limiter, kinematics and size.

    . etc/bashrc; tests/benchmark/kernel.py [-few] [-before FOLDER]

One core, fixed step, a block that is stretched, no output, nothing in contact;
the median of three runs, start-up not counted. Writes kernel.csv, kernel.md and
kernel.png beside this file. -before: also runs the build in another clone of
the repository, in turns with this one, since a machine is faster at one time
than at another; else its figures are those in kernel.csv. -few: up to 205,379
nodes; linear and full reconstruction.
"""

import csv
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

here = Path(__file__).resolve().parent
root = here.parents[1]
sys.path[:0] = [str(root/"tests"/"verification"), str(root/"tutorials")]

import numpy as np

from caseTools import checked
from smallCases import Body, SmallCase

ELASTIC = {"rho": 1, "E": 1, "nu": 0.3}
MATERIALS = {
    "linearElastic": ELASTIC, "neoHookean": ELASTIC,
    "MooneyRivlin": {**ELASTIC, "xi": 0.05},
    "HenckyVonMises": {**ELASTIC, "tauY": 1e-3, "Hardening": 0.1}}
BASE = {"material": "neoHookean", "reconstruction": "linear",
        "limiter": "BarthJespersen", "kinematics": "FHJ"}
VARIANTS = [BASE] + [
    {**BASE, key: value} for key, values in (
        ("reconstruction", ("none", "full")),
        ("limiter", ("none", "Venkatakrishnan")),
        ("kinematics", ("F", "FJ")),
        ("material", ("linearElastic", "MooneyRivlin", "HenckyVonMises")))
    for value in values]
BLOCKS = {  # dimension, cells scheme, cells in each direction
    "1D": (1, "simplicialSingle", 20000), "2D": (2, "simplicialSingle", 150),
    "3D": (3, "simplicialSingle", 27), "3D hexes": (3, "native", 27)}
SIZES = (9, 21, 46, 58, 99)     # of 3D blocks
KEYS = ("block", "nodes", *BASE)

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
    """Triad of STREAM on this core [GB/s]."""
    source = folder/"triad.cpp"
    source.write_text(TRIAD)
    checked(["g++", "-O3", "-march=native", str(source), "-o",
             str(folder/"triad")], folder)
    return float(checked([str(folder/"triad")], folder).split()[0])


def components(d, options):
    """Stored components of a node: state, of these H, flux state W, of these
    with gradients, rates."""
    finite = options["material"] != "linearElastic"
    nJ = int(finite and options["kinematics"] != "F")
    nH = 0 if not finite else 9 if d == 3 else \
        int(d == 2 and options["kinematics"] == "FHJ")
    nW = d + nJ + d*d
    full = options["reconstruction"] == "full"
    nG = {"none": d, "linear": d + nJ, "full": nW}[options["reconstruction"]]
    return 2*d + d*d + nH + nJ, nH, nW, nG, d + nJ + 1 + full*d*d


def leastBytes(d, edges, options):
    """What a stage must move per node, each array once in each pass: state
    read and written, the old one read in the second stage; flux state written, and read
    with the gradients and with the fluxes; gradients and rates written and
    read; position, volumes, H with the fluxes; edges twice."""
    state, nH, nW, nG, rates = components(d, options)
    scalars = 2.5*state + 2*nW + nG + 2*d*nG + 2*rates + d + 2 + nH
    return 8*scalars + 2*edges*(8*d + 8)


def make(folder, block, cells, options):
    d, scheme, _ = BLOCKS[block]
    rate = np.diag((0.1, -0.05, -0.05))
    material = {"type": options["material"], **MATERIALS[options["material"]]}
    body = Body(cells=(cells,)*d, material=material,
                velocity=lambda X: (X - 0.5) @ rate,
                scheme={"cells": scheme, **{
                    key: options[key]
                    for key in ("reconstruction", "limiter", "kinematics")}})
    return SmallCase(folder, body, 1, control={
        "deltaT": 0.05/cells, "adjustTimeStep": "no", "functions": {},
        "writeControl": "none", "timePrecision": 12})


def run(case, cells, steps, root):
    """µs per node and step; nodes, edges and bytes per node."""
    def log(n):
        case.set("system/controlDict", {"endTime": (n + 0.5)*0.05/cells})
        start = time.perf_counter()
        text = checked(["bash", "-c", ". \"$0\"/etc/bashrc; "
                        "exec vertexContactFoam", str(root)], case.path)
        return time.perf_counter() - start, text

    seconds, text = log(steps)
    nodes, edges = map(int, re.search(r"(\d+) nodes, (\d+) edges",
                                      text).groups())
    size = int(re.findall(r"(\d+) bytes per node", text)[-1])
    told = re.search(r"(\S+) us per node and step", text)
    if told:
        return float(told[1]), nodes, edges, size
    # Builds from before the solver told it
    return 1e6*(seconds - log(1)[0])/((steps - 1)*nodes), nodes, edges, size


def measure(folder, block, cells, options, before):
    d = BLOCKS[block][0]
    case = make(folder, block, cells, options)
    steps = max(11, int(1e6/(cells + 1)**d))
    times, old = [], []
    for _ in range(3):
        us, nodes, edges, size = run(case, cells, steps, root)
        times.append(us)
        if before:
            old.append(run(case, cells, steps, before)[0])
    us = float(np.median(times))
    ratio = float(np.median(np.divide(old, times))) if before else None
    return {"block": block, "nodes": nodes, **options,
            "edges": round(edges/nodes, 2), "stored": size,
            "us": round(us, 4),
            "before": round(us*ratio, 4) if before else "",
            "leastBytes": round(leastBytes(d, edges/nodes, options))}


def table(rows, stream):
    lines = ["| block | nodes | material | reconstruction | limiter | "
             "kinematics | µs per node and stage | before | ratio | "
             "bytes stored per node | least bytes of a stage | "
             "share of the bandwidth bound |", "|" + "---|"*12]
    for r in rows:
        old = float(r["before"] or 0)
        stage = r["us"]/2
        bound = r["leastBytes"]/(1e3*stream)
        lines.append(
            f"| {r['block']}, {r['edges']} edges a node | {r['nodes']:,} | "
            f"{r['material']} | {r['reconstruction']} | {r['limiter']} | "
            f"{r['kinematics']} | {stage:.3f} | "
            + (f"{old/2:.3f} | {old/r['us']:.2f}" if old else "|")
            + f" | {r['stored']:,} | {r['leastBytes']:,} | {bound/stage:.2f} |")
    return "\n".join(lines)


def picture(rows, stream):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(figsize=(7, 5))
    least = [r["leastBytes"] for r in rows]
    line = np.array((min(least)/1.3, max(least)*1.3))
    axes.plot(line, line/(1e3*stream), "k-",
              label=f"bandwidth, {stream:.1f} GB/s")
    axes.plot(line, 2*line/(1e3*stream), "k--", label="half of it")
    for block, marker in zip(BLOCKS, "sdo^"):
        mine = [r for r in rows if r["block"] == block]
        axes.plot([r["leastBytes"] for r in mine],
                  [r["us"]/2 for r in mine], marker, label=block)
    axes.set(xlabel="bytes that a stage must move per node",
             ylabel="µs per node and stage", xscale="log",
             yscale="log")
    axes.legend()
    figure.tight_layout()
    figure.savefig(here/"kernel.png", dpi=120)


def page(rows, stream):
    picture(rows, stream)
    commit = subprocess.run(["git", "-C", str(root), "describe", "--always",
                             "--dirty"], capture_output=True, text=True)
    (here/"kernel.md").write_text(f"""# Speed of the kernels

Written by `tests/benchmark/kernel.py`, build {commit.stdout.strip() or "unknown"}. One core, two stages a step, no output; the median of
three runs. *Before*: the same runs with the build before the edge loops were rewritten, in turns with these. The bandwidth bound is the time that the triad of STREAM
on this core, {stream:.1f} GB/s, needs for the bytes that a stage must move (`leastBytes` in the script says which).

{table(rows, stream)}

![µs per node and stage by bytes](kernel.png)
""")


def main(*flags):
    few = "-few" in flags
    before = Path(flags[flags.index("-before") + 1]).resolve() \
        if "-before" in flags else None
    wanted = [("3D", n, BASE) for n in (SIZES[::3] if few else SIZES)]
    wanted += [(block, BLOCKS[block][2], options)
               for block in BLOCKS for options in VARIANTS
               if not (block == "1D" and options["kinematics"] == "FJ")
               and (not few or options == BASE
                    or options["reconstruction"] == "full")]
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        stream = bandwidth(folder)
        for i, (block, cells, options) in enumerate(wanted):
            rows.append(measure(folder/str(i), block, cells, options, before))
            print(*rows[-1].values(), flush=True)
        stream = max(stream, bandwidth(folder))
    if not before and (here/"kernel.csv").exists():
        with open(here/"kernel.csv") as file:
            known = {tuple(r[k] for k in KEYS): r["before"]
                     for r in csv.DictReader(file)}
        for r in rows:
            r["before"] = known.get(tuple(str(r[k]) for k in KEYS), "")
    with open(here/"kernel.csv", "w", newline="") as out:
        writer = csv.DictWriter(out, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)
    page(rows, stream)


if __name__ == "__main__":
    main(*sys.argv[1:])
