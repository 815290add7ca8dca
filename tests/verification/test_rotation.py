"""Angular momentum: the tutorials of the twisting column and of the spinning
cube, and small bodies in rotation."""

import numpy as np
import pytest

from vertexContactTests.caseTools import (DEFAULT, PRESET, Case, checked,
                                          copyTutorials)
from vertexContactTests.smallCases import RUBBER, Body, SmallCase, largest

WAVES = np.sqrt((1 - 0.3)/((1 + 0.3)*(1 - 2*0.3)))  # wave speed in RUBBER
OMEGA = 0.2*WAVES                           # as in the tutorial of the cube
FIELDS = "pointU", "pointD", "F", "sigma"


def tutorial(name, folder, preset=PRESET, **options):
    """A tutorial, run by its Allrun."""
    case = Case(copyTutorials(folder/"tutorials")/name)
    checked(["./Allrun"], case.path, PLOT="0", PRESET=preset, **options)
    return case


def drift(L):
    """Largest change of a vector, relative to its initial magnitude."""
    return np.max(np.linalg.norm(L - L[0], axis=1))/np.linalg.norm(L[0])


# Twisting column

@pytest.mark.parametrize("nu", ("0.3", "0.495"))
def test_twisting_column(tmp_path, figures, nu):
    """Almost all kinetic energy of the twist becomes strain energy. The total
    energy never rises above the initial energy."""
    case = tutorial("twistingColumn", tmp_path, MESH="I", NU=nu)
    total = case.totalEnergy
    exact = 0.5*1100/6*105**2*3     # (rho/2) int omega^2 dy, int r^2 dA = 1/6
    with figures(f"7 twist, nu = {nu}") as f:
        f.within("end time / s", case.energies["Time"][-1], 0.1, 1e-9)
        f.within("initial energy / integral", total[0]/exact, 1, 0.15)
        f.atMost("largest energy / initial - 1", total.max()/total[0] - 1,
                 1e-6)
        f.atLeast("energy at 0.1 s / initial", total[-1]/total[0], 0.82)
        f.atLeast("largest strain energy / initial",
                  case.energies["total:strain"].max()/total[0], 0.8)
        f.atLeast("smallest strain energy / initial",
                  case.energies["total:strain"].min()/total[0], -1e-9)
        f.atMost("balance / initial energy",
                 largest(case.energies["total:balance"])/total[0], 2e-4)
        J = case.field("0.1", "column", "J")
        f.atMost("largest |J - 1| at 0.1 s", largest(J - 1),
                 0.15 if nu == "0.3" else 0.01)


# Spinning cube

def test_spinning_cube(tmp_path, figures):
    """All components of the angular momentum are constant to round-off in ten
    turns, and the energy never rises above the initial energy."""
    case = tutorial("spinningCube", tmp_path, preset=DEFAULT, MESH="I")
    total = case.totalEnergy
    L, p = case.angularMomentumOf(), case.momentumOf()
    with figures("7 spin") as f:
        f.within("turns", case.energies["Time"][-1]*30/(2*np.pi), 10, 1e-4)
        f.within("initial angular momentum / (mass omega / 6)",
                 L[0, 2]/(1100*30/6), 1, 0.06)
        f.atMost("change of angular momentum / initial", drift(L), 1e-10)
        f.atMost("momentum / (mass omega edge)", largest(p)/(1100*30), 1e-12)
        # Second order: the square of the angle per step is 3.9e-4
        f.atMost("balance / initial energy",
                 largest(case.energies["total:balance"])/total[0], 4e-4)
        f.atLeast("energy after ten turns / initial", total[-1]/total[0],
                  0.95)
        f.atMost("largest energy / initial - 1", total.max()/total[0] - 1,
                 1e-6)


# Small bodies

def spinning(cells, axis=(0, 0, 1), velocity=(0, 0, 0), **more):
    """A body at the origin with a rotation and a translation."""
    omega = OMEGA*np.array(axis)/np.linalg.norm(axis)
    more = {"start": (-0.5, -0.5, -0.5), **more}
    return Body(cells=cells, material=dict(RUBBER),
                velocity=lambda X: np.cross(omega, X) + velocity, **more)


def turns(number, preset=DEFAULT):
    return {"endTime": number*2*np.pi/OMEGA, "preset": preset,
            "control": {"maxCo": 0.6}}


@pytest.mark.parametrize("cells", ((8, 6), (5, 4, 6)))
def test_moving_parallel(tmp_path, figures, cells):
    """A block flies and spins about an axis of its own. Its angular momentum
    about the origin is conserved, and two ranks agree with one."""
    axis = (0, 0, 1) if len(cells) == 2 else (1, 1, 2)
    speed = 0.1*np.array((1, -2, len(cells) - 2))
    body = spinning(cells, axis, velocity=speed, size=(1.2, 0.8, 1),
                    start=(0.3, -0.4, -0.2))
    serial = SmallCase(tmp_path/"serial", body, **turns(0.5)).run()
    parallel = SmallCase(tmp_path/"parallel", body, **turns(0.5))
    parallel.runParallel(2)
    with figures(f"7 spin, {len(cells)}D, flying, half a turn") as f:
        for name, case in ("1 rank", serial), ("2 ranks", parallel):
            f.atMost(f"change of angular momentum, {name}",
                     drift(case.angularMomentumOf()), 1e-10)
            p = case.momentumOf()
            f.atMost(f"change of momentum, {name}", drift(p), 1e-12)
        f.equal("steps of both", len(parallel.energies["Time"]),
                len(serial.energies["Time"]))
        for name in FIELDS:
            a, b = serial.at(name), parallel.at(name)
            f.atMost(f"{name}: 2 ranks - 1 rank / scale",
                     largest(a - b)/largest(a), 1e-10)


@pytest.mark.parametrize("reconstruction", ("full", "linear"))
def test_mirror(tmp_path, figures, reconstruction):
    """The upper half of a cube, with a mirror through the centre normal to the
    axis of rotation, moves like the upper half of the whole cube."""
    scheme = {"reconstruction": reconstruction}
    whole = spinning((4, 4, 4), name="whole", scheme=scheme)
    half = spinning((4, 4, 2), name="half", scheme=scheme, size=(1, 1, 0.5),
                    start=(-0.5, -0.5, 0), sides={"back": "symmetryPlane"})
    # In one run, so that both have the same steps
    case = SmallCase(tmp_path, [whole, half], **turns(1, PRESET)).run()
    row = {tuple(x): i for i, x in
           enumerate(np.round(case.X("whole"), 9) + 0.0)}
    X = np.round(case.X("half"), 9) + 0.0
    rows = [row[tuple(x)] for x in X]
    L, L2 = case.angularMomentumOf("whole"), 2*case.angularMomentumOf("half")
    with figures(f"7 spin, one mirror, {reconstruction}") as f:
        f.atMost("angular momentum, 2 halves / whole - 1",
                 largest(L2[:, 2]/L[:, 2] - 1), 1e-10)
        for name in FIELDS:
            a = case.at(name, region="whole")
            b = case.at(name, region="half")
            f.atMost(f"{name}: half - whole / scale",
                     largest(a[rows] - b)/largest(a), 1e-9)
        f.equal("normal velocity on the mirror", largest(
            case.at("pointU", region="half")[X[:, 2] < 1e-9, 2]), 0.0)
