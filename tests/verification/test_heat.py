"""Heat of plastic work: of a block that is squeezed, and in the Taylor bar; a
metal that gets softer; on two ranks, and after a restart."""

import numpy as np
import pytest

from caseTools import DEFAULT, Tutorial
from smallCases import Body, SmallCase, condition, table

RHO, CP, BETA, T0 = 8.0, 2.0, 0.9, 300.0
HEAT = {"beta": BETA, "cp": CP, "T0": T0}
METAL = {"type": "HenckyVonMises", "rho": RHO, "E": 1000.0, "nu": 0.3}
LINEAR = {"tauY": 1.0, "Hardening": 5.0}
SOFTENS = {"A": 1.0, "B": 5.0, "n": 1.0, "C": 0.0, "m": 1.0,
           "Tmelt": T0 + 0.03, "referenceRate": 1.0}
RANGE = SOFTENS["Tmelt"] - T0


def squeezed(folder, yields, endTime=1.0, ranks=1, **control):
    """A block of which one side is pushed by a tenth of its length, slowly:
    waves take a hundredth of the time."""
    pushed = condition("fixedDisplacement", displacement=table(
        (0, (0, 0, 0)), (1, (-0.1, 0, 0))), components=("x",))
    body = Body(cells=(4, 4), material={
        **METAL, **yields, "adiabaticHeating": HEAT},
        sides={"left": "symmetryPlane", "right": pushed})
    case = SmallCase(folder, body, endTime, preset=DEFAULT, control=control)
    return case.run() if ranks == 1 else case.runParallel(ranks)


def temperatures(case, time="1"):
    return case.field(time, "body", "pointT")[:, 0]


def test_temperature_is_the_work(tmp_path, figures):
    """In equilibrium all of the block yields alike."""
    case = squeezed(tmp_path, LINEAR)
    T = temperatures(case)
    e = case.field("1", "body", "epsilonPEq")[:, 0]
    rise = BETA/(RHO*CP)*(LINEAR["tauY"]*e + LINEAR["Hardening"]*e**2/2)
    work = case.energies["total:plasticDissipation"][-1]
    with figures("heat of a block that is squeezed") as f:
        f.atLeast("plastic strain", e.min(), 0.09)
        f.atMost("temperature less that of the strain / rise",
                 np.abs(T - T0 - rise).max()/rise.max(), 1e-9)
        f.within("mean rise rho cp V / beta plastic work",
                 (weights() @ (T - T0))*RHO*CP/(BETA*work), 1, 1e-10)


def weights():
    """Volumes of the nodes of the block, which is 1 x 1, per metre."""
    line = np.array([0.5, 1, 1, 1, 0.5])/4
    return np.tile(np.outer(line, line).ravel(), 2)/2


def test_softer_when_warm(tmp_path, figures):
    """The block bears less with heat than without, by what its temperature
    says."""
    case = squeezed(tmp_path/"warm", {"JohnsonCook": SOFTENS})
    cold = {k: v for k, v in SOFTENS.items() if k not in ("m", "Tmelt")}
    same = squeezed(tmp_path/"cold", {"JohnsonCook": cold})
    T = temperatures(case)
    e = case.field("1", "body", "epsilonPEq")[:, 0]
    share = 1 - np.exp(-BETA/(RHO*CP*RANGE)*(e + 5*e**2/2))
    q = case.field("1", "body", "sigmaEq")[:, 0]
    with figures("a block that gets softer") as f:
        f.atMost("temperature less the closed form / rise",
                 np.abs((T - T0)/RANGE - share).max()/share.max(), 0.005)
        f.within("equivalent stress / (A + B e)(1 - T*)",
                 (q/((1 + 5*e)*(1 - (T - T0)/RANGE))).mean(), 1, 0.02)
        f.atMost("plastic work / of the cold one",
                 case.energies["total:plasticDissipation"][-1]
                 / same.energies["total:plasticDissipation"][-1], 0.95)


def test_parallel_and_restart(tmp_path, figures):
    """Two ranks give the temperatures of one; a run that was stopped goes on to
    the last bit."""
    soft = {"JohnsonCook": SOFTENS}
    one = squeezed(tmp_path/"one", soft, writeInterval=0.5)
    two = squeezed(tmp_path/"two", soft, ranks=2, writeInterval=0.5)
    half = squeezed(tmp_path/"half", soft, endTime=0.5, deltaT=1.0)
    half.set("system/controlDict", {"endTime": 1, "writeInterval": 0.5})
    half.run()
    T = temperatures(one)
    with figures("heat, ranks and restart") as f:
        f.equal("work, two ranks",
                bool(np.allclose(one.energies["total:plasticDissipation"][-1],
                                 two.energies["total:plasticDissipation"][-1],
                                 rtol=1e-10)), True)
        f.atLeast("rise of the temperature / to the melting point",
                  ((T - T0)/RANGE).min(), 0.15)
        f.equal("temperatures after a restart",
                bool((temperatures(half) == T).all()), True)


COPPER = (("adiabaticHeating", (("beta", 0.9), ("cp", 385), ("T0", 293))),)
BARS = {"cold": Tutorial("taylorBar", "2", preset=DEFAULT),
        "warm": Tutorial("taylorBar", "2", preset=DEFAULT, material=COPPER)}


@pytest.mark.scenes(*BARS.values())
def test_taylor_bar(run, figures):
    """Its law knows no temperature: heat changes nothing but itself. The foot
    gets hot enough to matter."""
    cold, warm = (run(BARS[name]) for name in ("cold", "warm"))
    T = warm.field(warm.times[-1], "rod", "pointT")[:, 0]
    a, b = (c.energies["rod:plasticDissipation"] for c in (cold, warm))
    with figures("heat in the Taylor bar, 2 elements") as f:
        f.equal("plastic work as without", bool((a == b).all()), True)
        f.within("hottest node [K]", T.max(), 900, 400)
        f.atLeast("coolest node [K]", T.min(), 293)
