#!/usr/bin/env python3
"""What each feature costs in time and memory, on against off.

    . etc/bashrc; tests/benchmark/features.py [-before CHECKOUT]

One core, fixed step; medians of seven runs, and of the ratios of runs next to
each other, since a machine is faster at one time than at another. Writes
features.md beside this file. With -before its last table only: the steps of
scenes that use none of them, with this library and with that of a checkout
from before they were there, which is built.
"""

import argparse
import re
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from vertexContactTests.caseTools import checked, root
from vertexContactTests.smallCases import (Body, SmallCase, condition, coulomb,
                                           interface)

here = Path(__file__).resolve().parent

STEPS = 40
NEO = {"type": "neoHookean", "rho": 1, "E": 1, "nu": 0.3}
PLASTIC = {**NEO, "type": "HenckyVonMises"}
YIELDING = {**PLASTIC, "tauY": 1e-9, "Hardening": 0.1}
SMALL = {**NEO, "type": "linearElastic"}
HEATED = {**YIELDING, "adiabaticHeating": {"cp": 400, "T0": 300}}
COOK = {k: HEATED[k] for k in HEATED if k not in ("tauY", "Hardening")}
HARDENS = {"A": 1e-9, "B": 0.1, "n": 1, "C": 0, "referenceRate": 1}
SOFTENS = {**HARDENS, "m": 1, "Tmelt": 1800}
RIGID = {"type": "rigid", "rho": 1}
HELD = {"left": condition("fixedVelocity", velocity=(0, 0, 0))}


def block(folder, cells, material=None, control=None, functions=None,
          size=(1, 1, 1), sides=None, split=None, stretch=None, mapped=False,
          **scheme):
    if split:
        scheme["cells"] = split
    d = len(cells)
    rate = np.diag((0.1, -0.05, -0.05))
    body = Body(cells=cells, material=material or NEO, size=size,
                velocity=lambda X: (X - 0.5) @ rate, scheme=scheme,
                sides=sides or {})
    case = SmallCase(folder, body, 1, control={
        "preset": "balanced", "deltaT": 0.05/max(cells), "adjustTimeStep": "no",
        "writeControl": "none", "timePrecision": 12,
        **({} if functions else {"functions": {}}), **(control or {})})
    if stretch is not None:
        case.writePointField(
            body, "F0", "[0 0 0 0 0 0 0]",
            np.tile(np.diag(stretch).ravel(), (len(case.X()), 1)),
            kind="tensor")
    if mapped:
        source = block(folder/"source", cells, material, control, functions,
                       size, sides)
        checked(["mapState", str(source.path)], case.path)
    return case


def history(name, **more):
    """A function object that writes a row at each step."""
    return {"functions": {name: {
        "type": name, "libs": "(vertexContact)", "writeControl": "timeStep",
        "writeInterval": 1, **more}}}


def paper(folder, **arguments):
    return block(folder, control={"preset": "paper"}, **arguments)


def pair(folder, gap, pairing="nearestFace", law="frictionless", speed=0.02,
         contact=True, above=NEO, control=None):
    """Two blocks; their meshes match."""
    def body(name, start, velocity, side):
        return Body(cells=(20, 20, 20), name=name, start=start,
                    material=above if name == "above" else NEO,
                    velocity=velocity, sides={side: "contact"} if contact else
                    {})
    bodies = (body("below", (0, 0, 0), (0.01, speed, 0), "top"),
              body("above", (0, 1 + gap, 0), (-0.01, -speed, 0), "bottom"))
    interfaces = {"contact": interface(("below", "top"), ("above", "bottom"),
                                       law, pairing=pairing)}
    return SmallCase(folder, bodies, 1, interfaces if contact else None,
                     control={
                         "preset": "balanced", "deltaT": 0.0025,
                         "adjustTimeStep": "no", "functions": {},
                         "writeControl": "none", "timePrecision": 12,
                         **(control or {})})


