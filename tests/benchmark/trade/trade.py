#!/usr/bin/env python3
"""What accuracy costs: runs the cases with many options, and writes trade.csv,
a picture per case, and ../trade.md, which says what to choose.

    . etc/bashrc
    tests/benchmark/trade/trade.py [-jobs N] [-missing] [-only TEXT] [case ...]
    tests/benchmark/trade/trade.py -page
    tests/benchmark/trade/trade.py [-peers] -reference [case ...]
    tests/benchmark/trade/trade.py -peers [-program NAME] [case ...]

Rows of trade.csv are replaced as their runs finish. -missing: only those that
are not there; -only: variants whose label has that text; -page: no runs.
-reference: the finest mesh with the preset 'accurate', whose histories are
kept in reference/, and how far the next coarser mesh is from them.
-peers: instead of the solver, the plain finite elements of ../peers/plainFEM
on meshes of their own, with rows in peers.csv and references of their own.
-program: plainFEM1, the same one element after the other; or another of ../peers, which ../peers/install gets.

The time of a run is divided by that of a small fixed case, which runs right
before and after it: machines are faster at one time than at another.
"""

import argparse
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from vertexContactTests import caseTools
from vertexContactTests.trade import peers
from vertexContactTests.trade.calibration import Calibration
from vertexContactTests.trade.cases import CASES, references
from vertexContactTests.trade.page import writePage
from vertexContactTests.trade.rows import measure, peersTable, tradeTable
from vertexContactTests.trade.variants import label, named, variants

caseTools.timeLimit = 4*3600


def trade(names, jobs, missing, only):
    """Run the variants of the cases."""
    table = tradeTable()
    work = [(CASES[name], chosen) for name in names
            for chosen in variants(CASES[name])
            if only in label(CASES[name], chosen)]
    if missing:
        work = [(case, chosen) for case, chosen in work
                if (case.name, *chosen.values()) not in table.rows]
    local = threading.local()

    def do(item):
        if not hasattr(local, "calibration"):
            local.calibration = Calibration()
        row = measure(*item, local.calibration)
        table.put(row)
        print(row["case"], "|", row["label"], "| error",
              row.get("error", ""), "| cost", row.get("cost", ""), "|",
              row["status"], flush=True)

    with ThreadPoolExecutor(jobs) as pool:
        list(pool.map(do, work))


def runPeers(names, program):
    """Run one of the compared programs on its meshes, one after the other. A
    run that ends with an error gives no row."""
    table, calibration = peersTable(), Calibration()
    meshes = peers.meshes(program)
    for name in names:
        for mesh in meshes.get(name, ()):
            try:
                row = peers.measure(name, mesh, calibration, program)
            except peers.Failed as stop:
                print(stop, flush=True)
                continue
            table.put(row)
            print(row["program"], row["case"], row["mesh"], "| error",
                  row["error"], "| cost", row["cost"], flush=True)


def makeReference(case):
    """Histories on the finest mesh, written with as many digits as matter."""
    chosen = named(case, "accurate", case.finest)
    start = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        histories = case.histories(case.run(Path(folder), chosen))
    references.mkdir(exist_ok=True)
    with open(references/f"{case.name}.csv", "w") as out:
        out.write(f"# {case.title}, mesh {case.finest}, preset accurate\n"
                  + ",".join(histories) + "\n")
        for row in np.array(list(histories.values())).T:
            out.write(",".join(f"{x:.6g}" for x in row) + "\n")
    print(f"{case.name}: {time.perf_counter() - start:.0f} s", flush=True)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("cases", nargs="*", metavar="case",
                        help=", ".join(CASES))
    parser.add_argument("-jobs", type=int, default=1)
    parser.add_argument("-only", default="")
    parser.add_argument("-program", default=peers.NAME,
                        choices=(*peers.WIDTH, *peers.PACKAGED))
    for flag in "-missing", "-page", "-reference", "-peers":
        parser.add_argument(flag, action="store_true")
    given = parser.parse_args()
    unknown = set(given.cases) - set(CASES)
    if unknown:
        parser.error(f"no case {', '.join(unknown)}; there are "
                     + ", ".join(CASES))
    if given.program != peers.NAME and (given.reference or not given.peers):
        parser.error("-program needs -peers, and has no reference")
    names = given.cases or list(CASES)
    if given.reference:
        for name in names:
            if CASES[name].finest and given.peers:
                peers.makeReference(name)
            elif CASES[name].finest:
                makeReference(CASES[name])
    elif given.peers:
        runPeers(names, given.program)
    elif not given.page:
        trade(names, given.jobs, given.missing, given.only)
    writePage(tradeTable().rows.values(), peersTable().rows.values())


if __name__ == "__main__":
    main()
