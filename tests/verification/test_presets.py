"""The presets in all cases of the trade. 'fast' takes longer steps than
'balanced' and is as accurate in solid bodies, but not at fronts in one
dimension. No preset is worse than its row of trade.csv by a tenth. Each preset
equals the options that it sets."""

import pytest

from vertexContactTests.trade.calibration import Calibration
from vertexContactTests.trade.cases import CASES, entry
from vertexContactTests.trade.rows import measure, tradeTable
from vertexContactTests.trade.variants import NAMES, PAPER, named

# The cases of the trade, on the coarsest meshes on which the ranking holds
MESHES = {"similar": "128", "dissimilar": "128", "rings": "5",
          "incompressible": "8", "nonMatching": "1", "taylor": "2"}

# Options that the presets set, in vertexCentred and in controlDict
SCHEME = {"cells": "simplicial", "dissipation": "0.25",
          "correction": f"{1/3:.17g}", "volume": "automatic"}
WRITTEN = {
    "fast": ({**SCHEME, "frontDissipation": "0.25"}, {"maxCo": "0.9"}),
    "balanced": ({**SCHEME, "frontDissipation": "1"}, {"maxCo": "0.9"}),
    "accurate": ({**SCHEME, "frontDissipation": "1"}, {"maxCo": "0.45"}),
    PAPER: ({"cells": "simplicial", "reconstruction": "full",
             "limiter": "BarthJespersen", "kinematics": "FHJ",
             "jacobian": "volumetric", "waveSpeed": "linear",
             "dissipation": "1"},
            {"maxCo": "0.6", "timeIntegrator": "TVDRK2"})}


@pytest.fixture(scope="module")
def calibration():
    return Calibration()


@pytest.mark.parametrize("name", MESHES)
def test_ranking(name, calibration, figures):
    """Steps are asserted, but not costs: times depend on the machine."""
    case, table = CASES[name], tradeTable()
    rows = {preset: measure(case, named(case, preset, MESHES[name]),
                            calibration) for preset in NAMES}
    assert all(row["status"] == "done" for row in rows.values()), rows
    error, steps, rise = (
        {preset: float(row[what]) for preset, row in rows.items()}
        for what in ("error", "steps", "rise"))
    with figures(f"presets, {case.title}") as f:
        if case.choices.get("dimension") == "1":
            f.atMost("error of balanced / fast",
                     error["balanced"]/error["fast"], 1)
        else:
            f.atMost("error of fast / balanced",
                     error["fast"]/error["balanced"], 1.04)
        f.atMost("error of accurate / balanced",
                 error["accurate"]/error["balanced"], 1.2)
        f.atMost("steps of fast / balanced", steps["fast"]/steps["balanced"],
                 0.86)
        f.atMost("steps of balanced / accurate",
                 steps["balanced"]/steps["accurate"], 0.51)
        for preset in NAMES:
            f.atMost(f"{preset}: largest rise of the energy / initial",
                     rise[preset], 1e-3)
            row = table.rows[name, *named(case, preset, MESHES[name]).values()]
            f.atMost(f"{preset}: error / that of the trade",
                     error[preset]/float(row["error"]), 1.1)


def runs(case, folder, preset, scheme, control):
    """Runs with a preset and additional options."""
    made = case.prepare(folder, named(case, preset, "4"))
    made.set("system/controlDict",
             {k: entry(v) for k, v in control.items()})
    for region in made.regions:
        made.set(f"system/{region}/fvSchemes", {
            f"vertexCentred/{k}": entry(v) for k, v in scheme.items()})
    return case.start(made, preset, "4")


@pytest.mark.parametrize("preset", WRITTEN)
def test_same_as_options(preset, tmp_path, figures):
    """The keyword 'preset' equals these options, which have precedence over
    those of another preset."""
    case = CASES["incompressible"]
    alone = runs(case, tmp_path/"alone", preset, {}, {})
    # The other scheme has other options: only its own preset accepts them
    other = {"accurate": "fast", PAPER: PAPER}.get(preset, "accurate")
    written = runs(case, tmp_path/"written", other, *WRITTEN[preset])
    with figures(f"preset {preset} against its options") as f:
        f.equal("steps", len(alone.totalEnergy), len(written.totalEnergy))
        f.equal("energy at the end [J]", alone.totalEnergy[-1],
                written.totalEnergy[-1])
