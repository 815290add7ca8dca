#!/usr/bin/env python3
"""What general contact costs: time and memory by the number of bodies.

    . etc/bashrc; tests/benchmark/generalContact.py

Squares of 8 x 8 cells on a grid fly to the middle, one after the other they
meet their four neighbours; and two plates in 3D of which a tenth of one face
touches the other. One core. Start: all but the steps. Share: of searching and
of forces in the time of the steps, from the log of the solver. Memory: the
largest that the program used, beside that of the same bodies without contact.
Writes generalContact.md beside this file.
"""

import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from vertexContactTests import arguments
from vertexContactTests.smallCases import Body, SmallCase

here = Path(__file__).resolve().parent
root = here.parents[1]

MATERIAL = {"type": "neoHookean", "rho": 1000, "E": 1e6, "nu": 0.3}
SQUARES = (4, 10, 32)       # number of squares on a side of the grid
ALL = {"all": {"surfaces": "all"}}


def squares(n, contact):
    def body(i, j):
        sides = {s: "contact" for s in ("left", "right", "bottom", "top")}
        middle = 0.5*(n - 1)
        return Body(cells=(8, 8), name=f"b{i}x{j}", material=MATERIAL,
                    start=(1.01*i, 1.01*j, 0), sides=sides if contact else {},
                    velocity=(2*(middle - i)/n, 2*(middle - j)/n, 0))
    return [body(i, j) for i in range(n) for j in range(n)]


def plates(cells, contact):
    """Two plates; a tenth of one face touches the other plate."""
    def body(name, start, velocity):
        sides = {s: "contact" for s in (
            "left", "right", "bottom", "top", "back", "front")}
        return Body(cells=(cells, 2, cells), name=name, material=MATERIAL,
                    size=(1, 2/cells, 1), start=start,
                    sides=sides if contact else {}, velocity=velocity)
    return [body("a", (0, 0, 0), (0, 1, 0)),
            body("b", (0.9, 2.05/cells, 0.0021), (0, -1, 0))]


def measured(bodies, contact, end, folder):
    case = SmallCase(folder, bodies, end, ALL if contact else None,
                     preset="balanced",
                     control={"maxCo": 0.9, "functions": {},
                              "writeControl": "none"})
    begin = time.perf_counter()
    done = subprocess.run(
        ["/usr/bin/env", "python3", "-c",
         "import resource, subprocess, sys; "
         "r = subprocess.run(['vertexContactFoam'], capture_output=True, "
         "text=True); print(r.stdout); "
         "print('PEAK', resource.getrusage(resource.RUSAGE_CHILDREN)"
         ".ru_maxrss); sys.exit(r.returncode)"],
        cwd=case.path, capture_output=True, text=True)
    whole = time.perf_counter() - begin
    log = done.stdout
    if done.returncode:
        sys.exit(log[-3000:])
    steps, seconds = re.search(r"Steps: (\d+) in (\S+) s", log).groups()
    share = re.search(r"Contact: (\S+) % of the time of the steps in (\d+) "
                      r"pairings, (\S+) % in", log)
    near = re.search(r"may touch and (\d+) are near", log)
    return {"ms": 1e3*float(seconds)/int(steps), "steps": int(steps),
            "start": whole - float(seconds),
            "share": [float(share[1]), int(share[2]), float(share[3])]
            if share else None,
            "near": int(near[1]) if near else 0,
            "MB": int(re.search(r"PEAK (\d+)", log)[1])/1024}


def main():
    arguments.parser(__doc__).parse_args()
    lines = []
    scenes = [(f"{n*n} squares", n*n*32, lambda c, n=n: squares(n, c), 0.2)
              for n in SQUARES]
    scenes += [(f"two plates of {n} x {n} x 2 cells", 4*n*(n + 4),
                lambda c, n=n: plates(n, c), 15/n/40) for n in (50, 160)]
    with tempfile.TemporaryDirectory() as folder:
        for i, (what, faces, make, end) in enumerate(scenes):
            off, on = (measured(make(c), c, end, Path(folder)/f"{i}{c}")
                       for c in (False, True))
            search, n, forces = on["share"]
            lines.append(
                f"| {what} | {faces:,} | {on['near']} | {off['ms']:.3g} | "
                f"{on['ms']:.3g} | {search:.1f} % | {on['steps']/max(n, 1):.0f}"
                f" | {forces:.1f} % | {off['start']:.1f} | {on['start']:.1f} | "
                f"{off['MB']:.0f} | {on['MB']:.0f} |")
            print(lines[-1], flush=True)
    commit = subprocess.run(["git", "describe", "--always", "--dirty"],
                            cwd=root, capture_output=True,
                            text=True).stdout.strip() or "no repository"
    (here/"generalContact.md").write_text(f"""# What general contact costs

Written by `tests/benchmark/generalContact.py`: `surfaces all`, one core, `balanced`. *Near* is the number of pairs of surfaces that a step looks at. *Search*
is the share of the time of the steps that finding pairs and pairings takes. *Forces* is the share of contact in each step. *Start* is the time without the
steps. Each value stands beside that of the same bodies without contact.
Built from {commit}.

| | faces | near at first | free [ms per step] | contact [ms per step] | search | steps per pairing | forces | start, free [s] | start, contact [s] | free [MB] | contact [MB] |
|---|---|---|---|---|---|---|---|---|---|---|---|
""" + "\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
