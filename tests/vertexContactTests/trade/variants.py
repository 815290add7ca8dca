"""The variants of the trade: the presets on all meshes, single options changed
from 'balanced' and from 'paper', and combinations that may be worth their
cost."""

# Options of vertexCentred in fvSchemes, of controlDict and of
# contactProperties
SCHEME = ("cells", "correction", "dissipation", "frontDissipation", "volume",
          "reconstruction", "limiter", "kinematics", "jacobian", "waveSpeed")
CONTROL = ("maxCo", "timeIntegrator")
CONTACT = ("pairing", "updateDistance", "transfer")

PAPER = "paper"
NAMES = "fast", "balanced", "accurate"
PRESETS = (*NAMES, PAPER)

# All columns that identify a run; empty: the value of the preset, or of the
# case
OPTIONS = ("preset", "mesh", "dimension", "material", *SCHEME, *CONTROL,
           *CONTACT)

# Single changes on the base mesh
SINGLE = {
    "balanced": {
        "cells": ("simplicialSingle", "native"),
        "correction": ("0", "0.5"),
        "dissipation": ("0.1", "0.5", "1"),
        "frontDissipation": ("0.5",),
        "volume": ("nodal", "smoothed"),
        "maxCo": ("0.2", "0.6", "0.8", "0.98")},
    PAPER: {
        "reconstruction": ("linear", "none"),
        "limiter": ("Venkatakrishnan", "none"),
        "kinematics": ("FJ", "F"),
        "jacobian": ("literal",),
        "waveSpeed": ("stretched",),
        "dissipation": ("0.25", "0.5"),
        "maxCo": ("0.3", "0.9", "1.5"),
        "timeIntegrator": ("TVDRK3",)}}

COMBINED = (
    {"cells": "simplicialSingle", "correction": "0"},
    {"cells": "native", "correction": "0"},
    {"preset": PAPER, "reconstruction": "linear", "maxCo": "0.8",
     "timeIntegrator": "symplecticEuler"},
    {"preset": PAPER, "reconstruction": "none", "maxCo": "0.8",
     "timeIntegrator": "symplecticEuler"})


def named(case, preset, mesh, **changes):
    """A run with a preset and these changes only."""
    return onlyThatMatter({
        **dict.fromkeys(OPTIONS, ""), **case.choices, "mesh": mesh,
        "preset": preset, **changes})


def onlyThatMatter(chosen):
    """The same options without those that have no effect, so that equal runs
    have equal options."""
    chosen = dict(chosen)
    if chosen["material"] == "linearElastic":
        # Its treatment of the volume is known, and it has one wave speed
        for name in "kinematics", "jacobian", "waveSpeed", "volume":
            chosen[name] = ""
    if chosen["dimension"] == "1":
        chosen["cells"] = ""
    return chosen


def variants(case):
    """All runs of a case, each once, presets first."""
    found = [named(case, preset, mesh) for preset in PRESETS
             for mesh in (case.base, *case.meshes)]
    found += [named(case, preset, case.base, **{option: value})
              for preset, single in SINGLE.items()
              for option, values in single.items() for value in values]
    found += [named(case, "balanced", mesh) for mesh in case.conforming]
    for changes in (*case.more, *COMBINED):
        found.append(named(case, **{"preset": "balanced", "mesh": case.base,
                                    **changes}))
    unique = {tuple(f.items()): f for f in found}
    return list(unique.values())


def label(case, chosen):
    """The preset, the mesh if it is not the base mesh, and the other
    choices."""
    usual = named(case, chosen["preset"], case.base)
    parts = [chosen["preset"]] + [
        f"{k} {chosen[k]}" for k in OPTIONS[1:]
        if chosen[k] and chosen[k] != usual[k]]
    return ", ".join(parts)


def isPreset(case, chosen):
    """Whether a run has only a preset, on a mesh of the case."""
    return chosen == named(case, chosen["preset"], chosen["mesh"]) \
        and chosen["mesh"] in (case.base, *case.meshes)