def ratio(folder, own):
    """Two blocks in contact whose wave speeds are 1:20; a tenth of the nodes
    is stiff. The common step is 0.8 of the stable step of the soft block."""
    def body(name, start, height, n, material, side, velocity):
        return Body(cells=(20, 20, n), name=name, start=start,
                    size=(1, 1, height), material=material,
                    velocity=(0, 0, velocity), sides={side: "contact"})
    bodies = (body("soft", (0, 0, 0), 1, 20, NEO, "front", 0.01),
              body("stiff", (0, 0, 1), 0.05, 1, {**NEO, "E": 400}, "back",
                   -0.01))
    deltaT = 0.015
    case = SmallCase(folder, bodies, 1, {"contact": interface(
        ("soft", "front"), ("stiff", "back"), pairing="matching")}, control={
            "preset": "balanced", "deltaT": deltaT if own else deltaT/20,
            "adjustTimeStep": "no", "maxCo": 0.9,
            "subCycling": "yes" if own else "no",
            "functions": {}, "writeControl": "none", "timePrecision": 12})
    case.stepsOfTime = 1 if own else 20
    return case


# Group, feature, the function that makes the case, and its arguments with the
# feature on and off
CELLS = {"cells": (24,)*3}
MIRRORS = {side: {"type": "symmetryPlane"}
           for side in ("bottom", "top", "back", "front")}
