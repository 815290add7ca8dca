"""Impact of two nearly incompressible bars (Section 7.2.2), Mesh I."""

import numpy as np
import pytest

from vertexContactCases import readResults
from vertexContactTests.caseTools import (Tutorial, checkEnergies,
                                          checkerboard, relativeL1, rise, root)
from vertexContactTests.mirrorImages import asymmetry
from vertexContactTests.smallCases import RUBBER, Body, SmallCase, largest

BARS = "nearlyIncompressibleBars"
ABRUPT = (("endTime", 1.5e-4), ("writeInterval", 1e-5))
FULL = Tutorial(BARS)
COARSE = Tutorial(BARS, "4")
NU = {nu: Tutorial(BARS, material=(("nu", nu),), control=ABRUPT)
      for nu in (0.499, 0.4999)}
VOLUMES = {volume: Tutorial(BARS, scheme=(("volume", volume),),
                            material=(("nu", 0.4999),), control=ABRUPT,
                            preset="balanced")
           for volume in ("automatic", "nodal")}
TIMES = np.arange(25, 326, 25)*1e-6

scenes = pytest.mark.scenes


def history(case, field):
    """x component at A at the times of the table."""
    times, values = case.probe("pointA", field)
    return np.interp(TIMES, times, values[:, 0])


def difference(case, field, column):
    """Relative L1 difference from Mesh III, x component at A."""
    data = readResults.csv(root/"tutorials"/BARS/"referenceData"/"meshIII.csv")
    times, values = case.probe("pointA", field)
    return relativeL1(data["Time"],
                      np.interp(data["Time"], times, values[:, 0]),
                      data[column])


def gridEdges(X):
    """Pairs of neighbours in the grid of the quadrilaterals."""
    x, i = np.unique(np.round(X[:, 0], 9), return_inverse=True)
    y, j = np.unique(np.round(X[:, 1], 9), return_inverse=True)
    node = np.empty((len(x), len(y)), dtype=int)
    node[i, j] = np.arange(len(X))
    return np.vstack([np.stack((a.ravel(), b.ravel()), axis=1) for a, b in (
        (node[1:, :], node[:-1, :]), (node[:, 1:], node[:, :-1]))])


def meanCheckerboard(case, start):
    """Mean checkerboard of bar 1 over the times written from start on."""
    X = case.points("bar1")
    front = np.flatnonzero(X[:, 2] > X[:, 2].mean())
    edges = gridEdges(X[front])
    return np.mean([
        checkerboard(case.field(time, "bar1", "pressure")[front, 0], edges)
        for time in case.times if float(time) >= start])


@scenes(FULL, COARSE)
def test_pressure_and_release_of_theory(run, figures):
    case = run(FULL)
    contact, total = case.contact("bars"), case.totalEnergy
    time, touching = contact["Time"], contact["slip"]
    force = np.abs(contact["bar1.right:Fx"])
    with figures("3.3 bars, default") as f:
        f.within("first contact [us]", 1e6*time[touching > 0][0], 80, 0.1)
        f.within("last contact [us]", 1e6*time[touching > 0][-1], 285, 3)
        f.atLeast("energy at 325 us / initial", total[-1]/total[0], 0.895)
        coarse = run(COARSE)
        f.atLeast("the same less that of 4 x 20 elements", total[-1]/total[0]
                  - coarse.totalEnergy[-1]/coarse.totalEnergy[0], 0.01)
        f.atMost("largest penetration / cell",
                 contact["penetration"].max()/0.8e-3, 0.05)
        f.falling("penetration, 4 and 8 elements [m]",
                  [c.contact("bars")["penetration"].max()
                   for c in (coarse, case)])
        checkEnergies(f, case, balance=2e-3, total=1e-3)

        f.within("v_x of A at 300 us [m/s]",
                 np.interp(3e-4, TIMES, history(case, "pointU")), -18, 2)
        f.within("u_x of A at 300 us [mm]",
                 1e3*np.interp(3e-4, TIMES, history(case, "pointD")),
                 3.906, 0.01)
        # Mesh II: 0.077 and 0.06 %, see the tutorial's page
        f.falling("v_x of A, relative L1 difference from Mesh III, 4 and 8 "
                  "elements", [difference(c, "pointU", "vx")
                               for c in (coarse, case)])
        f.atMost("the same of u_x of A, 8 elements",
                 difference(case, "pointD", "ux"), 2e-3)

        # The double contact: A separates and moves back before it is hit
        # again. Meanwhile only the nodes next to the lateral surfaces touch
        window = (time > 8.3e-5) & (time < 1e-4)
        t, v = case.probe("pointA", "pointU")
        between = (t > 8.3e-5) & (t < 1e-4)
        f.atMost("between the contacts: force / peak",
                 force[window].min()/force.max(), 0.02)
        f.atMost("corners that touch / all",
                 touching[window].min()/touching.max(), 0.3)
        f.atMost("least velocity of A [m/s]", v[between, 0].min(), -15)
        f.atMost("velocity of A at 100 us [m/s]",
                 abs(np.interp(1e-4, t, v[:, 0])), 2)


