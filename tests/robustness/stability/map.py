#!/usr/bin/env python3
"""The stability map: runs every cell, writes stability.csv, the pictures, and
the page stability.md in the folder above.

    . etc/bashrc; tests/robustness/stability/map.py [-jobs N] [group ...]

Without groups all of them; the rows of a group that is run replace its old
ones, and the page is always made from the whole table. -jobs: runs at the same
time (default 1). -page: nothing is run.
"""

import argparse
import csv
import json
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from vertexContactTests.stability import page
from vertexContactTests.stability.groups import GROUPS, cellsOf
from vertexContactTests.stability.judge import WRONG, Result

here = Path(__file__).resolve().parent
TABLE = here/"stability.csv"
COLUMNS = "group", "parameters", "outcome", "figures", "why", "seconds"

# Started first, since they take longest
LONG = "settling", "resting", "spin", "vibration"


def cell(group, parameters):
    """Run one cell of the map, in a folder that is removed afterwards. Returns
    a row of the table."""
    scene, _ = GROUPS[group]
    start = time.time()
    with tempfile.TemporaryDirectory(prefix="stability") as folder:
        try:
            result = scene(Path(folder)/"case", **parameters)
        except Exception as error:
            result = Result(WRONG, why=f"{type(error).__name__}: {error}")
    row = {"group": group, "parameters": json.dumps(parameters),
           "outcome": result.outcome, "figures": json.dumps({
               name: [float(f"{value:.4g}"), *bounds]
               for name, (value, *bounds) in result.figures.items()}),
           "why": result.why.replace("\n", " ")[:300],
           "seconds": f"{time.time() - start:.1f}"}
    print(group, row["parameters"], row["outcome"], row["why"][:100],
          row["seconds"], flush=True)
    return row


def read():
    if not TABLE.exists():
        return []
    with open(TABLE, newline="") as file:
        return list(csv.DictReader(file))


def write(rows):
    order = list(GROUPS)
    with open(TABLE, "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(sorted(
            rows, key=lambda r: order.index(r["group"])))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("-jobs", type=int, default=1)
    parser.add_argument("-page", action="store_true")
    parser.add_argument("groups", nargs="*", metavar="group",
                        help=f"of {' '.join(GROUPS)}")
    options = parser.parse_args()
    unknown = set(options.groups) - set(GROUPS)
    if unknown:
        parser.error(f"no group {' '.join(unknown)}; there are: "
                     f"{' '.join(GROUPS)}")
    if not options.page:
        wanted = options.groups or list(GROUPS)
        wanted = sorted(wanted, key=lambda g: (g not in LONG,
                                               list(GROUPS).index(g)))
        with ThreadPoolExecutor(options.jobs) as pool:
            futures = [pool.submit(cell, group, parameters)
                       for group in wanted for parameters in cellsOf(group)[1]]
            rows = [future.result() for future in futures]
        write([r for r in read() if r["group"] in set(GROUPS) - set(wanted)]
              + rows)
    page.write(here, read())


if __name__ == "__main__":
    main()
