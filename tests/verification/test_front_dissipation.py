"""Dissipation at fronts no larger than elsewhere, the default in two and three
dimensions: longer steps, no less right; in one dimension fronts would
overshoot."""

import pytest

from calibration import Calibration
from cases import CASES
from trade import measure
from variants import named


def both(name, mesh):
    """A case with all of the Riemann solver's dissipation at fronts, and with
    no more there than elsewhere."""
    case, calibration = CASES[name], Calibration()
    rows = [measure(case, named(case, "balanced", mesh, frontDissipation=share),
                    calibration)
            for share in ("1", "0.25")]
    assert all(row["status"] == "done" for row in rows), rows
    return rows


@pytest.mark.parametrize("name, mesh", [
    ("rings", "5"), ("nonMatching", "1"), ("taylor", "2")])
def test_longer_steps(name, mesh, figures):
    full, less = both(name, mesh)
    with figures(f"dissipation at fronts 0.25, {CASES[name].title}") as f:
        f.atMost("steps / with 1", float(less["steps"])/float(full["steps"]),
                 0.67)
        f.atMost("error / with 1", float(less["error"])/float(full["error"]),
                 1.02)
        f.atMost("largest rise of the energy / initial", float(less["rise"]),
                 5e-3)


def test_fronts_overshoot(figures):
    """What the dissipation at fronts is for."""
    full, less = both("similar", "128")
    with figures("dissipation at fronts, two similar bars") as f:
        f.atMost("error of the peak force, default (1)", float(full["peak"]),
                 0.005)
        f.atLeast("with 0.25", float(less["peak"]), 0.05)
