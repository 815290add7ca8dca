"""What the trade varies: options of the paper's scheme from the presets that it
had, each on its own, and combinations that may be worth their cost. The presets
of today are runs of their own (named)."""

# Of vertexCentred in fvSchemes, of controlDict and of contactProperties
SCHEME = ("cells", "reconstruction", "limiter", "kinematics", "jacobian",
          "waveSpeed", "dissipation")
CONTROL = ("maxCo", "timeIntegrator")
CONTACT = ("pairing", "updateDistance", "transfer")

COMMON = {"jacobian": "volumetric", "waveSpeed": "linear"}
PRESETS = {
    "fast": {"cells": "simplicial", "reconstruction": "linear",
             "limiter": "BarthJespersen", "kinematics": "FJ",
             "dissipation": "1", "maxCo": "0.8",
             "timeIntegrator": "symplecticEuler", **COMMON},
    "balanced": {"cells": "simplicial", "reconstruction": "full",
                 "limiter": "BarthJespersen", "kinematics": "FHJ",
                 "dissipation": "1", "maxCo": "0.6",
                 "timeIntegrator": "TVDRK2", **COMMON},
    "accurate": {"cells": "simplicial", "reconstruction": "full",
                 "limiter": "BarthJespersen", "kinematics": "FHJ",
                 "dissipation": "0.5", "maxCo": "0.3",
                 "timeIntegrator": "TVDRK2", **COMMON}}

# All columns that say what was run; empty where a case has no such choice
OPTIONS = ("mesh", "dimension", "material", *SCHEME, *CONTROL, *CONTACT)

# One at a time from balanced on the base mesh, where a case has the option
SINGLE = {
    "cells": ("simplicialSingle", "native"),
    "reconstruction": ("linear", "none"),
    "limiter": ("Venkatakrishnan", "none"),
    "kinematics": ("FJ", "F"),
    "jacobian": ("literal",),
    "waveSpeed": ("stretched",),
    "dissipation": ("0.25", "0.5", "0.75"),
    "maxCo": ("0.1", "0.3", "0.45", "0.8", "0.9", "1.2", "1.5", "1.8",
              "2.2"),
    "timeIntegrator": ("TVDRK3",)}
INTERVALS = ("0.02", "0.4")


# The presets of today, by name alone
NAMES = "fast", "balanced", "accurate"


def expanded(**choices):
    """All combinations of the values given."""
    found = [{}]
    for option, values in choices.items():
        found = [{**f, option: v} for f in found for v in values]
    return found


# For every case, on the base mesh
SPLIT = {"reconstruction": ("linear",), "timeIntegrator": ("symplecticEuler",)}
COMBINED = (
    expanded(reconstruction=("linear",), maxCo=("0.9",))
    + expanded(**SPLIT, maxCo=("0.6", "0.8", "1"))
    + expanded(**SPLIT, maxCo=("0.8",), dissipation=("0.5",))
    + expanded(**SPLIT, maxCo=("0.8",), cells=("simplicialSingle",))
    + expanded(reconstruction=("none",), timeIntegrator=("symplecticEuler",),
               maxCo=("0.8",))
    + expanded(timeIntegrator=("TVDRK3",), maxCo=("0.9",),
               dissipation=("1", "0.5")))

# For cases that take seconds
PRODUCT = (
    expanded(reconstruction=("linear", "full"),
             limiter=("BarthJespersen", "Venkatakrishnan", "none"),
             timeIntegrator=("TVDRK2", "TVDRK3"))
    + expanded(reconstruction=("linear",),
               limiter=("BarthJespersen", "Venkatakrishnan", "none"),
               timeIntegrator=("symplecticEuler",))
    + expanded(reconstruction=("none",),
               timeIntegrator=("TVDRK2", "TVDRK3", "symplecticEuler")))


def options(case, preset="balanced", mesh=None, **changes):
    """All options of a run, as text."""
    chosen = {**dict.fromkeys(OPTIONS, ""), **PRESETS[preset], **case.choices,
              "mesh": mesh or case.base, **changes}
    return onlyThatMatter(chosen)


def named(case, preset, mesh):
    """A run with a preset and nothing beside it."""
    return {**dict.fromkeys(OPTIONS, ""), **case.choices, "mesh": mesh,
            "preset": preset}


def onlyThatMatter(chosen):
    """The same, with what has no effect taken out, so that equal runs are
    equal here."""
    chosen = dict(chosen)
    if chosen["material"] == "linearElastic":
        chosen |= {"kinematics": "F", "jacobian": "volumetric",
                   "waveSpeed": "linear"}
    if chosen["dimension"] == "1":
        chosen["cells"] = "simplicial"
    if chosen["reconstruction"] == "none":
        chosen["limiter"] = "none"
    if chosen["pairing"] != "nearestFace":
        chosen["updateDistance"] = ""
    elif not chosen["updateDistance"]:
        chosen["updateDistance"] = "0.1"
    if chosen["pairing"] in ("", "matching"):
        chosen["transfer"] = ""
    elif not chosen["transfer"]:
        chosen["transfer"] = "conservative"
    return chosen


def variants(case):
    """All runs of a case, each once, presets first."""
    def changed(**changes):
        return options(case, **changes)

    found = [options(case, preset, mesh) for preset in ("balanced", "fast",
             "accurate") for mesh in (case.base, *case.meshes)]
    found += [changed(**{option: value}) for option, values in SINGLE.items()
              for value in values]
    found += [changed(**changes) for changes in case.more]
    if {"pairing": "nearestFace"} in case.more:
        found += [changed(pairing="nearestFace", updateDistance=interval)
                  for interval in INTERVALS]
    found += [changed(**c) for c in COMBINED]
    if case.cheap:
        found += [changed(**c) for c in PRODUCT]
    unique = {tuple(f.items()): f for f in found}
    return list(unique.values())


def presetOf(case, chosen):
    """Name of the preset that this is, on any mesh; else nothing."""
    for preset in PRESETS:
        if chosen == options(case, preset, chosen["mesh"]):
            return preset
    return ""


def label(case, chosen):
    """A preset, or what differs from balanced on the base mesh."""
    preset = presetOf(case, chosen)
    if preset:
        mesh = chosen["mesh"]
        return preset if mesh == case.base else f"{preset}, mesh {mesh}"
    base = options(case)
    return ", ".join(f"{k} {chosen[k]}" for k in OPTIONS
                     if chosen[k] and chosen[k] != base[k])
