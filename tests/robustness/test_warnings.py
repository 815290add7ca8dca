"""Warnings of a run about unsuitable choices, and how a run ends when it
cannot continue."""

import numpy as np
import pytest

from vertexContactTests.caseTools import DEFAULT, PRESET
from vertexContactTests.smallCases import (ELASTIC, FLOOR, RUBBER, Body,
                                           SmallCase, condition, coulomb,
                                           interface, table, turned)
from vertexContactTests.stability.free import rubber
from vertexContactTests.stability.impacts import bar, ends, mach, outer
from vertexContactTests.stability.judge import STOPPED

LAWS = {"linearElastic": ELASTIC, "neoHookean": RUBBER,
        "HenckyVonMises": {**RUBBER, "type": "HenckyVonMises", "tauY": 10}}


BOTH = pytest.mark.parametrize("preset", (DEFAULT, PRESET))


def log(folder, law, speed, preset, maxCo=0.5):
    """Output of a bar that hits a wall at a given speed; its wave speeds are
    about 1."""
    case = SmallCase(folder, Body(
        cells=(20,), material=LAWS[law], velocity=(-speed, 0, 0),
        sides={"left": {"type": "fixedVelocity", "velocity": (0, 0, 0)}}),
        0.5, control={"maxCo": maxCo, "logInterval": 10}, preset=preset)
    code, output = case.attempt()
    assert code == 0, output
    return output


@BOTH
def test_small_strain_law_strained(tmp_path, preset):
    output = log(tmp_path/"large", "linearElastic", 0.2, preset)
    assert output.count("is a law of small strains") == 1, output
    assert "linearElastic" in output and "neoHookean" in output
    assert "law of small strains" not in log(
        tmp_path/"small", "linearElastic", 0.01, preset)


@BOTH
def test_cheaper_laws(tmp_path, preset):
    assert "linearElastic, whose" in log(
        tmp_path/"small", "neoHookean", 1e-4, preset)
    assert "linearElastic, whose" not in log(
        tmp_path/"large", "neoHookean", 0.1, preset)
    assert "has not yielded" in log(
        tmp_path/"elastic", "HenckyVonMises", 0.01, preset)


@BOTH
def test_step_above_the_limit(tmp_path, preset):
    warning = "steps may be unstable"
    assert warning in log(tmp_path/"long", "neoHookean", 0.01, preset, 1.2)
    assert warning not in log(tmp_path/"short", "neoHookean", 0.01, preset, 1)


@pytest.mark.parametrize("cells, control, scheme, warned", (
    ((2, 2), {"timeIntegrator": "TVDRK2"}, {}, True),
    ((2, 2), {"timeIntegrator": "symplecticEuler"},
     {"reconstruction": "linear", "kinematics": "FJ"}, True),
    ((3, 3), {"timeIntegrator": "TVDRK2"}, {}, False),
    ((2, 2), {"timeIntegrator": "TVDRK3"}, {}, False)))
def test_few_cells(tmp_path, cells, control, scheme, warned):
    case = SmallCase(tmp_path/"case", Body(
        cells=cells, material=RUBBER, scheme=scheme), 0.1, control=control)
    code, output = case.attempt()
    assert code == 0, output
    assert ("bodies of two cells across" in output) == warned, output


@pytest.mark.parametrize("preset, gains", ((PRESET, True), (DEFAULT, False)))
def test_rise_of_energy(tmp_path, preset, gains):
    """A block under its weight on a base with the same mesh: with the paper's
    scheme it gains energy."""
    block = Body(cells=(4, 4), name="block", material=RUBBER,
                 sides={"bottom": "contact"})
    base = Body(cells=(8, 4), name="base", start=(-0.5, -1, 0), size=(2, 1, 1),
                material=RUBBER, sides={
                    "bottom": condition("fixedVelocity", velocity=(0, 0, 0)),
                    "top": "contact"})
    weight = 0.01*RUBBER["E"]/RUBBER["rho"]
    case = SmallCase(
        tmp_path/"case", [block, base], 1000, gravity=(0, -weight, 0),
        control={"maxCo": 0.6}, interfaces={"contact": interface(
            ("block", "bottom"), ("base", "top"), coulomb(0.5),
            pairing="matching")}, preset=preset)
    code, output = case.attempt()
    assert code == 0, output
    own = case.keptEnergy - case.energies["total:externalWork"]
    rise = np.max(own - np.minimum.accumulate(own))
    assert (rise > 0.02*case.totalEnergy.max()) == gains, rise
    assert ("of its largest value, without work" in output) == gains, output


