"""A run that is continued from a written time is the straight run."""

import shutil

import numpy as np
import pytest

from vertexContactTests.caseTools import (DEFAULT, PRESET, Case, Scene,
                                          checked, contents, differingFiles,
                                          runAgain, solver, timeFolders)
from vertexContactTests.collisions import END, SCENES as COLLISIONS, collision
from vertexContactTests.smallCases import (RUBBER, Body, SmallCase, condition,
                                           interface, table, turned)

SCENES = {
    "1D": Scene("dissimilar", elements=64, preset=DEFAULT,
                control=(("endTime", 0.25), ("writeInterval", 0.05))),
    "2D": Scene("similar", elements=32, dimensions=2, across=3, preset=DEFAULT,
                control=(("endTime", 0.25), ("writeInterval", 0.05))),
}


@pytest.mark.scenes(*SCENES.values())
@pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES.keys())
def test_restart_in_contact(run, tmp_path, figures, scene):
    straight = run(scene)
    case = Case(shutil.copytree(straight.path, tmp_path/"case"))
    shutil.rmtree(case/"postProcessing")
    for time in timeFolders(case.path):
        if float(time) > 0.15:
            shutil.rmtree(case/time)
    checked(["vertexContactFoam"], case.path)

    expected, found = contents(straight/"0.25"), contents(case/"0.25")
    assert expected.keys() == found.keys()
    different = [str(f) for f in expected if expected[f] != found[f]]
    with figures(f"restart at 0.15 s, {len(expected)} files") as f:
        f.equal("files that differ at 0.25 s", different, [])
        for name, tables in (
                ("energies.dat", (straight.energies, case.energies)),
                ("momentum.dat", (straight.momentum, case.momentum))):
            a, b = tables
            late = np.isin(a["Time"], b["Time"])
            f.equal(f"{name}: rows after 0.15 s that are missing",
                    int(np.sum(~late & (a["Time"] > 0.15*(1 + 1e-9)))), 0)
            differing = [
                key for key in a if not np.array_equal(
                    a[key][late], b[key][np.isin(b["Time"], a["Time"])])]
            f.equal(f"{name}: columns that differ", differing, [])


@pytest.mark.parametrize("ranks", (1, 2))
@pytest.mark.parametrize("name", COLLISIONS)
def test_restart_of_collision(tmp_path, figures, name, ranks):
    """After a restart in contact all files of the last time are equal bit by
    bit. In parallel this holds for the files of each rank."""
    case = collision(tmp_path/"case", name, preset=DEFAULT)
    (expected, (contact, energies)), (found, (_, again)) = runAgain(
        case, ranks, lambda case, _: (case.contact("contact"), case.energies))
    middle = END/2
    at = np.abs(contact["Time"] - middle).argmin()
    assert contact["area"][at] > 0
    with figures(f"{name}, {ranks} ranks: restart at {middle} s") as f:
        f.equal("files that differ", differingFiles(expected, found), [])
        f.atMost("largest difference of the last energies / initial", max(
            abs(energies[key][-1] - again[key][-1]) for key in energies)
            / energies["total:kinetic"][0], 0 if ranks == 1 else 1e-14)
        f.atLeast("files compared", len(expected[0]), 8)


def test_restart_of_a_time_whose_name_is_cut(tmp_path, figures):
    """If timePrecision cannot distinguish two times, their names get more
    digits. A run that continues from one of these times may add still more
    digits. All results are equal bit by bit, including the records beside the
    fields."""
    interval = 4/3
    bar = Body((8,), velocity=lambda X: 0.05*X*(1, 0, 0))
    spinning = Body((2, 2), name="spinning", start=(2, 0, 0),
                    material={"type": "rigid", "rho": 1},
                    velocity=lambda X: np.cross((0, 0, 1), X))
    case = SmallCase(tmp_path, [bar, spinning], 9*interval, control={
        "timePrecision": 6, "writeInterval": interval}, preset=DEFAULT)
    ((expected,), energies), ((found,), again) = runAgain(
        case, 1, lambda case, _: case.energies)
    times = timeFolders(case.path)
    with figures(f"restart of one of the times {' '.join(times)}") as f:
        f.atLeast("digits of the longest name", max(map(len, times)), 8)
        f.equal("files that differ", differingFiles([expected], [found]), [])
        f.equal("energies that differ", [
            key for key in energies if energies[key][-1] != again[key][-1]], [])


