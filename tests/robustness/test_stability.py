"""The claims of the stability map (stability.md): a part of its scenes, in a
minute, with the default scheme; impacts also with the paper's scheme. Bodies
that rest or rotate for long are also in
tests/verification/test_variational.py."""

import pytest

from vertexContactTests.stability.free import (aspect, release, sliver, spin,
                                               step, vibration)
from vertexContactTests.stability.impacts import (PAPER, collision, cradle,
                                                  faces, gap, impedance, mach,
                                                  paper, pressed, single,
                                                  units)
from vertexContactTests.stability.judge import STABLE
from vertexContactTests.stability.resting import friction, settling

SCENES = {
    **{f"nu {nu}": (collision, {"nu": nu}) for nu in (0.3, 0.4999)},
    **{f"nu 0.4999, {preset}": (collision, {"nu": 0.4999, "preset": preset})
       for preset in ("fast", "accurate")},
    "nu 0.3, stable step": (collision, {"nu": 0.3, "maxCo": 1}),
    **{f"step {maxCo}, {cells}, {stretch}": (step, {
        "dimensions": 3, "nu": 0.4999, "maxCo": maxCo, "stretch": stretch,
        "scheme": {"cells": cells}})
        for maxCo, cells, stretch in ((1.2, "simplicial", 1),
                                      (1, "simplicialSingle", 0.6),
                                      (1, "native", 1.6))},
    **{f"release, nu {nu}": (release, {
        "dimensions": 2, "cells": "simplicial", "nu": nu, "stretch": 0.6})
        for nu in (0.3, 0.499)},
    **{f"Mach {speed}, {cells}": (mach, {"cells": cells, "speed": speed})
       for cells, speed in (("40", 0.001), ("40", 1.2), ("20x4", 0.001),
                            ("20x4", 1))},
    **{f"impedance 1e6 by {by}, {d}D": (impedance, {
        "dimensions": d, "by": by, "ratio": 1e6})
        for d, by in ((1, "both"), (1, "rho"), (1, "E"), (2, "both"))},
    **{f"faces 1:64, {d}D, {pairing}": (faces, {
        "dimensions": d, "pairing": pairing, "ratio": 64})
        for d in (2, 3) for pairing in ("AMI", "nearestFace")},
    **{f"pressure across 1:64, {d}D, {pairing}": (pressed, {
        "dimensions": d, "pairing": pairing, "ratio": 64})
        for d in (2, 3) for pairing in ("AMI", "nearestFace")},
    **{f"gap of {cell} cells, {pairing}": (gap, {
        "dimensions": 2, "pairing": pairing, "cell": cell})
        for cell, pairing in ((-0.01, "matching"), (-0.01, "nearestFace"),
                              (0, "AMI"), (10, "AMI"), (10, "nearestFace"))},
    **{f"dihedral angle 0.5 degrees, {kind}": (sliver, {
        "kind": kind, "angle": 0.5}) for kind in ("layer", "node")},
    **{f"aspect ratio 100, {d}D": (aspect, {
        "dimensions": d, "shape": "plates", "ratio": 100}) for d in (2, 3)},
    **{f"units {name}, {pairing}": (units, {"pairing": pairing, "units": name})
       for name, pairing in (("Pa mm", "nearestFace"), ("GPa km", "AMI"))},
    **{f"one cell, {d}D": (single, {"dimensions": d, "pairing": "matching"})
       for d in (1, 2, 3)},
    "ten bodies in a row": (cradle, {"dimensions": 1, "gap": 0}),
    "friction 10": (friction, {"on": "plane", "coefficient": 10}),
    "rest on a plane": (settling, {
        "on": "plane", "friction": 0.5, "cells": "2x2", "ratio": 1,
        "weight": 0.05, "steps": 100000}),
    "rest on a body": (settling, {
        "on": "body", "friction": 0.5, "cells": "2x2", "ratio": 2,
        "weight": 0.05, "steps": 100000}),
    "spin": (spin, {"cells": "3x3", "steps": 20000}),
    "vibration": (vibration, {"cells": "3x3", "steps": 100000})}


def check(folder, figures, name, scene, parameters):
    result = scene(folder, **parameters)
    with figures(f"stability, {name}") as f:
        for figure, (value, least, most) in result.figures.items():
            if most is not None:
                f.atMost(figure, value, most)
            if least:
                f.atLeast(figure, value, least)
        f.equal("outcome", f"{result.outcome} {result.why}".strip(), STABLE)


@pytest.mark.parametrize("name", SCENES)
def test_default(tmp_path, figures, name):
    check(tmp_path/"case", figures, name, *SCENES[name])


def test_two_cells(tmp_path, figures):
    """Vibrations without dissipation. A step that followed the deformation
    would feed them energy (recentLeast)."""
    check(tmp_path/"case", figures, "vibration of 2 x 2 cells", vibration,
          {"cells": "2x2", "steps": 20000, "preset": "accurate"})


@pytest.mark.parametrize("reconstruction", ("full", "linear"))
@pytest.mark.parametrize("name", [name for name in PAPER
                                  if name.startswith(("bars", "faces"))])
def test_paper(tmp_path, figures, name, reconstruction):
    check(tmp_path/"case", figures, f"{name}, paper, {reconstruction}", paper,
          {"scene": name, "reconstruction": reconstruction})
