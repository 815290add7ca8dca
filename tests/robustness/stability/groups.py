"""The groups of the map: which scene, with which parameters."""

from itertools import product

from . import free, impacts, resting

SCAN = [round(0.1*i, 1) for i in range(1, 13)]
PRESETS = "fast", "balanced", "accurate"
RECONSTRUCTIONS = "none", "linear", "full"
INTEGRATORS = {"TVDRK2": RECONSTRUCTIONS, "TVDRK3": RECONSTRUCTIONS,
               "symplecticEuler": ("none", "linear")}


def cells(**lists):
    """All combinations, as dictionaries."""
    return [dict(zip(lists, values)) for values in product(*lists.values())]


def integrators():
    return [(name, reconstruction) for name, all in INTEGRATORS.items()
            for reconstruction in all]


def presets():
    return cells(preset=PRESETS, nu=(0, 0.2, 0.3, 0.4, 0.45, 0.49, 0.499,
                                     0.4999), maxCo=SCAN)


def steps():
    return [{"reconstruction": reconstruction, "timeIntegrator": name, **more}
            for name, reconstruction in integrators()
            for more in cells(dimensions=(1, 2, 3), nu=(0.3, 0.4999), maxCo=[
                round(0.2*i, 1) for i in range(1, 21)])]


def bars():
    speeds = 0.001, 0.01, 0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 1
    return cells(cells=("40", "20x4", "40x8"),
                 waveSpeed=("linear", "stretched"), speed=speeds)


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
    """A million steps of few cells, 300000 of a body in three dimensions,
    100000 with each of the integrators."""
    rows = [(mesh, reconstruction, "TVDRK2", 10**6) for mesh, reconstruction in
            (("1x1x2", "full"), ("3x3", "full"), ("3x3", "linear"))]
    rows += [("3x3x3", reconstruction, "TVDRK2", 3*10**5)
             for reconstruction in ("linear", "full")]
    rows += [(mesh, reconstruction, name, 10**5)
             for name, reconstruction in integrators()
             for mesh in ("2", "4", "2x2", "4x4")]
    return [dict(zip(("cells", "reconstruction", "timeIntegrator", "steps"),
                     row)) for row in rows]


def rests():
    rows = [("clamp", 0, "4x4", 0.05, 2), ("clamp", 0, "2x2x2", 0.05, 2),
            ("plane", 0, "4x4", 0.05, 2), ("plane", 0, "2x2x2", 0.05, 2),
            ("plane", 0.5, "4x4", 0.05, 2)]
    rows += [("body", k, "4x4", weight, 2) for k in (0, 0.5)
             for weight in (0.05, 0.005, 0.0005)]
    rows += [("body", 0.5, "4x4", weight, ratio) for ratio in (3, 4)
             for weight in (0.05, 0.005)]
    rows += [("body", 0.5, mesh, weight, 2) for mesh in ("2x2x2", "3x3x3")
             for weight in (0.05, 0.005, 0.0005)]
    rows += [("tied", 0, "4x4", weight, ratio) for ratio in (2, 3)
             for weight in (0.05, 0.005)]
    return [{"on": on, "friction": k, "cells": mesh, "steps": 10**5,
             "weight": weight, "ratio": ratio}
            for on, k, mesh, weight, ratio in rows]


# Name: scene, its cells
GROUPS = {
    "presets": (impacts.collision, presets),
    "step": (free.step, steps),
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
    "spin": (free.spin, lambda: cells(
        cells=("3x3", "6x6", "3x3x3", "5x5x5"),
        reconstruction=RECONSTRUCTIONS, revolutions=(20,))),
    "vibration": (free.vibration, vibrations),
}


def cellsOf(group):
    """The scene of a group and the parameters of its runs."""
    scene, parameters = GROUPS[group]
    return scene, parameters()
