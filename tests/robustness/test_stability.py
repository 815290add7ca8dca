"""What the stability map (stability.md) says: a part of its scenes, in a
minute; those beyond the paper's scheme with the default one. Bodies that rest
or turn for long are in tests/verification/test_variational.py."""

import pytest

from stability import judge
from stability.free import aspect, sliver, vibration
from stability.impacts import (collision, cradle, faces, gap, impedance, mach,
                               pressed, single, units)
from stability.judge import STABLE
from stability.resting import friction

from caseTools import DEFAULT

SCENES = {
    **{f"nu {nu}": (collision, {"nu": nu}) for nu in (0.4, 0.4999)},
    **{f"nu 0.4999, {preset}": (collision, {"nu": 0.4999, "preset": preset})
       for preset in ("fast", "accurate")},
    **{f"Mach {speed}, {cells}": (mach, {
        "cells": cells, "waveSpeed": "linear", "speed": speed})
        for cells, speed in (("40", 0.001), ("20x4", 0.001))},
    **{f"impedance 1e6 by {by}, {d}D": (impedance, {
        "dimensions": d, "by": by, "ratio": 1e6})
        for d, by in ((1, "both"), (1, "rho"), (1, "E"), (2, "both"))},
    **{f"faces 1:64, {pairing}": (faces, {
        "dimensions": 2, "pairing": pairing, "ratio": 64})
        for pairing in ("AMI", "nearestFace")},
    **{f"pressure across 1:64, {d}D, {pairing}": (pressed, {
        "dimensions": d, "pairing": pairing, "ratio": 64})
        for d in (2, 3) for pairing in ("AMI", "nearestFace")},
    **{f"gap of {cell} cells, {pairing}": (gap, {
        "dimensions": 2, "pairing": pairing, "cell": cell})
        for cell, pairing in ((-0.05, "matching"), (-0.05, "nearestFace"),
                              (0, "AMI"), (10, "AMI"), (10, "nearestFace"))},
    **{f"dihedral angle 0.5 degrees, {kind}": (sliver, {
        "kind": kind, "angle": 0.5}) for kind in ("layer", "node")},
    **{f"aspect ratio 100, {d}D": (aspect, {
        "dimensions": d, "shape": "plates", "ratio": 100}) for d in (2, 3)},
    **{f"units {name}, {pairing}": (units, {"pairing": pairing, "units": name})
       for name, pairing in (("Pa mm", "nearestFace"), ("GPa km", "AMI"))},
    **{f"one cell, {d}D": (single, {"dimensions": d, "pairing": "matching"})
       for d in (2, 3)},
    "ten bodies in a row": (cradle, {"dimensions": 1, "gap": 0}),
    "vibration": (vibration, {
        "cells": "4x4", "reconstruction": "full", "timeIntegrator": "TVDRK2",
        "steps": 20000})}


# Beyond the paper's scheme
OF_DEFAULT = {
    **{f"Mach {speed}, {cells}": (mach, {
        "cells": cells, "waveSpeed": "linear", "speed": speed})
        for cells, speed in (("40", 1), ("20x4", 0.5))},
    "friction 10": (friction, {"on": "plane", "coefficient": 10})}


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
def test_paper(tmp_path, figures, name):
    check(tmp_path/"case", figures, name, *SCENES[name])


@pytest.mark.parametrize("name", OF_DEFAULT)
def test_default(tmp_path, figures, monkeypatch, name):
    monkeypatch.setattr(judge, "preset", DEFAULT)
    check(tmp_path/"case", figures, f"{name}, default", *OF_DEFAULT[name])
