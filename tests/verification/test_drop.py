"""Drop test of a box on rubber feet: against a mass on a spring, and with a box
that is rigid."""

import numpy as np
import pytest

import bumperModel
from caseTools import DEFAULT, Tutorial
from readResults import table

DROP = "dropTest"
ELASTIC, RIGID = (
    Tutorial(DROP, "I", options=(("BOX", box),), preset=DEFAULT)
    for box in ("elastic", "rigid"))


def floor(case):
    return case.contact("floor")


def away(case):
    """Velocity at the end / at the start, upwards."""
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
    """A stiff box may be rigid: that has no stress, and a tenth of the steps,
    since the rubber sets them."""
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
