"""Heat of plastic work, in a compressed block and in the Taylor bar; a metal
with thermal softening, compared with the equations of its law; on two ranks,
and after a restart."""

import numpy as np
import pytest

from vertexContactCases import readResults
from vertexContactTests.caseTools import DEFAULT, Tutorial
from vertexContactTests.smallCases import (Body, SmallCase, condition, largest,
                                           table)

RHO, CP, BETA, T0 = 8.0, 2.0, 0.9, 300.0
HEAT = {"beta": BETA, "cp": CP, "T0": T0}
METAL = {"type": "HenckyVonMises", "rho": RHO, "E": 1000.0, "nu": 0.3}
LINEAR = {"tauY": 1.0, "Hardening": 5.0}
SOFTENS = {"A": 1.0, "B": 5.0, "n": 1.0, "C": 0.0, "m": 1.0,
           "Tmelt": T0 + 0.03, "referenceRate": 1.0}
RANGE = SOFTENS["Tmelt"] - T0


def squeezed(folder, yields, endTime=1.0, ranks=1, **control):
    """One side of a block is pushed by a tenth of its length. The motion is
    slow: a wave needs a hundredth of the time."""
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
    """In equilibrium the whole block yields uniformly."""
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
    """Volumes of the nodes of the block (1 x 1), per metre."""
    line = np.array([0.5, 1, 1, 1, 0.5])/4
    return np.tile(np.outer(line, line).ravel(), 2)/2


def test_softer_when_warm(tmp_path, figures):
    """With heat the block bears less than without, by the factor of its
    temperature."""
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


# Exponents other than 1, and a room that is colder than the block
TIME, STRETCH = 100.0, 0.3
HARDENS = {"A": 1.0, "B": 3.0, "n": 0.4, "referenceRate": 1e-4}
THERMAL = {"m": 1.3, "Tmelt": T0 + 0.1, "Troom": T0 - 0.02}


def uniaxial(folder, stretch, law):
    """A cube of one cell is slowly extended or compressed between planes; its
    sides are free. The sides continue to vibrate, since they are accelerated
    when the cube begins to yield."""
    end = condition("fixedDisplacement", components=("x",), displacement=table(
        (0, (0, 0, 0)), (TIME, (stretch, 0, 0))))
    body = Body(cells=(1, 1, 1), material={
        **METAL, "JohnsonCook": law, "adiabaticHeating": HEAT},
        velocity=lambda X: stretch/TIME*X*np.array(
            (1, -METAL["nu"], -METAL["nu"])),
        sides={**dict.fromkeys(("left", "bottom", "back"), "symmetryPlane"),
               "right": end})
    return SmallCase(folder, body, TIME, preset=DEFAULT,
                     functions=("reactionForces",)).run()


def uniaxialTheory(stretch, law, steps=4000):
    """The same from the equations of the law, by implicit steps: times,
    Kirchhoff stress (with logarithmic strains it is E times the elastic
    strain), plastic strain and temperature."""
    E = METAL["E"]
    t = np.linspace(0, TIME, steps + 1)
    e, T, rows = 0.0, T0, [(0, 0, T0)]
    for before, now in zip(t, t[1:]):
        strain = abs(np.log1p(stretch*now/TIME))

        def excess(d):
            heated = T + BETA/(RHO*CP)*E*(strain - e - d)*d
            hot = max(heated - law["Troom"], 0)/(law["Tmelt"] - law["Troom"])
            rate = max(d/(now - before)/law["referenceRate"], 1)
            return E*(strain - e - d) - (
                (law["A"] + law["B"]*(e + d)**law["n"])
                * (1 + law["C"]*np.log(rate))*(1 - hot**law["m"]))
        low, high = 0.0, strain - e
        for _ in range(50):
            middle = (low + high)/2
            low, high = ((middle, high) if excess(middle) > 0 else
                         (low, middle))
        d = low if excess(0.0) > 0 else 0.0
        tau = E*(strain - e - d)
        e, T = e + d, T + BETA/(RHO*CP)*tau*d
        rows.append((tau, e, T))
    tau, e, T = np.array(rows).T
    return t, np.sign(stretch)*tau, e, T


@pytest.mark.parametrize("C", (0.0, 0.1))
@pytest.mark.parametrize("stretch", (-STRETCH, STRETCH),
                         ids=("squeezed", "drawn"))
