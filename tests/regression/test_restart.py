"""A run that is continued from a written time is the straight run."""

import shutil

import numpy as np
import pytest

from caseTools import Case, Scene, checked, timeFolders

SCENES = {
    "1D": Scene("dissimilar", elements=64,
                control=(("endTime", 0.25), ("writeInterval", 0.05))),
    "2D": Scene("similar", elements=32, dimensions=2, across=3,
                control=(("endTime", 0.25), ("writeInterval", 0.05))),
}


def contents(folder):
    return {file.relative_to(folder): file.read_bytes()
            for file in folder.rglob("*") if file.is_file()}


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
