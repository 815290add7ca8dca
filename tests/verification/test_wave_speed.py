"""Shocks in a neo-Hookean bar that hits a rigid wall, compared with the exact
jump conditions, with the wave speeds of the undeformed and of the stretched
material."""

import numpy as np
import pytest

from vertexContactTests.caseTools import rise
from vertexContactTests.smallCases import Body, SmallCase, condition

MU, KAPPA = 0.5/1.3, 1/1.2          # E = 1, nu = 0.3, rho = 1
CP = np.sqrt(KAPPA + 4/3*MU)


def stress(stretch):
    """P_11 in uniaxial strain."""
    return (MU*stretch**(-2/3)*(stretch - (stretch**2 + 2)/(3*stretch))
            + KAPPA*(stretch - 1))


def shock(speed):
    """Stretch behind the shock and its speed U: conservation of momentum,
    U v = -P, and of F, U (1 - stretch) = v."""
    low, high = 1e-3, 1 - 1e-9
    for _ in range(100):
        middle = 0.5*(low + high)
        if speed**2 + stress(middle)*(1 - middle) > 0:
            high = middle
        else:
            low = middle
    return low, speed/(1 - low)


def errors(folder, mach, waves):
    """Relative error of the mean stress behind the shock, number of steps,
    rise of the energy."""
    stretch, U = shock(mach*CP)
    end = 0.8/U
    case = SmallCase(folder, Body(
        cells=(100,), velocity=(-mach*CP, 0, 0),
        sides={"left": condition("fixedVelocity", velocity=(0, 0, 0))},
        scheme={"waveSpeed": waves}), end,
        control={"maxCo": 0.6, "writeInterval": end}).run()
    behind = case.X()[:, 0] < 0.6
    sigma = case.at("sigma")[behind, 0]
    E = case.totalEnergy
    return (np.mean(np.abs(sigma - stress(stretch)))/-stress(stretch), len(E),
            rise(E))


@pytest.mark.parametrize("mach", (0.01, 0.1, 0.2, 0.5))
def test_stress_behind_a_shock(tmp_path, figures, mach):
    linear, linearSteps, rise = errors(tmp_path/"linear", mach, "linear")
    stretched, steps, riseStretched = errors(
        tmp_path/"stretched", mach, "stretched")
    with figures(f"shock of {mach} cp") as f:
        f.atMost("stress behind it, linear", linear, 0.012)
        f.atMost("stretched", stretched, 0.01)
        f.atMost("stretched / linear", stretched/linear,
                 0.8 if mach == 0.5 else 1.1)
        f.atMost("steps, stretched / linear", steps/linearSteps,
                 1.6 if mach == 0.5 else 1.15)
        f.atMost("largest rise of the energy", max(rise, riseStretched), 5e-4)
