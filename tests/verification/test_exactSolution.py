"""The exact solution of the two-bar impact, compared with known plateaus and
with laws that hold for any pair of bars."""

from dataclasses import astuple

import numpy as np
import pytest

from vertexContactCases.exactSolution import Bar, TwoBarImpact
from vertexContactTests import caseTools

right = Bar(start=10.01, length=10, E=100, rho=0.01, velocity=0)


def bars(E, endTime):
    left = Bar(start=0, length=10, E=E, rho=0.01, velocity=0.1)
    return TwoBarImpact(left, right, endTime)


def states(exact, time):
    left, right = exact.bars
    return (exact.velocity(0, left.end, time),
            exact.velocity(1, right.start, time),
            exact.stress(0, left.end, time),
            exact.stress(1, right.start, time))


def test_similar():
    exact = bars(E=100, endTime=0.35)
    assert [event for _, event in exact.events] == ["contact", "release"]
    assert [t for t, _ in exact.events] == pytest.approx([0.1, 0.3])
    for time, expected in ((0.05, (0.1, 0, 0, 0)),
                           (0.2, (0.05, 0.05, -0.05, -0.05)),
                           (0.32, (0, 0.1, 0, 0))):
        assert states(exact, time) == pytest.approx(expected, abs=1e-12)


def test_dissimilar():
    exact = bars(E=49, endTime=0.69)
    assert [t for t, _ in exact.events] == pytest.approx([0.1, 27/70])
    changes = [0, 0.1, 0.3, 27/70, 0.5, 41/70, 47/70]
    assert exact.changes() == pytest.approx(changes)
    s, p = -0.0411765, -0.0072664
    for time, expected in zip(changes, (
            (0.1, 0, 0, 0),
            (0.0411765, 0.0411765, s, s),
            (0.0896194, 0.0896194, p, p),
            (-0.0176471, 0.0823529, 0, 0),
            (-0.0176471, 0.0968858, 0, 0),
            (0.0792388, 0.0823529, 0, 0),
            (-0.0176471, 0.0823529, 0, 0))):
        assert states(exact, time + 1e-6) == pytest.approx(expected, abs=1e-7)


@pytest.mark.parametrize("left, right", (
    (Bar(0, 10, 49, 0.01, 0.1), right),
    (Bar(0, 3, 100, 0.05, 0.2), Bar(3.02, 7, 300, 0.01, -0.1)),
    (Bar(0, 7, 1e6, 10, 0.0), Bar(7.001, 2, 1, 0.01, -1.0)),
    (Bar(-1, 1, 100, 0.01, 0.1), Bar(0, 1, 100, 0.01, 0.0))))
def test_laws(left, right):
    """Energy is constant, bars do not penetrate, forces are
    equal and never tensile, and u is the integral of v."""
    endTime = 5*max(bar.length/bar.c for bar in (left, right)) + 0.1
    exact = TwoBarImpact(left, right, endTime)
    assert exact.events
    times = np.linspace(0, endTime, 997)

    energy = sum(e for i in (0, 1) for e in exact.energies(i, times))
    assert energy == pytest.approx(energy[0], rel=1e-10)

    a = exact.displacement(0, left.end, times)
    b = exact.displacement(1, right.start, times)
    assert np.all(right.start + b - left.end - a > -1e-9)

    sigma = [exact.stress(0, left.end, times),
             exact.stress(1, right.start, times)]
    assert sigma[0] == pytest.approx(sigma[1], abs=1e-9*right.E)
    assert np.all(sigma[0] < 1e-9*right.E)

    fine = np.linspace(0, endTime, 200001)
    for i, bar in enumerate(exact.bars):
        X = bar.start + 0.3*bar.length
        v = exact.velocity(i, X, fine)
        u = np.sum(0.5*(v[1:] + v[:-1])*np.diff(fine))
        assert exact.displacement(i, X, endTime) == pytest.approx(
            u, abs=1e-4*endTime*max(abs(v)))


def test_bars_that_never_meet():
    exact = TwoBarImpact(Bar(0, 1, 100, 0.01, 0.0), Bar(2, 1, 100, 0.01, 0.1),
                         endTime=1)
    assert exact.events == []
    assert exact.velocity(1, 2.5, 0.7) == 0.1


@pytest.mark.parametrize("tutorial, E", (("similar", 100), ("dissimilar", 49)))
def test_tutorials_dictionaries(tutorial, E):
    exact = TwoBarImpact.fromCase(
        caseTools.root/"tutorials"/"twoBarImpact"/tutorial)
    for bar, expected in zip(exact.bars, bars(E, 1).bars):
        assert astuple(bar) == pytest.approx(astuple(expected))