def test_uniaxial_stress(tmp_path, figures, stretch, C):
    """Force, plastic strain and temperature of a yielding bar, with the
    complete law of Johnson and Cook and heat, agree with its equations, with
    and without rate dependence. The bar bears less than one without
    softening."""
    law = {**HARDENS, "C": C, **THERMAL}
    warm = uniaxial(tmp_path/"warm", stretch, law)
    cold = uniaxial(tmp_path/"cold", stretch, {**HARDENS, "C": C})
    r = readResults.table(warm.path, "reactionForces", "reactions.dat")
    t, tau, e, T = uniaxialTheory(stretch, law)
    # The force acts around the start of the step, on the area at the start
    when, found = r["Time"][:-1], r["body.right:Fx"][1:]
    theory = np.interp(when, t, tau)/(1 + stretch*when/TIME)
    parts = np.array_split(np.arange(len(when)), 10)[1:]
    J = np.exp((1 - 2*METAL["nu"])*tau[-1]/METAL["E"])
    q, cool = (c.at("sigmaEq") for c in (warm, cold))
    work = warm.energies["total:plasticDissipation"]
    with figures(f"Johnson and Cook with heat, uniaxial, {stretch}, C {C}"
                 ) as f:
        f.atMost("mean force of a tenth / theory - 1, largest", max(
            abs(found[part].sum()/theory[part].sum() - 1) for part in parts),
            1e-3)
        f.atMost("equivalent stress at the end / theory - 1",
                 largest(q*J/abs(tau[-1]) - 1), 1e-3)
        f.atMost("plastic strain / theory - 1",
                 largest(warm.at("epsilonPEq")/e[-1] - 1), 1e-3)
        f.atMost("rise of the temperature / theory - 1",
                 largest((warm.at("pointT") - T0)/(T[-1] - T0) - 1), 1e-3)
        f.atMost("balance of the energy / plastic work",
                 largest(warm.energies["total:balance"])/work[-1], 1e-3)
        f.atLeast("share of the way to the melting point",
                  (T[-1] - law["Troom"])/(law["Tmelt"] - law["Troom"]), 0.3)
        f.atMost("stress / of the cold one", q.max()/cool.min(), 0.85)


def test_parallel_and_restart(tmp_path, figures):
    """Two ranks give the temperatures of one. A restarted run is equal to the
    last bit."""
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


# Copper as with HEAT=1, with the same yield stress as long as it is cold
SOFT_COPPER = (("tauY", None), ("Hardening", None), ("JohnsonCook", (
    ("A", 0.4e9), ("B", 0.1e9), ("n", 1), ("C", 0), ("m", 1.09),
    ("Tmelt", 1356))),
    ("adiabaticHeating", (("beta", 0.9), ("cp", 385), ("T0", 293))))
BARS = {name: Tutorial("taylorBar", "2", preset=DEFAULT, **more)
        for name, more in (("cold", {}), ("warm", {"options": (("HEAT", "1"),)}),
                           ("soft", {"material": SOFT_COPPER}))}


@pytest.mark.scenes(*BARS.values())
def test_taylor_bar(run, figures):
    """The law of the tutorial does not depend on the temperature: heat changes
    only the temperature. The foot becomes hot enough to matter: with a law
    that depends on it, the bar ends shorter and its foot wider."""
    cold, warm, soft = (run(bar) for bar in BARS.values())
    T, Tsoft = (c.field(c.times[-1], "rod", "pointT")[:, 0]
                for c in (warm, soft))
    a, b, c = (bar.energies["rod:plasticDissipation"]
               for bar in (cold, warm, soft))
    length, foot = (
        [1e3*case.probe(point, "pointD")[1][-1, k] for case in (cold, soft)]
        for point, k in (("pointTop", 1), ("pointRim", 0)))
    with figures("heat in the Taylor bar, 2 elements") as f:
        f.equal("plastic work as without", bool((a == b).all()), True)
        f.within("hottest node [K]", T.max(), 900, 400)
        f.atLeast("coolest node [K]", T.min(), 293)
        f.within("soft, hottest node [K]", Tsoft.max(), 900, 400)
        f.within("soft, plastic work / as without", c[-1]/a[-1], 1, 0.02)
        f.within("soft, shorter by [mm]", length[0] - length[1], 0.17, 0.1)
        f.within("soft, foot wider by [mm]", foot[1] - foot[0], 0.32, 0.15)