@scenes(FULL)
def test_bars_mirror_each_other(run, figures):
    with figures("3.5 bars, mirror") as f:
        f.atMost("difference of the bars' fields from mirror images",
                 asymmetry(run(FULL), "bar1", "bar2", 0.0364), 1e-9)


@scenes(FULL, *NU.values())
def test_checkerboard(run, figures):
    with figures("3.3 bars, checkerboard") as f:
        f.atMost("nu 0.495", meanCheckerboard(run(FULL), 1e-4), 0.1)
        for nu, scene in NU.items():
            f.atMost(f"nu {nu}", meanCheckerboard(run(scene), 1.2e-4), 0.1)


@scenes(*VOLUMES.values())
def test_smoothed_volume(run, figures):
    """With the default scheme and nu = 0.4999 pressures do not alternate. With
    the volumes of the single nodes they do."""
    smoothed, nodal = (meanCheckerboard(run(VOLUMES[k]), 1.2e-4)
                       for k in ("automatic", "nodal"))
    with figures("3.3 bars, default, smoothed volume") as f:
        f.atMost("checkerboard", smoothed, 0.15)
        f.atLeast("of nodal volumes / that", nodal/smoothed, 2)


@scenes(*NU.values())
def test_incompressible_limit(run, figures):
    with figures("3.3 bars, towards incompressibility") as f:
        for nu, scene in NU.items():
            energy = run(scene).totalEnergy
            f.atMost(f"nu {nu}: largest rise of the total energy / initial",
                     rise(energy), 1e-3)
            f.atLeast(f"nu {nu}: energy at 150 us / initial",
                      energy[-1]/energy[0], 0.85)


def test_where_it_is(tmp_path, figures):
    """The smoothing of the volume depends neither on the position of the body
    nor on its directions."""
    def swings(name, start=(0, 0, 0), axes=(0, 1, 2)):
        def turned(X):
            Y = np.empty_like(X)
            Y[:, axes] = X + start
            return Y

        def back(Y):
            return Y[:, axes] - start
        body = Body(cells=(5, 4, 2), moved=turned, material={
            **RUBBER, "nu": 0.495}, velocity=lambda Y: turned(np.stack((
                -0.05*np.sin(3*back(Y)[:, 0]), 0.02*back(Y)[:, 1],
                0*Y[:, 0]), axis=1) - start))
        case = SmallCase(tmp_path/name, body, 0.2, preset="balanced", control={
            "adjustTimeStep": "no", "deltaT": 0.02}).run()
        return case.at("pointU")[:, axes], case.at("pressure")

    here = swings("here")
    with figures("smoothed volume, elsewhere and turned") as f:
        for what, there in {
                "far away": swings("far", start=(100, -30, 7)),
                "turned": swings("turned", axes=(2, 0, 1))}.items():
            for name, a, b in zip(("velocity", "pressure"), here, there):
                f.atMost(f"{what}: difference of the {name} / largest",
                         largest(a - b)/largest(a), 1e-11)
