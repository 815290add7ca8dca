"""Impact of two bars in 1D, 2D and 3D, compared with the exact solution:
accuracy, energy, momentum, and the effect of the dimensions."""

import re
from dataclasses import replace

import numpy as np
import pytest

from vertexContactCases.exactSolution import TwoBarImpact
from vertexContactTests.caseTools import Scene, relativeL1, timeFolders

# Refinement with the default scheme, and other reconstructions
SIMILAR = Scene("similar")
REFINED = tuple(Scene("similar", elements=n) for n in (128, 256, 512, 1024))
LINEAR = Scene("similar", scheme=(("reconstruction", "linear"),))
FIRST = Scene("similar", scheme=(("reconstruction", "none"),))
DISSIMILAR = Scene("dissimilar")

# The same in more dimensions, on coarser meshes
COARSE = Scene("similar", elements=128)
SIMPLICIAL = (replace(COARSE, dimensions=2, across=3),
              replace(COARSE, dimensions=3, across=2))
FIXED = replace(COARSE, control=(
    ("adjustTimeStep", False), ("deltaT", 5e-5), ("writeInterval", 0.35)))
NATIVE = tuple(
    replace(FIXED, dimensions=d, across=n, scheme=(("cells", "native"),))
    for d, n in ((2, 3), (3, 2)))


# Time until the ends are within 1 % of their plateau: the time for 20 cells
# [s]
SETTLED = 0.002


def errors(case):
    """Relative L1 errors in time, in per cent, of v and sigma at A and B."""
    exact = TwoBarImpact.fromCase(case.path)
    result = {}
    for name, bar, X in (("A", 0, exact.bars[0].end),
                         ("B", 1, exact.bars[1].start)):
        for quantity, field, solution in (
                ("v", "pointU", exact.velocity),
                ("sigma", "sigma", exact.stress)):
            t, values = case.probe(f"point{name}", field)
            assert t[0] < 1e-3 and t[-1] == pytest.approx(exact.endTime)
            result[f"{quantity}_{name}"] = 100*relativeL1(
                t, values[:, 0], solution(bar, X, t))
    return result


def loss(case):
    """Loss of total energy at the end, in per cent."""
    return 100*(1 - case.totalEnergy[-1]/case.totalEnergy[0])


def release(case):
    """The last time with a compressive force between the bars."""
    contact = case.contact()
    return contact["Time"][contact["area"] > 0][-1]


@pytest.mark.scenes(SIMILAR)
def test_similar_bars_of_the_exact_solution(run, figures):
    case = run(SIMILAR)
    e = errors(case)
    with figures("1 similar, 1024") as f:
        f.atMost("v at A, relative L1 error [%]", e["v_A"], 0.25)
        f.atMost("v at B, relative L1 error [%]", e["v_B"], 0.35)
        f.atMost("sigma at A, relative L1 error [%]", e["sigma_A"], 0.45)
        f.atMost("sigma at B, relative L1 error [%]", e["sigma_B"], 0.45)
        f.within("energy loss at the end [%]", loss(case), 0.39, 0.05)
        f.within("release [s]", release(case), 0.3, 0.001)
        # The plateaus are 0.1, 0.05, 0 for A and 0, 0.05, 0.1 for B
        fastest = max(case.field(time, bar, "pointU")[:, 0].max()
                      for time in timeFolders(case.path)
                      for bar in ("bar1", "bar2"))
        f.atMost("max v of all nodes / 0.1, at write times",
                 fastest/0.1, 1.01)
        for name in "A", "B":
            t, u = case.probe(f"point{name}", "pointU")
            f.atMost(f"max v at {name} / 0.1", u[:, 0].max()/0.1, 1.01)
            u = u[(t > 0.1 + SETTLED) & (t < 0.299), 0]
            f.atMost(f"max v at {name} / 0.05, from {1000*SETTLED:g} ms after "
                     "the impact", u.max()/0.05, 1.01)
        # A half cell has the impact first: it overshoots during the time for
        # two cells
        t, u = case.probe("pointB", "pointU")
        f.atMost("max v at B / 0.05, before that",
                 u[t < 0.1 + SETTLED, 0].max()/0.05, 1.3)


@pytest.mark.scenes(LINEAR)
def test_linear_reconstruction_never_gains_energy(run, figures):
    case = run(LINEAR)
    total = case.totalEnergy
    with figures("1 linear, 1024") as f:
        f.atMost("largest gain of a step / initial energy",
                 np.max(np.diff(total))/total[0], 1e-12)
        f.atLeast("energy loss at the end [%]", loss(case), 0)


@pytest.mark.scenes(SIMILAR, FIRST)
def test_first_order_is_worse(run, figures):
    best, case = run(SIMILAR), run(FIRST)
    eBest, e = errors(best), errors(case)
    with figures("1 none, 1024") as f:
        for key in e:
            f.atLeast(f"{key}, relative L1 error [%]", e[key], 2*eBest[key])
        f.atLeast("energy loss at the end [%]", loss(case), 2*loss(best))
        f.atMost("largest gain of a step / initial energy",
                 np.max(np.diff(case.totalEnergy))/case.totalEnergy[0], 1e-12)