FREE = {"gap": 0.1, "contact": False}
PAIRS = (
    ("scheme", "correction 1/3 (default) against 0", block,
     {**CELLS, "correction": 0}, CELLS),
    ("scheme", "volume smoothed against nodal (default with nu 0.3)", block,
     CELLS, {**CELLS, "volume": "smoothed"}),
    ("scheme", "cells simplicial (default) against simplicialSingle", block,
     {**CELLS, "split": "simplicialSingle"}, CELLS),
    ("scheme", "preset paper against balanced", block,
     CELLS, {**CELLS, "control": {"preset": "paper"}}),
    ("strain", "finite against small", block,
     {**CELLS, "material": SMALL}, CELLS),
    ("paper", "limiter Barth-Jespersen against none", paper,
     {**CELLS, "limiter": "none"}, CELLS),
    ("paper", "reconstruction linear against none", paper,
     {**CELLS, "reconstruction": "none"},
     {**CELLS, "reconstruction": "linear"}),
    ("paper", "reconstruction full (default) against linear", paper,
     {**CELLS, "reconstruction": "linear"}, CELLS),
    ("paper", "H and J solved against F alone", paper,
     {**CELLS, "kinematics": "F"}, CELLS),
    ("plasticity", "no node yields against neo-Hookean", block,
     CELLS, {**CELLS, "material": {**PLASTIC, "tauY": 1e3}}),
    ("plasticity", "every node yields against neo-Hookean", block,
     CELLS, {**CELLS, "material": YIELDING}),
    ("plasticity", "adiabaticHeating against none, every node yields", block,
     {**CELLS, "material": YIELDING}, {**CELLS, "material": HEATED}),
    ("plasticity", "Johnson-Cook with m against without, every node yields",
     block,
     {**CELLS, "material": {**COOK, "JohnsonCook": HARDENS}},
     {**CELLS, "material": {**COOK, "JohnsonCook": SOFTENS}}),
    ("start", "mapState of the same state against fields", block,
     CELLS, {**CELLS, "mapped": True}),
    ("start", "initial stretch F0 against none", block,
     CELLS, {**CELLS, "stretch": (1.01, 1, 1)}),
    ("start", "initial stretch F0 against none, plasticity", block,
     {**CELLS, "material": {**PLASTIC, "tauY": 1e3}},
     {**CELLS, "material": {**PLASTIC, "tauY": 1e3}, "stretch": (1.01, 1, 1)}),
    ("motion", "a side held against free", block,
     CELLS, {**CELLS, "sides": HELD}),
    ("motion", "a side held in one direction against all", block,
     {**CELLS, "sides": HELD},
     {**CELLS, "sides": {"left": {**HELD["left"], "components": "(x)"}}}),
    ("motion", "a side held along (1 1 0) against all", block,
     {**CELLS, "sides": HELD},
     {**CELLS, "sides": {"left": condition(
         "fixedVelocity", velocity=0, direction=(1, 1, 0))}}),
    ("energies", "solidEnergies each step against none", block,
     CELLS, {**CELLS, "functions": True}),
    ("energies", "maxEnergyRise against none", block,
     CELLS, {**CELLS, "control": {"maxEnergyRise": 1}}),
    ("histories", "reactionForces each step against none", block,
     {**CELLS, "sides": HELD},
     {**CELLS, "sides": HELD, "control": history("reactionForces")}),
    ("histories", "solidExtremes of pointD.x each step against none", block,
     CELLS, {**CELLS, "control": history(
         "solidExtremes", fields="(pointD.x)")}),
    ("histories", "solidAverages of pointD.x each step against none", block,
     CELLS, {**CELLS, "control": history(
         "solidAverages", fields="(pointD.x)")}),
    ("histories", "contactForces each step against none, in contact", pair,
     {"gap": 0}, {"gap": 0, "control": history("contactForces")}),
    ("histories", "contactForces with a filter against none", pair,
     {"gap": 0, "control": history("contactForces")},
     {"gap": 0, "control": history("contactForces", filterFrequency=10)}),
    ("contact", "nearestFace, 10 lengths apart, against free bodies", pair,
     {"gap": 10, "contact": False}, {"gap": 10}),
    ("contact", "nearestFace, near, against free bodies", pair,
     {**FREE, "speed": 0}, {"gap": 0.1, "speed": 0}),
    ("contact", "nearestFace, in contact, against free bodies", pair,
     FREE, {"gap": 0}),
    ("contact", "AMI, in contact, against free bodies", pair,
     FREE, {"gap": 0, "pairing": "AMI"}),
    ("contact", "matching, in contact, against free bodies", pair,
     FREE, {"gap": 0, "pairing": "matching"}),
    ("contact", "Coulomb friction against frictionless, matching", pair,
     {"gap": 0, "pairing": "matching"},
     {"gap": 0, "pairing": "matching", "law": coulomb(0.3)}),
    ("contact", "one of two blocks in contact rigid against both deform", pair,
     {"gap": 0}, {"gap": 0, "above": RIGID}),
    ("contact", "a rigid block driven by a force against a free one", pair,
     {"gap": 0, "above": RIGID},
     {"gap": 0, "above": {**RIGID, "freeTranslation": "(y)",
                          "force": (0, -0.1, 0)}}),
    ("steps", "subCycling, speeds of waves 1:20, a tenth stiff, against one "
     "step; a common step", ratio, {"own": False}, {"own": True}),
    ("slow loading", "massScaling against none, the same step", block,
     CELLS, {**CELLS, "control": {
         "massScaling": {"body": {"factor": 1.04}}}}),
    ("slow loading", "damping against none", block,
     CELLS, {**CELLS, "control": {"damping": {"body": {"coefficient": 1}}}}),
    ("slow loading", "relaxation against none", block,
     CELLS, {**CELLS, "control": {
         "relaxation": {"type": "kinetic", "tolerance": 1e-9}}}),
    ("dimension", "one layer of 3D against the same in 2D", block,
     {"cells": (100, 100)},
     {"cells": (100, 100, 1), "size": (1, 1, 0.01),
      "sides": {k: MIRRORS[k] for k in ("back", "front")}}),
    ("dimension", "one row of 2D against the same in 1D", block,
     {"cells": (10000,)},
     {"cells": (10000, 1), "size": (1, 1e-4, 1),
      "sides": {k: MIRRORS[k] for k in ("bottom", "top")}}),
)


def bytesOf(log):
    """Bytes of all regions. A line that a region has in common with another one
    is only there once."""
    found = {}
    for region in log.split("\nRegion ")[1:]:
        text = region.split("\n\n")[0]
        name, _, like = text.split("\n")[0].partition(", ")
        of = dict(found.get(like.split(" ")[-1], {}))
        for key, what in (("nodes", r"(\d+) nodes,"),
                          ("bytes", r"\n    (\d+) bytes per node")):
            if match := re.search(what, text):
                of[key] = int(match[1])
        found[name] = of
    return sum(of["nodes"]*of["bytes"] for of in found.values())


