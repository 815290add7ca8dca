"""The purpose of the dissipation at fronts: without additional dissipation
there, as in preset 'fast', solutions overshoot. Steps and errors are tested in
test_presets.py."""

from vertexContactTests.trade.calibration import Calibration
from vertexContactTests.trade.cases import CASES
from vertexContactTests.trade.rows import measure
from vertexContactTests.trade.variants import named


def test_fronts_overshoot(figures):
    case, calibration = CASES["similar"], Calibration()
    rows = [measure(case, named(case, preset, "128"), calibration)
            for preset in ("balanced", "fast")]
    assert all(row["status"] == "done" for row in rows), rows
    with figures("dissipation at fronts, two similar bars") as f:
        f.atMost("error of the peak force, balanced", float(rows[0]["peak"]),
                 0.005)
        f.atLeast("fast", float(rows[1]["peak"]), 0.05)