def pressed(folder, gap, control=None, motion=None):
    """A block that moves down onto another one, with a gap at the start, and
    far above an obstacle that may move."""
    blocks = [Body(cells=(4, 4), name=name, start=(0, y, 0), material=RUBBER,
                   velocity=(0, v, 0), sides={side: "contact"})
              for name, y, v, side in (
                  ("lower", 0, 0, "top"),
                  ("upper", 1 + gap, -0.01, "bottom"))]
    interfaces = {"contact": interface(
        ("lower", "top"), ("upper", "bottom"), coulomb(0.3),
        pairing="nearestFace")}
    if motion:
        interfaces["far"] = {
            "side": ("lower", "top"), "motion": motion, "obstacle": {
                "type": "sphere", "origin": (0, -9, 0), "radius": 1},
            "law": {"type": "frictionless"}}
    return SmallCase(folder, blocks, 4, interfaces=interfaces, preset=DEFAULT,
                     control={"logInterval": 10, **(control or {})})


@pytest.mark.parametrize("gap, motion, gives", (
    (-0.025, None, True), (-0.025, {"velocity": (0, 0.01, 0)}, False),
    (0.01, None, False)))
def test_contact_that_gives_energy(tmp_path, gap, motion, gives):
    """Surfaces that start a tenth of a cell inside each other are pushed
    apart. The run warns, and ends if maxEnergyRise is set. Energy from moving
    obstacles gives no warning."""
    case = pressed(tmp_path/"warned", gap, motion=motion)
    code, output = case.attempt()
    assert code == 0, output
    given = case.energies["total:contactWork"].max()/case.totalEnergy.max()
    assert (given > 0.5) == (gap < 0), given
    assert ("Contact has given" in output) == gives, output
    code, output = pressed(tmp_path/"stopped", gap,
                           {"maxEnergyRise": 0.05}, motion).attempt()
    assert (code != 0) == gives, output
    assert ("The energy has risen" in output) == gives, output
    assert ("inside each other at the start" in output) == gives, output


def test_contact_that_gave_before(tmp_path):
    """A restarted run does not end because of energy that contact gave
    before."""
    case = pressed(tmp_path, -0.025)
    assert case.attempt()[0] == 0
    case.set("system/controlDict", {"endTime": 4.2, "maxEnergyRise": 0.05})
    code, output = case.attempt()
    assert code == 0 and "Contact has given" not in output, output


@pytest.mark.parametrize("maxCo, balances", ((1.2, False), (0.45, True)))
def test_energies_that_do_not_balance(tmp_path, maxCo, balances):
    """A metal dissipates what an unstable step gains, so that its kinetic and
    strain energies do not rise."""
    metal = Body((4, 4), velocity=(0, -0.1, 0), sides={"bottom": "contact"},
                 material=dict(LAWS["HenckyVonMises"], E=1, nu=0.33,
                               tauY=0.003, Hardening=0.003))
    code, log = SmallCase(
        tmp_path, metal, 8, preset="fast", control={"maxCo": maxCo},
        interfaces={"floor": {"side": ("body", "bottom"), "obstacle": FLOOR}}
        ).attempt()
    assert code == 0, log
    assert ("is not accounted for" in log) != balances, log


@BOTH
def test_linear_law_blows_up(tmp_path, preset):
    """With a linear law the numbers stay finite for very long."""
    case = SmallCase(tmp_path/"case", Body(
        cells=(20,), material=ELASTIC, velocity=lambda X: 0.01*X), 50,
        control={"maxCo": 3}, preset=preset)
    code, output = case.attempt()
    assert code == 1 and "The state is not finite" in output, output
    assert "region body, node at" in output, output


def test_run_that_has_ended(tmp_path):
    """Started once more it says why it does nothing."""
    case = SmallCase(tmp_path/"case", Body((3,)), 0.1, preset=DEFAULT)
    code, log = case.attempt()
    assert code == 0 and "No steps" not in log, log
    code, log = case.attempt()
    assert code == 0 and "No steps: the run is at 0.1 s" in log, log


@pytest.mark.parametrize("cells, ranks", (((3, 3), 1), ((3, 3), 2),
                                          ((3, 3, 3), 2)))
