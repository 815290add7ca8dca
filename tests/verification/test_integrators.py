"""Time integrators and presets: order, conservation, restart, and ranks."""

import numpy as np
import pytest

from vertexContactTests.caseTools import rise
from vertexContactTests.smallCases import Body, SmallCase, interface, largest

INTEGRATORS = {"TVDRK2": 2, "TVDRK3": 3, "symplecticEuler": 1}
LINEAR = {"type": "linearElastic", "rho": 1, "E": 1, "nu": 0.3}


def rotating(X):
    """A rotation with a vibrating stretch."""
    x, y = (X[:, :2] - 0.5).T
    return np.column_stack((0.2*y + 0.1*x, -0.2*x - 0.05*y, 0*x))


def scheme(integrator):
    split = integrator == "symplecticEuler"
    return {"reconstruction": "linear" if split else "full"}


def block(folder, integrator, end, control=None, **body):
    body = {"cells": (4, 4), "velocity": rotating,
            "scheme": scheme(integrator), **body}
    return SmallCase(folder, Body(**body), end, control={
        "timeIntegrator": integrator, "timePrecision": 15, **(control or {})})


def impact(folder, control, scheme=None):
    """Two blocks collide; their meshes do not match."""
    bodies = (Body(cells=(5, 4), name="left", velocity=(0.1, 0.02, 0),
                   sides={"right": "contact"}, scheme=scheme or {}),
              Body(cells=(4, 3), name="right", start=(1.02, 0.1, 0),
                   velocity=(-0.1, 0, 0), sides={"left": "contact"},
                   scheme=scheme or {}))
    pair = {"meet": interface(("left", "right"), ("right", "left"),
                              pairing="nearestFace")}
    return SmallCase(folder, bodies, 0.6, pair, functions=("contactForces",),
                     control={
                         "writeInterval": 0.3, "timePrecision": 15, **control})


@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_order_in_time(tmp_path, figures, integrator):
    """Differences from a run with a sixteenth of the shortest step. Without
    limiter and change of areas, rates are smooth functions of the state."""
    def state(n):
        case = block(tmp_path/f"n{n}", integrator, 1, {
            "adjustTimeStep": "no", "deltaT": 1/n, "writeControl": "timeStep",
            "writeInterval": n, "functions": {}}, material=LINEAR,
            scheme={"reconstruction": "none"}).run()
        return case.at("F")

    exact = state(1280)
    errors = [largest(state(n) - exact) for n in (40, 80)]
    with figures(f"order in time, {integrator}") as f:
        f.atLeast("order", np.log2(errors[0]/errors[1]),
                  INTEGRATORS[integrator] - 0.1)


@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_momentum_is_kept(tmp_path, figures, integrator):
    case = block(tmp_path, integrator, 5, {"maxCo": 0.4},
                 material={"type": "neoHookean", "rho": 1, "E": 1,
                           "nu": 0.3}).run()
    with figures(f"conservation, {integrator}") as f:
        f.atMost("linear momentum",
                 largest(case.momentumOf() - case.momentumOf()[0]), 1e-14)


@pytest.mark.parametrize("control, scheme", (
    ({"preset": "fast"}, {}),
    ({"preset": "accurate"}, {}),
    ({"timeIntegrator": "symplecticEuler", "maxCo": 0.8},
     {"reconstruction": "linear", "kinematics": "FJ"}),
    ({"timeIntegrator": "TVDRK3"}, {"waveSpeed": "stretched"}),
), ids=("fast", "accurate", "symplecticEuler", "TVDRK3 stretched"))
def test_ranks_and_restart(tmp_path, figures, control, scheme):
    """Three ranks give the same, and a restarted run is equal to the last
    bit."""
    serial = impact(tmp_path/"serial", control, scheme).run()
    parallel = impact(tmp_path/"parallel", control, scheme)
    parallel.runParallel(3, "random")
    again = impact(tmp_path/"again", {**control, "endTime": 0.3}, scheme).run()
    again.set("system/controlDict", {"endTime": 0.6})
    again.run()
    worst, same = 0, True
    for region in "left", "right":
        for name in "lm", "F", "sigma", "pointD":
            a = serial.at(name, region=region)
            worst = max(worst, largest(a - parallel.at(name, region=region))
                        / largest(a))
            same = same and (a == again.at(name, region=region)).all()
    assert serial.contact("meet")["area"].max() > 0
    with figures(f"ranks and restart, {control} {scheme}") as f:
        f.atMost("three ranks, largest difference", worst, 1e-12)
        f.equal("restart to the last bit", same, True)
        f.atMost("linear momentum", largest(
            serial.momentumOf() - serial.momentumOf()[0]), 1e-14)


@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_energy_of_an_impact(tmp_path, figures, integrator):
    """Energy of an impact. The energy of symplecticEuler, as written,
    oscillates with dt/2 times its rate: it is not a bound."""
    case = impact(tmp_path/"case", {"timeIntegrator": integrator, "maxCo": 0.4},
                  scheme(integrator)).run()
    E = case.totalEnergy
    balance = largest(case.energies["total:balance"])/E[0]
    with figures(f"energy of an impact, {integrator}") as f:
        f.atMost("largest rise / initial", rise(E),
                 0.1 if integrator == "symplecticEuler" else 5e-3)
        f.atMost("largest balance / initial", balance,
                 0.05 if integrator == "symplecticEuler" else 4e-3)
        f.within("final / initial", E[-1]/E[0], 0.82, 0.04)