class Measured:
    """A case that runs again and again, with the time of its steps and its
    memory."""

    def __init__(self, case):
        self.case = case
        deltaT = float(re.search(r"deltaT\s+(\S+);", (
            case/"system/controlDict").read_text())[1])
        # Compared cases run for the same time
        steps = STEPS*getattr(case, "stepsOfTime", 1)
        case.set("system/controlDict", {"endTime": (steps + 0.5)*deltaT})
        self.seconds = []

    def run(self, checkout=root):
        log = checked(["vertexContactFoam"] if checkout == root else [
            "env", "-u", "VERTEXCONTACT_DIR", "bash", "-c",
            f". {checkout}/etc/bashrc && exec vertexContactFoam"],
            self.case.path)
        self.seconds.append(float(
            re.search(r"Steps: \d+ in (\S+) s", log)[1]))
        self.bytes = bytesOf(log)


# Scenes without the features that came after the commit that -before names
PLAIN = (
    ("one block, neo-Hookean", block, CELLS),
    ("one block, small strains", block, {**CELLS, "material": SMALL}),
    ("one block, every node yields", block, {**CELLS, "material": YIELDING}),
    ("one block in 2D", block, {"cells": (100, 100)}),
    ("two blocks, nearestFace, in contact", pair, {"gap": 0}),
    ("two blocks, AMI, in contact", pair, {"gap": 0, "pairing": "AMI"}),
    ("two blocks, friction, matching", pair, {
        "gap": 0, "pairing": "matching", "law": coulomb(0.3)}),
)
PAGE = here/"features.md"
LAST = "\n## With all of them off\n"


def commitOf(checkout):
    return subprocess.run(
        ["git", "describe", "--always", "--dirty"], cwd=checkout,
        capture_output=True, text=True).stdout.strip() or "no repository"


def before(checkout):
    lines = []
    with tempfile.TemporaryDirectory() as folder:
        for i, (what, make, arguments) in enumerate(PLAIN):
            now, then = (
                Measured(make(Path(folder)/f"{i}{name}", **arguments))
                for name in ("now", "then"))
            for _ in range(9):
                now.run()
                then.run(checkout)
            lines.append(
                f"| {what} | {1e3*np.median(then.seconds)/STEPS:.2f} | "
                f"{1e3*np.median(now.seconds)/STEPS:.2f} | "
                f"{np.median(np.divide(now.seconds, then.seconds)):.2f} |")
            print(lines[-1], flush=True)
    PAGE.write_text(PAGE.read_text().split(LAST)[0] + LAST + f"""
The same scenes with the library of {commitOf(checkout)}, which had neither rigid regions, steps of their own, slow loading, conditions by
component, histories of sets, filters, initial states nor heat, and with that of {commitOf(root)}; medians of nine runs in turns.

| | before [ms a step] | now [ms a step] | now/before |
|---|---|---|---|
""" + "\n".join(lines) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("-before", type=Path, metavar="CHECKOUT")
    checkout = parser.parse_args().before
    if checkout:
        before(checkout.resolve())
        return
    lines = []
    with tempfile.TemporaryDirectory() as folder:
        for i, (group, what, make, off, on) in enumerate(PAIRS):
            cases = [Measured(make(Path(folder)/f"{i}{name}", **arguments))
                     for name, arguments in (("off", off), ("on", on))]
            for _ in range(7):
                for case in cases:
                    case.run()
            without, with_ = cases
            ratios = np.divide(with_.seconds, without.seconds)
            lines.append(
                f"| {group} | {what} | "
                f"{1e3*np.median(without.seconds)/STEPS:.2f} | "
                f"{1e3*np.median(with_.seconds)/STEPS:.2f} | "
                f"{np.median(ratios):.2f} | "
                f"{with_.bytes/without.bytes:.2f} |")
            print(lines[-1], flush=True)
    last = PAGE.read_text().partition(LAST) if PAGE.exists() else ("", "", "")
    PAGE.write_text(f"""# What each feature costs

Written by `tests/benchmark/features.py`: blocks of 24 x 24 x 24 hexahedra (two of 20 x 20 x 20 for contact), neo-Hookean,
defaults, one core, {STEPS} steps, with the library of {commitOf(root)}; medians of seven runs, and of the ratios of runs in turns. Memory: what the body stores and its dual mesh, without OpenFOAM's mesh.

| | | off [ms a step] | on [ms a step] | time, on/off | memory, on/off |
|---|---|---|---|---|---|
""" + "\n".join(lines) + "\n" + "".join(last[1:]))


if __name__ == "__main__":
    main()