def test_folded_cells(tmp_path, cells, ranks):
    """One inner node lies beyond the diagonal of one of its cells, but its
    Jacobian, the mean of its cells, does not change."""
    def output(share):
        def moved(X):
            near = np.all(np.isclose(X[:, :len(cells)], 1/3), axis=1)
            return -share/3*np.outer(near, np.arange(3) < len(cells))
        case = SmallCase(
            tmp_path/f"{share}", Body(cells, displacement=moved,
                                      material=RUBBER), 1e-6,
            control={"adjustTimeStep": "no", "deltaT": 1e-6}, preset=DEFAULT)
        code, log = case.attempt(ranks)
        assert code == 0, log
        return log

    folded = output(0.7)
    assert "are folded" in folded and "region body" not in folded, folded
    assert f" 1 of {3**len(cells)} cells are folded" in folded, folded
    assert "are folded" not in output(0.2)


def test_surface_goes_through(tmp_path):
    """Rubber bars meet at 0.8 of their wave speed. The wave speed c_p of the
    undeformed material is too small there."""
    result = mach(tmp_path/"case", "40x8", 0.8, preset=PRESET)
    assert result.outcome == STOPPED
    assert "gone through" in result.why, result.why


@pytest.mark.parametrize("ranks", (1, 2))
@pytest.mark.parametrize("sides, passes", (("tractionFree", True),
                                           ("contact", False)))
def test_pad_bends_round_an_edge(tmp_path, ranks, sides, passes):
    """A block is pressed into a soft pad, which bulges round its edges. If the
    sides of the block cannot touch it, the pad goes into them, and the pressed
    nodes lose what is opposite, one after the other, from the edges inwards."""
    foam = {"type": "neoHookean", "rho": 60, "E": 1e5, "nu": 0}
    both = {"left": sides, "right": sides}
    press = condition("fixedVelocity", components=("y",), velocity=table(
        (0, (0, 0, 0)), (0.02, (0, -0.25, 0)), (0.2, (0, -0.25, 0))))
    bodies = [
        Body((9, 5), "pad", size=(0.1, 0.05, 1), material=foam,
             sides={"bottom": "slip", "top": "contact", **both}),
        Body((14, 8), "block", (0, 0.05, 0), (0.1, 0.05, 1),
             dict(bottom="contact", top=press, **both),
             dict(foam, rho=90, E=3e5, nu=0.1))]
    case = SmallCase(
        tmp_path, bodies, 0.14, preset=DEFAULT,
        control={"damping": {'".*"': {"coefficient": 30}}},
        interfaces={"press": {"surfaces": "all", "self": "no"}})
    code, log = case.attempt(ranks)
    assert (code != 0) == passes, log
    assert ("has nothing opposite any more" in log) == passes, log
    assert ("contact also on the faces" in log) == passes, log


@pytest.mark.parametrize("waveSpeed, speed, warned", (
    ("linear", 0.9, True), ("linear", 0.5, False), ("stretched", 0.9, False)))
def test_fast_impact(tmp_path, waveSpeed, speed, warned):
    _, cp, _ = rubber(0.3)
    bodies = [bar(name, (10,), start, speed=v, material=RUBBER,
                  scheme={"waveSpeed": waveSpeed})
              for name, start, v in (("left", 0, speed*cp), ("right", 1, 0))]
    outer(*bodies)
    case = SmallCase(tmp_path/"case", bodies, 0.05, interfaces=ends(
        "left", "right"))
    code, output = case.attempt()
    assert code == 0, output
    assert ("surfaces may go through each other" in output) == warned, output


@pytest.mark.parametrize("reconstruction", ("full", "linear"))
def test_gain_of_energy(tmp_path, reconstruction):
    """A block of few cells makes twenty turns: full reconstruction gains
    energy."""
    _, cp, _ = rubber(0.3)
    omega = 0.2*cp
    case = SmallCase(tmp_path/"case", Body(
        cells=(3, 3), scheme={"reconstruction": reconstruction},
        velocity=lambda X: np.cross((0, 0, omega), X - 0.5)),
        40*np.pi/omega, control={"maxCo": 0.6})
    code, output = case.attempt()
    assert code == 0, output
    E = case.totalEnergy
    gains = np.max(E - np.minimum.accumulate(E)) > 0.02*E[0]
    assert gains == (reconstruction == "full")
    assert ("of its energy from the fluxes" in output) == gains


