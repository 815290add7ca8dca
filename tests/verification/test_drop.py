"""Drop test of a box on rubber feet: against a mass on a spring, and with a box
that is rigid."""

import numpy as np
import pytest

from vertexContactCases import bumperModel
from vertexContactCases.readResults import table
from vertexContactTests.caseTools import DEFAULT, Tutorial

DROP = "dropTest"
ELASTIC, RIGID = (
    Tutorial(DROP, "I", options=(("BOX", box),), preset=DEFAULT)
    for box in ("elastic", "rigid"))
OWN_STEPS = Tutorial(DROP, "I", preset=DEFAULT,
                     options=(("BOX", "elastic"), ("STEPS", "own")))


def floor(case):
    return case.contact("floor")


def away(case):
    """Velocity at the end over the velocity at the start, upwards."""
    p = case.momentum["total:pz"]
    return -p[-1]/p[0]


@pytest.mark.scenes(ELASTIC, RIGID)
@pytest.mark.parametrize("scene, peak", ((RIGID, 0.08), (ELASTIC, 0.1)),
                         ids=("rigid", "elastic"))
def test_drop(run, figures, scene, peak):
    case, model = run(scene), bumperModel.drop()
    F, t = floor(case)["bumper.bottom:Fz"], floor(case)["Time"]
    smooth = floor(case)["bumper.bottom:filteredFz"]
    E = case.totalEnergy
    with figures(f"drop test, {dict(scene.options)['BOX']} box") as f:
        f.within("peak force of the floor / mass on a spring",
                 F.max()/model.forces.max(), 1, peak)
        f.within("duration / mass on a spring",
                 np.ptp(t[F > 0])/model.duration, 1, 0.05)
        f.within("impulse of the filtered force / of the force",
                 np.trapezoid(smooth, t)/np.trapezoid(F, t), 1, 0.02)
        f.atMost("energy at most / initial - 1", E.max()/E[0] - 1, 1e-3)
        f.atMost("residual of the energy balance / initial",
                 np.abs(case.energies["total:balance"]).max()/E[0], 2e-3)


@pytest.mark.scenes(ELASTIC, RIGID)
def test_rigid_as_elastic(run, figures):
    """The stiff box may be rigid. It then has no stress, and needs a tenth of
    the steps, since the rubber determines the step."""
    elastic, rigid = run(ELASTIC), run(RIGID)
    peaks = table(elastic.path, "peaks", "extremes.dat")
    stress = peaks["box:sigmaEq:max"]
    at = stress.argmax()
    with figures("drop test, rigid and elastic box") as f:
        f.within("peak force, rigid / elastic",
                 floor(rigid)["bumper.bottom:Fz"].max()
                 / floor(elastic)["bumper.bottom:Fz"].max(), 1, 0.05)
        f.within("speed away, rigid / elastic", away(rigid)/away(elastic), 1,
                 0.03)
        f.within("peak stress in the box [MPa]", stress[at]/1e6, 0.45, 0.1)
        f.within("where: above the floor [mm]",
                 1e3*peaks["box:sigmaEq:max:Z"][at], 8.1, 0.01)
        f.within("when [ms]", 1e3*peaks["box:sigmaEq:max:time"][at], 1.1, 0.2)


@pytest.mark.scenes(ELASTIC, OWN_STEPS)
def test_steps_of_their_own(run, figures):
    """With subCycling, rubber and box each take their own stable step. The
    result is that of one step, but the longer steps of the rubber dissipate
    slightly more energy."""
    one, own = run(ELASTIC), run(OWN_STEPS)
    F, t = ([floor(case)[name] for case in (own, one)]
            for name in ("bumper.bottom:Fz", "Time"))
    peaks = [table(case.path, "peaks", "extremes.dat")["box:sigmaEq:max"].max()
             for case in (own, one)]
    with figures("drop test, own steps / one step") as f:
        f.within("peak force", F[0].max()/F[1].max(), 1, 0.03)
        f.within("duration", np.ptp(t[0][F[0] > 0])/np.ptp(t[1][F[1] > 0]), 1,
                 0.01)
        f.within("speed away", away(own)/away(one), 1, 0.015)
        f.within("peak stress in the box", peaks[0]/peaks[1], 1, 0.04)
        f.within("energy at the end", own.totalEnergy[-1]/one.totalEnergy[-1],
                 1, 0.03)
        f.atMost("residual of the energy balance / initial, own steps",
                 np.abs(own.energies["total:balance"]).max()
                 / own.totalEnergy[0], 4e-3)
