"""The groups of the map: which scene, with which parameters."""

from itertools import product

from vertexContactTests.caseTools import PRESET

from . import free, impacts, resting

SCAN = [round(0.1*i, 1) for i in range(1, 13)]
PRESETS = "fast", "balanced", "accurate"
CELLS = "simplicial", "simplicialSingle", "native"
RECONSTRUCTIONS = "full", "linear", "none"


def cells(**lists):
    """All combinations of the parameters, as dictionaries."""
    return [dict(zip(lists, values)) for values in product(*lists.values())]


def presets():
    return cells(preset=PRESETS, nu=(0, 0.2, 0.3, 0.4, 0.45, 0.49, 0.499,
                                     0.4999), maxCo=SCAN)


def steps():
    """In one dimension all cell options are the same."""
    share = 0.9, 1, 1.05, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.8, 2
    scan = cells(nu=(0.3, 0.4999), stretch=(1, 0.6, 1.6), maxCo=share)
    return [{"dimensions": d, "scheme": {"cells": kind, "correction": c},
             **more}
            for d in (1, 2, 3) for kind in (CELLS if d > 1 else CELLS[:1])
            for c in (1/3, 0) for more in scan]


def paperSteps():
    return [{"scheme": {"reconstruction": r}, "preset": PRESET, **more}
            for r in RECONSTRUCTIONS[:2]
            for more in cells(dimensions=(1, 2, 3), nu=(0.3, 0.4999), maxCo=[
                round(0.2 + 0.4*i, 1) for i in range(1, 10)])]


def bars():
    return cells(cells=("40", "20x4", "40x8"), speed=(
        0.001, 0.01, 0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 1, 1.2))


def impedances():
    ratios = 1, 10, 100, 1000, 10000, 100000, 1000000
    return (cells(dimensions=(1, 2), by=("both", "rho"), ratio=ratios)
            + cells(dimensions=(1,), by=("E",), ratio=ratios))


def faces():
    return cells(dimensions=(2, 3), pairing=("AMI", "nearestFace"),
                 ratio=(1, 2, 4, 8, 16, 32, 64))


def gaps():
    return cells(dimensions=(1, 2), pairing=impacts.PAIRINGS, cell=(
        -0.05, -0.01, 0, 1e-4, 0.01, 0.1, 1, 10))


def aspects():
    return [{"dimensions": d, "shape": shape, "ratio": ratio}
            for d, shape in ((2, "plates"), (3, "plates"), (3, "needles"))
            for ratio in (1, 3, 10, 30, 100)]


def vibrations():
    """A million steps of few cells; fewer steps for expensive cases, and for
    bodies with one or two cells across, which vibrate for ever."""
    rows = [(mesh, 0.3, preset, 10**5) for preset in PRESETS
            for mesh in ("1", "2", "1x2", "2x2")]
    rows += [(mesh, 0.3, "balanced", 10**5) for mesh in ("1x1x1", "2x2x2")]
    rows += [(mesh, 0.3, "balanced", 10**6)
             for mesh in ("3", "4", "1x8", "2x3", "3x3", "4x4")]
    rows += [(mesh, 0.3, "fast", 10**6) for mesh in ("4", "3x3")]
    rows += [("4x4", 0.4999, "balanced", 10**5)]
    rows += [(mesh, 0.3, preset, 10**5) for preset in PRESETS[:2]
             for mesh in ("2x2x4", "3x3x3")]
    rows += [("3x3x3", 0.4999, "balanced", 3*10**4)]
    return [dict(zip(("cells", "nu", "preset", "steps"), row)) for row in rows]


def spins():
    rows = [("3x3", preset, 10**6) for preset in PRESETS[:2]]
    rows += [("6x6", "balanced", 3*10**5), ("3x3x3", "balanced", 3*10**5),
             ("3x3x3", "fast", 10**5), ("5x5x5", "balanced", 3*10**4)]
    return [dict(zip(("cells", "preset", "steps"), row)) for row in rows]