def test_restart_of_own_steps_and_motions(tmp_path, figures):
    """With subCycling the written state of a region is older than the written
    time, by a different interval for each region. After a restart, prescribed
    motions continue from the right positions."""
    fast = table((0, (0, 0, 0)), (10, (0.2, 0, 0)))
    stiff = Body((4, 4), name="stiff", material=dict(RUBBER, E=400),
                 sides={"right": "contact", "left": condition(
                     "fixedDisplacement", displacement=fast)},
                 velocity=(0.02, 0, 0))
    soft = Body((4, 4), name="soft", start=(1, 0, 0),
                sides={"left": "contact", "right": "contact"})
    tool = Body((4, 4), name="tool", start=(2.1, 0, 0),
                sides={"left": "contact"}, material={
                    "type": "rigid", "rho": 1, "motion": {
                        "displacement": table((0, (0, 0, 0)),
                                              (10, (-1, 0, 0)))}})
    case = SmallCase(
        tmp_path, [stiff, soft, tool], 2, preset=DEFAULT,
        interfaces={"bars": interface(("stiff", "right"), ("soft", "left")),
                    "press": interface(("soft", "right"), ("tool", "left"))},
        control={"subCycling": "yes", "writeInterval": 0.5})
    ((expected,), _), ((found,), _) = runAgain(case)
    with figures("restart, steps of their own, prescribed motions") as f:
        f.equal("files that differ", differingFiles([expected], [found]), [])


@pytest.mark.parametrize("preset", (PRESET, DEFAULT))
def test_restart_with_oblique_mirror(tmp_path, figures, preset):
    """The velocity normal to a mirror has the round-off of the run, which the
    restart keeps. Otherwise it differs from the straight run in the last
    bit."""
    body = Body((3, 3), sides={"top": "slip"}, velocity=lambda X: 0.1*np.stack(
        (np.sin(3*X[:, 1]), 0.5*X[:, 0], 0*X[:, 0]), axis=1),
                moved=lambda X: turned(X, (0, 0, 1), 0.5))
    case = SmallCase(tmp_path, body, 0.6, preset=preset,
                     control={"writeInterval": 0.15})
    ((expected,), _), ((found,), _) = runAgain(case)
    with figures(f"restart with an oblique mirror, preset {preset}") as f:
        f.equal("files that differ", differingFiles([expected], [found]), [])
        f.atLeast("files compared", len(expected), 8)


@pytest.mark.parametrize("regions", (1, 2))
def test_restart_on_other_ranks(tmp_path, figures, regions):
    """A serial run continues on two ranks, and this run continues in serial.
    The results equal those of the straight run. decomposePar keeps the record
    of the run only if there are several regions; without the record,
    velocities are half a step off."""
    bodies = [
        Body((4, 3), name=f"body{i}", start=(1.5*i, 0, 0), material=RUBBER,
             velocity=lambda X: np.stack(
                 (0.1*X[:, 1], 0.05*X[:, 0], 0*X[:, 0]), axis=1))
        for i in range(regions)]

    def until(case, time, ranks):
        case.set("system/controlDict", {"endTime": time})
        if ranks == 1:
            checked(["vertexContactFoam"], case.path)
            return
        case.decompose(ranks)
        checked(solver(ranks), case.path)
        checked(["reconstructPar", "-allRegions", "-newTimes"], case.path)

    straight = SmallCase(tmp_path/"straight", bodies, 3, preset=DEFAULT,
                         control={"writeInterval": 1,
                                  "startFrom": "latestTime"}).run()
    case = Case(shutil.copytree(straight.path, tmp_path/"case"))
    for time in "1", "2", "3":
        shutil.rmtree(case/time)
    shutil.rmtree(case/"postProcessing")
    for time, ranks in (1, 1), (2, 2), (3, 1):
        until(case, time, ranks)
    with figures(f"{regions} regions, on one rank, on two, on one") as f:
        for body in bodies:
            for name in "pointD", "pointU":
                a, b = (c.field("3", body.name, name) for c in (straight, case))
                f.atMost(f"{name} of {body.name}: difference / largest",
                         abs(a - b).max()/abs(a).max(), 1e-12)
