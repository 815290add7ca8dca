#!/usr/bin/env python3
"""Error and time of each preset in the six cases of the trade, on the base
meshes, one run after the other: makes presets.md beside it, in about three
minutes. Run in the environment of etc/bashrc."""

import sys
from pathlib import Path

here = Path(__file__).resolve().parent
sys.path[:0] = [str(here.parents[1]/folder) for folder in (
    "tests/benchmark/trade", "tests/verification", "tutorials",
    "tutorials/twoBarImpact")]

from calibration import Calibration
from cases import CASES
from trade import measure
from variants import PRESETS, named

HEAD = """# Presets

Made by `tests/benchmark/presets.py`. The error is the mean of those of a velocity, of the contact force, and of the energy left, against the exact
solution (bars) or the stored fine meshes of `trade/reference`. Seconds are those of the steps, one core; steps of `paper` evaluate the fluxes twice.

| case, mesh | preset | error % | velocity % | force % | energy % | seconds | steps |
|---|---|---|---|---|---|---|---|
"""


def main():
    calibration = Calibration()
    lines = []
    for case in CASES.values():
        for preset in PRESETS:
            row = measure(case, named(case, preset, case.base), calibration)
            if row["status"] != "done":
                sys.exit(f"{case.name}, {preset}: {row['status']}")
            errors = " | ".join(f"{100*float(row[k]):.2f}" for k in (
                "error", "velocity", "force", "energy"))
            lines.append(f"| {case.title}, {case.base} | {preset} | {errors} "
                         f"| {float(row['seconds']):.3g} | {row['steps']} |\n")
            print(lines[-1], end="", flush=True)
    (here/"presets.md").write_text(HEAD + "".join(lines))


if __name__ == "__main__":
    main()
