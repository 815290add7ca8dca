"""A rigid stamp presses a block of metal with a given force. The block bears
as much as Prandtl's half space."""

import numpy as np
import pytest

from vertexContactCases import prandtl
from vertexContactCases.readResults import probe
from vertexContactTests.caseTools import DEFAULT, Tutorial
from vertexContactTests.smallCases import Body, SmallCase, condition


def impulse(times, F, at):
    """Integral of a force from the start to given times."""
    sums = np.append(0, np.cumsum(np.diff(times)*(F[1:] + F[:-1])/2))
    return np.interp(at, times, sums)


MESHES = tuple(Tutorial("formingTool", mesh, preset=DEFAULT)
               for mesh in ("I", "12"))


@pytest.mark.scenes(*MESHES)
@pytest.mark.parametrize("scene", MESHES, ids=("I", "12"))
def test_limit(run, figures, scene):
    case = run(scene)
    contact = case.contact("imprint")
    t, F = contact["Time"], contact["stamp.surface:Fy"]
    flows = (t > 140e-6) & (t < 175e-6)
    times, way = probe(case.path, "stamp", "pointD")
    depth = -way[:, 1]
    E = case.energies
    with figures(f"stamp on a block, Mesh {scene.mesh}") as f:
        # The edge of the stamp is within cells
        f.within("force while the block flows / Prandtl's limit",
                 F[flows].mean()/prandtl.LIMIT, *{
                     "I": (1.11, 0.02), "12": (1.055, 0.02)}[scene.mesh])
        f.atLeast("force on the stamp / that limit",
                  prandtl.force(t).max()/prandtl.LIMIT, 1.3)
        # The block takes up the impulse of the force
        v = np.gradient(depth, times)
        f.atMost("momentum of the stamp less impulses / largest impulse",
                 np.abs(impulse(t, prandtl.force(t) - F, times)
                        - prandtl.MASS*v)[2:-2].max()
                 / impulse(t, F, times).max(), 0.005)
        f.atMost("plastic work / work of the force",
                 E["total:plasticDissipation"][-1]
                 / E["total:externalWork"].max(), 1)
        f.atMost("residual of the energy balance / work of the force",
                 np.abs(E["total:balance"]).max()
                 / E["total:externalWork"].max(), 1e-4)


@pytest.mark.parametrize("dimensions", (2, 3))
def test_punch(tmp_path, figures, dimensions):
    """A punch at a twentieth of the speed of sound flattens a plate of a few
    cells, whose surface becomes several times as large. Contact gives no
    energy, and results do not depend on the step."""
    held = condition("fixedVelocity", velocity=(0, 0, 0))
    mirrors = {"left": "symmetryPlane"}
    plate = dict(mirrors, right=held, top="contact", bottom="slip")
    punch = dict(mirrors, right="contact", bottom="contact")
    if dimensions == 3:
        mirrors["back"] = plate["back"] = punch["back"] = "symmetryPlane"
        plate["front"], punch["front"] = held, "contact"
    wide = 1 if dimensions == 2 else 10
    cells = {2: (32, 4), 3: (16, 2, 14)}[dimensions]
    flowed = {}
    for maxCo in 0.3, 0.9:
        case = SmallCase(
            tmp_path/f"{maxCo}",
            (Body(cells, "plate", (0, -1, 0),
                  (10, 1, wide), plate,
                  {"type": "HenckyVonMises", "rho": 1, "E": 1, "nu": 0.33,
                   "tauY": 0.003, "Hardening": 0.003}),
             Body((4, 12, 4)[:dimensions], "punch", (0, 0, 0),
                  (3.3, 12, min(wide, 3.3)), punch,
                  {"type": "neoHookean", "rho": 3, "E": 3, "nu": 0.3},
                  velocity=(0, -0.05, 0))),
            24, preset="fast", control={"maxCo": maxCo},
            interfaces={"hit": {
                "surfaces": (("plate", "top"), ("punch", '".*"')),
                "self": "no", "law": {"type": "frictionless"}}}).run()
        E = case.energies
        first = E["total:kinetic"][0]
        flowed[maxCo] = E["total:plasticDissipation"][-1]/first
        with figures(f"punch on a plate, {dimensions}D, maxCo {maxCo}") as f:
            f.within("work of contact / energy",
                     E["total:contactWork"][-1]/first, 0, 1e-3)
            f.within("residual of the energy balance / energy",
                     E["total:balance"][-1]/first, 0, 2e-3)
    with figures(f"punch on a plate, {dimensions}D") as f:
        f.atLeast("plastic work / energy", flowed[0.3], 0.25)
        f.within("the same with steps three times as long, over it",
                 flowed[0.9]/flowed[0.3], 1, 0.03)