def rests():
    """A million steps each. The cells of the base have 1 to 1/4 of the length
    of the block's cells. There are two weights, relative to Young's
    modulus."""
    weights = 0.05, 0.005
    rows = [("plane", 0.5, "2x2", 1, 0.05)]
    rows += [("plane", k, "4x4", 1, weight) for k in (0, 0.5)
             for weight in weights]
    rows += [("body", 0.5, "4x4", ratio, weight)
             for ratio in (1, 1.5, 2, 3, 4) for weight in weights]
    rows += [("tied", 0, "4x4", ratio, weight) for ratio in (1, 2, 3, 4)
             for weight in weights]
    rows += [("body", 0, "4x4", ratio, weight) for ratio in (1, 2, 4)
             for weight in weights]
    rows += [("plane", k, "2x2x2", 1, weight) for k in (0, 0.5)
             for weight in weights]
    rows += [("body", 0.5, "2x2x2", ratio, weight) for ratio in (1, 2)
             for weight in weights]
    rows += [("tied", 0, "2x2x2", 2, weight) for weight in weights]
    rows += [(on, k, "2x2x2", 4, 0.05) for on, k in (("body", 0.5),
                                                     ("tied", 0))]
    return [dict(zip(("on", "friction", "cells", "ratio", "weight", "steps"),
                     (*row, 10**6))) for row in rows]


def helpedRests():
    """Cases that do not come to rest by themselves within a million steps; and
    blocks on slopes of half and, for light blocks, nine tenths of the angle of
    friction. A heavy block would dig in and slip."""
    weights = 0.05, 0.005
    rows = [(on, k, ratio, weight, 0)
            for on, k, ratio in (("body", 0.5, 4), ("tied", 0, 4),
                                 ("body", 0, 1), ("body", 0, 2), ("body", 0, 4))
            for weight in weights]
    rows += [("plane", 0.5, 1, 0.05, slope) for slope in (0.5, 0.9)]
    rows += [("body", 0.5, ratio, weight, slope) for ratio in (1, 2)
             for slope, weight in ((0.5, 0.05), (0.5, 0.005), (0.9, 0.005))]
    return [{"on": on, "friction": k, "cells": "4x4", "ratio": ratio,
             "weight": weight, "slope": slope, "steps": 10**6}
            for on, k, ratio, weight, slope in rows]


# Name: scene, its cells
GROUPS = {
    "presets": (impacts.collision, presets),
    "step": (free.step, steps),
    "release": (free.release, lambda: cells(
        dimensions=(2, 3), cells=CELLS, preset=PRESETS[:2],
        stretch=(0.6, 1.6), nu=(0.3, 0.45, 0.49, 0.499, 0.4999))),
    "mach": (impacts.mach, bars),
    "impedance": (impacts.impedance, impedances),
    "faces": (impacts.faces, faces),
    "pressure": (impacts.pressed, faces),
    "gap": (impacts.gap, gaps),
    "slivers": (free.sliver, lambda: cells(
        kind=tuple(free.SLIVERS), angle=(20, 10, 5, 2, 1, 0.5))),
    "aspect": (free.aspect, aspects),
    "units": (impacts.units, lambda: cells(
        pairing=impacts.PAIRINGS, units=tuple(impacts.UNITS)[1:])),
    "single": (impacts.single, lambda: cells(
        dimensions=(1, 2, 3), pairing=impacts.PAIRINGS)),
    "cradle": (impacts.cradle, lambda: cells(
        dimensions=(1, 2), gap=(0, 0.01, 0.1))),
    "friction": (resting.friction, lambda: cells(
        on=("plane", "body"), coefficient=(0, 0.1, 0.3, 1, 3, 10))),
    "settling": (resting.settling, rests),
    "resting": (resting.resting, helpedRests),
    "spin": (free.spin, spins),
    "vibration": (free.vibration, vibrations),
    "paper": (impacts.paper, lambda: cells(
        scene=tuple(impacts.PAPER), reconstruction=RECONSTRUCTIONS)),
    "paperStep": (free.step, paperSteps),
}


def cellsOf(group):
    """The scene of a group and the parameters of its runs."""
    scene, parameters = GROUPS[group]
    return scene, parameters()