@pytest.mark.parametrize("control", ({}, {"maxEnergyRise": 1e-3}))
def test_energies_that_are_round_off(tmp_path, control):
    """A block that starts rotated and hardly moves. Its energy is round-off,
    of either sign, and causes no warning."""
    case = SmallCase(tmp_path, Body(
        cells=(3, 3), material=RUBBER,
        displacement=lambda X: turned(X, (0, 0, 1), 0.4) - X,
        velocity=lambda X: 1e-10*np.sin(3*X)),
        3, control={"maxCo": 0.9, "logInterval": 1, **control}, preset=DEFAULT)
    code, output = case.attempt()
    assert code == 0, output
    assert np.max(np.abs(case.totalEnergy)) < 1e-14
    assert "Warning" not in output, output


@pytest.mark.parametrize("v", (0, 1e-3))
def test_velocity_that_the_mesh_does_not_solve(tmp_path, v):
    """In two dimensions the velocity is along the third one. There is no
    warning if it is zero."""
    case = SmallCase(tmp_path, Body((2, 2), velocity=(0.01, 0, v)), 0.1,
                     preset=DEFAULT)
    code, output = case.attempt()
    assert code == 0, output
    assert ("directions that the mesh does not solve" in output) == (v > 0)
    assert (f"up to {v} m/s" in output) == (v > 0), output


@pytest.mark.parametrize("u", (0, 0.1))
def test_displacement_that_the_mesh_does_not_solve(tmp_path, u):
    """In two dimensions the displacement is along the third one."""
    code, output = SmallCase(tmp_path, Body(
        (2, 2), displacement=lambda X: X*(0.01, 0, 0) + (0, 0, u)), 0.1,
        preset=DEFAULT).attempt()
    assert code == 0, output
    assert ("an initial displacement of up to 0.1 m" in output) == (u > 0)
    assert ("directions that the mesh does not solve" in output) == (u > 0)


LEFT_OUT = {
    "gravity": ({"gravity": (0, -0.1, -9)}, {}),
    "acceleration": ({}, {"forces": {"s": {
        "type": "uniform", "acceleration": (0, 0, -9)}}}),
    "force": ({}, {"material": {"type": "rigid", "rho": 1, "force": table(
        (0, (0, 0, 0)), (0.01, (0, 0, -9)))}}),
    "moment": ({}, {"material": {"type": "rigid", "rho": 1,
                                 "moment": (0, 9, 1)}}),
    **{name: ({}, {"sides": {"left": condition(name, **values)}})
       for name, values in (
           ("traction", {"traction": (0.1, 0, 0.2)}),
           ("fixedVelocity", {"velocity": (0, 0, 0.1)}),
           ("fixedDisplacement", {"displacement": table(
               (0, (0, 0, 0)), (1, (0, 0, 0.1)))}))}}


@pytest.mark.parametrize("what", LEFT_OUT)
def test_loads_that_the_mesh_does_not_solve(tmp_path, what):
    """The load is along the direction that is left out, or about another one.
    In 3D there is no warning."""
    more, body = LEFT_OUT[what]
    for nDim in (2, 3):
        code, output = SmallCase(
            tmp_path/str(nDim), Body((2,)*nDim, velocity=(0.01, 0, 0), **body),
            0.01, preset=DEFAULT, **more,
            control={"adjustTimeStep": "no", "deltaT": 0.001}).attempt()
        assert code == 0, output
        assert ("but the mesh solves only" in output) == (nDim == 2), output


@pytest.mark.parametrize("nDim", (1, 2, 3))
def test_metal_turned_inside_out(tmp_path, nDim):
    """The logarithm of such a state does not exist. The run ends with the same
    message as for other laws."""
    case = SmallCase(tmp_path, Body(
        (3,)*nDim, material={**RUBBER, "type": "HenckyVonMises", "tauY": 0.05},
        velocity=(-20, 0, 0), sides={"left": condition(
            "fixedVelocity", velocity=(0, 0, 0))}), 1, preset=DEFAULT,
        control={"adjustTimeStep": "no", "deltaT": 0.02})
    code, output = case.attempt()
    assert code == 1, output
    assert "has a Jacobian that is not positive" in output


def test_points_at_one_place(tmp_path):
    """The error names two points of a cell that coincide, before the first
    step."""
    def collapsed(X):
        X = np.array(X)
        X[21] = X[22]
        return X

    case = SmallCase(tmp_path, Body((3, 3, 3), moved=collapsed), 0.1,
                     preset=DEFAULT)
    code, output = case.attempt()
    assert code == 1 and output.count("--> FOAM FATAL IO ERROR") == 1, output
    assert "points 21 and 22 of a cell are both at" in output, output
    assert "polyMesh" in output, output
