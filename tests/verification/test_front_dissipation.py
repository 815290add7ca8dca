"""Less dissipation at fronts: longer steps, no less right where bodies are
solid; in one dimension fronts overshoot."""

import pytest

from calibration import Calibration
from cases import CASES
from trade import measure
from variants import named


def both(name, mesh):
    """A case with the default, and with no more at fronts than elsewhere."""
    case, calibration = CASES[name], Calibration()
    rows = [measure(case, named(case, "balanced", mesh, **more), calibration)
            for more in ({}, {"frontDissipation": "0.25"})]
    assert all(row["status"] == "done" for row in rows), rows
    return rows


@pytest.mark.parametrize("name, mesh", [
    ("rings", "5"), ("nonMatching", "1"), ("taylor", "2")])
def test_longer_steps(name, mesh, figures):
    full, less = both(name, mesh)
    with figures(f"dissipation at fronts 0.25, {CASES[name].title}") as f:
        f.atMost("steps / default", float(less["steps"])/float(full["steps"]),
                 0.83)
        f.atMost("error / default", float(less["error"])/float(full["error"]),
                 1.02)
        f.atMost("largest rise of the energy / initial", float(less["rise"]),
                 1e-3)


def test_fronts_overshoot(figures):
    """What the dissipation at fronts is for."""
    full, less = both("similar", "128")
    with figures("dissipation at fronts, two similar bars") as f:
        f.atMost("error of the peak force, default", float(full["peak"]),
                 0.005)
        f.atLeast("with 0.25", float(less["peak"]), 0.05)