@pytest.mark.scenes(*REFINED)
def test_errors_fall_with_the_mesh(run, figures):
    cases = [run(scene) for scene in REFINED]
    all_ = [errors(case) for case in cases]
    with figures("1 128 to 1024") as f:
        for key in all_[0]:
            values = [e[key] for e in all_]
            f.falling(f"{key}, relative L1 error [%]", values)
            # For the shocks: 1 is the most that any scheme has
            f.atLeast(f"{key}, order of the L1 error",
                      np.log2(values[0]/values[-1])/(len(values) - 1), 0.65)
        f.falling("energy loss at the end [%]", [loss(c) for c in cases])


@pytest.mark.scenes(DISSIMILAR)
def test_dissimilar_bars_of_the_exact_solution(run, figures):
    case = run(DISSIMILAR)
    e = errors(case)
    t, u = case.probe("pointA", "pointU")
    exact = TwoBarImpact.fromCase(case.path)
    plateaus = exact.velocity(0, exact.bars[0].end, t)
    under = (plateaus.min() - u[:, 0].min())/np.ptp(plateaus)
    with figures("2 dissimilar, 1024") as f:
        f.atMost("v at A, relative L1 error [%]", e["v_A"], 1.0)
        f.atMost("v at B, relative L1 error [%]", e["v_B"], 0.3)
        f.within("release [s]", release(case), 27/70, 0.0015)
        f.atMost("undershoot of v at A [% of its range]", 100*under, 6)


@pytest.mark.scenes(SIMILAR, DISSIMILAR, LINEAR, FIRST)
@pytest.mark.parametrize("scene", (SIMILAR, DISSIMILAR, LINEAR, FIRST))
def test_momentum_and_balance(run, figures, scene):
    case = run(scene)
    name = dict(scene.scheme).get("reconstruction", "full")
    p = case.momentum["total:px"]
    with figures(f"3 {scene.tutorial}, {name}") as f:
        f.atMost("change of total momentum / initial",
                 np.max(np.abs(p - p[0]))/abs(p[0]), 1e-12)
        f.atMost("residual of the energy balance / initial energy",
                 np.max(np.abs(case.energies["total:balance"]))
                 / case.totalEnergy[0], 1e-3)


@pytest.mark.scenes(COARSE, *SIMPLICIAL)
@pytest.mark.parametrize("scene", (COARSE, *SIMPLICIAL),
                         ids=lambda s: f"{s.dimensions}D")
def test_only_what_the_dimension_needs(run, figures, scene):
    """The log says it once, since both bars are equal."""
    log, d = run(scene).log(), scene.dimensions
    assert "\nRegion bar2, as bar1\n" in log
    nodes = (scene.elements + 1)*(scene.across + 1)**(d - 1)
    with figures(f"4 dimensions, {d}D") as f:
        for what, pattern, expected in (
                ("dimensions of the dual mesh", r"dual mesh: (\d)D", d),
                ("nodes of a bar", r"dual mesh: .* (\d+) nodes", nodes),
                ("stored components of v", r"stored .* momentum (\d+)", d),
                ("stored components of F", r"stored .* F (\d+)", d*d),
                ("stored components of H", r"stored .* H (\d+)", 0),
                ("stored components of J", r"stored .* J (\d+)", 0),
                ("stored components of P", r"stored .* stress (\d+)", d*d)):
            f.equal(what, [int(n) for n in re.findall(pattern, log)],
                    [expected])


@pytest.mark.scenes(*SIMPLICIAL, COARSE)
@pytest.mark.parametrize("scene", SIMPLICIAL,
                         ids=lambda s: f"{s.dimensions}D")
def test_simplicial_dual_is_the_line(run, figures, scene):
    case, line = run(scene), run(COARSE)
    e, reference = errors(case), errors(line)
    with figures(f"5 simplicial, {scene.dimensions}D") as f:
        for key in e:
            f.atMost(f"{key}, relative L1 error / that of 1D",
                     e[key]/reference[key], 1.5)
        f.atMost("spread of v in a cross-section / 0.1 m/s, at write times",
                 max(spread(case, time) for time in timeFolders(case.path)),
                 1e-10)


def spread(case, time):
    """Largest difference of v between nodes of the same cross-section, over
    the initial velocity."""
    largest = 0
    for bar in "bar1", "bar2":
        u, points = case.field(time, bar, "pointU"), case.points(bar)
        assert len(u) == len(points)
        sections = np.unique(np.round(points[:, 0], 9), return_inverse=True)[1]
        for section in range(sections.max() + 1):
            largest = max(largest, np.ptp(u[sections == section], axis=0).max())
    return largest/0.1


@pytest.mark.scenes(*NATIVE, FIXED)
@pytest.mark.parametrize("scene", NATIVE, ids=lambda s: f"{s.dimensions}D")
def test_native_dual_is_the_line(run, figures, scene):
    case, line = run(scene), run(FIXED)
    with figures(f"5 native, {scene.dimensions}D") as f:
        for name in "A", "B":
            for field, scale in (("pointU", 0.1), ("sigma", 0.05)):
                t, values = case.probe(f"point{name}", field)
                t1, values1 = line.probe(f"point{name}", field)
                assert t == pytest.approx(t1, rel=1e-12)
                f.atMost(f"{field} at {name}: difference to 1D / scale",
                         np.max(np.abs(values[:, 0] - values1[:, 0]))/scale,
                         1e-9)
