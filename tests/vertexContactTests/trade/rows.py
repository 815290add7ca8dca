"""Runs of the cases as rows of the tables trade.csv and peers.csv: errors and
costs. The time of a run is divided by that of a small fixed case, which runs
right before and after it."""

import csv
import re
import tempfile
import threading
from pathlib import Path

from vertexContactTests.trade import peers
from vertexContactTests.trade.calibration import SHORT
from vertexContactTests.trade.cases import CASES, FOLDER, Stopped
from vertexContactTests.trade.variants import OPTIONS, label

# 'peer': the error relative to the reference of the compared program
ERRORS = ("error", "velocity", "stress", "force", "peak", "impulse", "energy",
          "rise", "penetration", "length", "radius", "plasticWork", "peer")
COSTS = ("nodes", "steps", "seconds", "us", "calibration", "cost")
COLUMNS = ("case", "label", *OPTIONS, *ERRORS, *COSTS, "status")


class Table:
    """A file of rows, written at each change. keys: columns that identify a
    run."""

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
    return Table(FOLDER/"trade.csv", COLUMNS, ("case", *OPTIONS))


def peersTable():
    return Table(FOLDER/"peers.csv", peers.COLUMNS, peers.KEYS)


def stepCosts(log):
    """Costs of the steps from the end of the solver's log."""
    steps, seconds, us = re.search(
        r"Steps: (\d+) in (\S+) s, (\S+) us", log).groups()
    nodes = sum(map(int, re.findall(r"(\d+) nodes, \d+ edges", log)))
    return {"nodes": nodes, "steps": int(steps), "seconds": float(seconds),
            "us": float(us)}


def once(case, chosen):
    """Errors and costs of a run in a folder that is removed afterwards."""
    with tempfile.TemporaryDirectory() as folder:
        done = case.run(Path(folder), chosen)
        costs = stepCosts(done.log())
        return case.errors(done), costs


def why(output):
    """The reason why the solver stopped, from the output of Allrun."""
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
