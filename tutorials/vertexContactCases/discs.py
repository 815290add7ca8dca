"""Write the files of a hundred discs (tutorials/hundredDiscs) in the folder of
the case, from those of the template: each has a place, a radius, and a
velocity. What they have in common stands in constant/solidProperties and
system/fvSchemes. Prints a line for each: its name, its radius [m], and its
centre as multiples of that. With -list nothing is written, and the names are
printed, as an entry of a dictionary.

    python3 -m vertexContactCases.discs [-list]

The same numbers in each run: they are those of minstd, not of a generator that
may change with Python.
"""

import re
import shutil
import sys
from pathlib import Path

COLUMNS, ROWS = 10, 10
WIDTH = 0.28                # of the box [m], as in constant/triSurface/box.obj
SPACING = 0.027             # of the places [m]
LOWEST = 0.016              # centre of the lowest row [m]
RADII = 0.008, 0.010, 0.012
SHIFT = 0.0012              # from the places, at most, in x and in y [m]
SPEED = 0.5                 # largest velocity, in x and in y [m/s]
# Of soft and of stiff discs [kg/m3], as in constant/solidProperties
DENSITY = 1000, 2000


def random(seed):
    """Random numbers between -1 and 1."""
    while True:
        seed = 48271*seed % 2147483647
        yield 2*seed/2147483647 - 1


def discs():
    """Name, radius, centre, and velocity of each disc, and whether it is
    stiff."""
    numbers = random(20261124)
    left = 0.5*(WIDTH - (COLUMNS - 1)*SPACING)
    for i in range(ROWS*COLUMNS):
        row, column = divmod(i, COLUMNS)
        x, y, u, v, size = (next(numbers) for _ in range(5))
        centre = (left + column*SPACING + SHIFT*x,
                  LOWEST + row*SPACING + SHIFT*y)
        yield (f"disc{i + 1}", RADII[int(1.5*(size + 1)) % 3], centre,
               (SPEED*u, SPEED*v), i % 3 == 2)


def write(file, **values):
    """Change values of a dictionary."""
    text = file.read_text()
    for key, value in values.items():
        text, n = re.subn(rf"(?m)^({key} +)[^;]+;", rf"\g<1>{value};", text)
        if n != 1:
            raise ValueError(f"no '{key}' in {file}")
    file.write_text(text)


def main(case=Path()):
    for name, radius, (x, y), (u, v), _ in discs():
        for folder in "system", "constant", "0":
            shutil.copytree(case/folder/"disc", case/folder/name)
        write(case/"0"/name/"pointU", internalField=f"uniform ({u} {v} 0)")
        print(name, radius, f"({x/radius} {y/radius} 0)")


if __name__ == "__main__":
    if sys.argv[1:] == ["-list"]:
        print(f"discs ({' '.join(disc[0] for disc in discs())});")
    else:
        main()
