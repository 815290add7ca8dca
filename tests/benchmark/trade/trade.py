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
import csv
import re
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

here = Path(__file__).resolve().parent
sys.path.insert(0, str(Path(__file__).resolve().parents[2]/"tools"))
import searchPath

import numpy as np

import caseTools
import peers
from calibration import SHORT, Calibration
from cases import CASES, Stopped, references
from variants import OPTIONS, label, named, variants

# 'peer': the error against the reference of the program to compare with
ERRORS = ("error", "velocity", "stress", "force", "peak", "impulse", "energy",
          "rise", "penetration", "length", "radius", "plasticWork", "peer")
COSTS = ("nodes", "steps", "seconds", "us", "calibration", "cost")
COLUMNS = ("case", "label", *OPTIONS, *ERRORS, *COSTS, "status")
caseTools.timeLimit = 4*3600


class Table:
    """A file of rows, written whenever one changes. keys: columns that say
    what was run."""

    def __init__(self, file, columns, keys):
        self.file = file
        self.columns = columns
        self.keys = keys
        self.lock = threading.Lock()
        self.rows = {}
        if file.exists():
            with open(file) as lines:
                self.rows = {self.key(row): row
                             for row in csv.DictReader(lines)}

    def key(self, row):
        return tuple(row[k] for k in self.keys)

    def put(self, row):
        with self.lock:
            self.rows[self.key(row)] = row
            order = list(CASES)
            rows = sorted(self.rows.values(),
                          key=lambda r: order.index(r["case"]))
            new = self.file.with_suffix(".new")
            with open(new, "w", newline="") as out:
                writer = csv.DictWriter(out, self.columns, restval="",
                                        lineterminator="\n")
                writer.writeheader()
                writer.writerows(rows)
            new.replace(self.file)


def tradeTable():
    return Table(here/"trade.csv", COLUMNS, ("case", *OPTIONS))


def peersTable():
    return Table(here/"peers.csv", peers.COLUMNS, peers.KEYS)


def stepCosts(log):
    """From the end of the solver's log."""
    steps, seconds, us = re.search(
        r"Steps: (\d+) in (\S+) s, (\S+) us", log).groups()
    nodes = sum(map(int, re.findall(r"(\d+) nodes, \d+ edges", log)))
    return {"nodes": nodes, "steps": int(steps), "seconds": float(seconds),
            "us": float(us)}


def once(case, chosen):
    """A run in a folder that is removed: its errors and costs."""
    with tempfile.TemporaryDirectory() as folder:
        done = case.run(Path(folder), chosen)
        costs = stepCosts(done.log())
        return case.errors(done), costs


def why(output):
    """The solver's reason to stop, from what Allrun shows."""
    for pattern in (r"The state is not finite[^\n]*",
                    r"FOAM FATAL[^\n]*\n[\s|]*([^\n]*)"):
        found = re.search(pattern, output)
        if found:
            return found[0].split("|")[-1].strip()
    return output.strip().splitlines()[-1]


def measure(case, chosen, calibration):
    """A row of the table."""
    row = {"case": case.name, "label": label(case, chosen), **chosen}
    before = calibration.run()
    try:
        errors, costs = once(case, chosen)
        while costs["seconds"] < SHORT and row.setdefault("n", 0) < 2:
            row["n"] += 1
            costs = min(costs, once(case, chosen)[1],
                        key=lambda c: c["seconds"])
        status = "done"
    except Stopped as stop:
        errors, costs, status = {}, {}, why(str(stop))
    row.pop("n", None)
    unit = (before + calibration.run())/2
    if costs:
        costs |= {"calibration": unit, "cost": costs["seconds"]/unit}
    numbers = {k: f"{v:.5g}" for k, v in {**errors, **costs}.items()}
    return {**row, **numbers, "status": status}


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
    """Run a program to compare with on its meshes, one at a time. One that
    ends badly leaves no row."""
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
    """Histories of the finest mesh, kept with so many digits as count."""
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
    from page import writePage
    writePage(tradeTable().rows.values(), peersTable().rows.values())


if __name__ == "__main__":
    main()
