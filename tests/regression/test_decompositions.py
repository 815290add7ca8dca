"""Every tutorial, on a coarse mesh and until its bodies are in contact: every
field on 2, 3 and 4 ranks is the serial one."""

import shutil

import pytest

from caseTools import Case, Tutorial, timeFolders
from smallCases import largest

# Path, mesh, end of the run [s], options of Allrun
TUTORIALS = (
    ("twoBarImpact/similar", "32", 0.2, {}),
    ("twoBarImpact/dissimilar", "32", 0.2, {}),
    ("ringCollision", "4", 0.0085, {}),
    ("nearlyIncompressibleBars", "4", 1.1e-4, {}),
    ("nonMatchingBars", "1", 8e-6, {}),
    ("nonMatchingBars", "1", 8e-6, {"PAIRING": "nearestFace"}),
    ("torusImpact", "2", 0.005, {}),
    ("torusImpact/elastoPlastic", "2", 0.005, {}),
    ("hertzContact", "2", 8e-4, {}),
    ("hertzContact", "2", 8e-4, {"SCENE": "spheres"}),
    ("selfContact", "3", 0.0035, {}),
    ("taylorBar", "2", 1e-5, {}),
    ("twistingColumn", "2", 0.02, {}),
    ("spinningCube", "3", 0.02, {}),
)
DECOMPOSITIONS = ((2, "metis"), (3, "random"), (4, "metis"))


def scene(path, mesh, end, options):
    return Tutorial(path, mesh, control=(("endTime", end),
                                         ("writeInterval", end)),
                    options=tuple(options.items()))


SCENES = [scene(*t) for t in TUTORIALS]


@pytest.mark.scenes(*SCENES)
@pytest.mark.parametrize("scene", SCENES, ids=[
    " ".join((path, *options.values())) for path, _, _, options in TUTORIALS])
def test_decompositions(run, tmp_path, figures, scene):
    serial = run(scene)
    last = timeFolders(serial.path)[-1]
    contact = list((serial/"postProcessing").glob("contactForces/*/*.dat"))
    if contact:
        assert any(serial.contact(file.stem)["area"].max() > 0
                   for file in contact)
    for ranks, method in DECOMPOSITIONS:
        case = Case(shutil.copytree(serial.path, tmp_path/f"{ranks}{method}",
                                    ignore=shutil.ignore_patterns(
                                        last, "postProcessing")))
        case.runParallel(ranks, method)
        with figures(f"{scene.path} {dict(scene.options)}, {ranks} ranks, "
                     f"{method}") as f:
            worst, where = 0, ""
            for folder in sorted((serial/last).glob("*/pointD")):
                region = folder.parent.name
                for file in sorted(folder.parent.iterdir()):
                    if not file.is_file():
                        continue
                    a, b = (c.field(last, region, file.name)
                            for c in (serial, case))
                    # A gap is a difference of positions
                    scale = serial.field(
                        last, region,
                        file.name.replace("contactGap", "pointD"))
                    error = largest(a - b)/max(largest(scale), 1e-12)
                    if error >= worst:
                        worst, where = error, f"{region} {file.name}"
            f.atMost(f"largest difference / largest value, {where}", worst,
                     1e-10)
        shutil.rmtree(case.path)
