#!/usr/bin/env python3
"""Write histories of a finished case as a table to compare other runs with:
time, velocity and displacement in x, or another direction, of point A, total
energy over initial.

    writeReference.py CASE FILE COMMENT [x|y|z]
"""

import sys
from pathlib import Path

import numpy as np

from vertexContactCases import readResults


def main(case, file, comment, direction="x", rows=401):
    component = "xyz".index(direction)
    energies = readResults.table(case, "solidEnergies", "energies.dat")
    total = energies["total:kinetic"] + energies["total:strain"]
    t, v = readResults.probe(case, "pointA", "pointU")
    _, u = readResults.probe(case, "pointA", "pointD")
    times = np.linspace(0, energies["Time"][-1], rows)
    columns = (times, np.interp(times, t, v[:, component]),
               np.interp(times, t, u[:, component]),
               np.interp(times, energies["Time"], total/total[0]))
    Path(file).parent.mkdir(exist_ok=True)
    with open(file, "w") as out:
        out.write(f"# {comment}\n"
                  f"Time,v{direction},u{direction},E\n")
        for row in zip(*columns):
            out.write(",".join(f"{value:.7g}" for value in row) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
