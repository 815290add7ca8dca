"""ParaView shows the tutorials correctly. VTK's reader of OpenFOAM cases,
which ParaView uses, opens the case.foam of Allrun, serial and decomposed."""

import shutil
import sys

import numpy as np
import pytest
from PIL import Image

from vertexContactCases.readFields import Reader, deformed
from vertexContactCases.renderCase import Scene
from vertexContactTests import caseTools
from vertexContactTests.caseTools import (TUTORIALS, Case, checked, coarse,
                                          timeFolders)

SHORT = 1/20        # of the length of the user's run
VTK_ORDER = [0, 3, 5, 1, 4, 2]      # XX YY ZZ XY YZ XZ
DECOMPOSED = ("twoBarImpact/similar", "ringCollision", "hertzContact",
              "torusImpact/elastoPlastic", "spinningCube")
RENDER = [sys.executable, "-B", str(caseTools.root/"tutorials"/"renderCase.py")]


def prepare(tutorial, folder):
    """The case after a short run with two written times."""
    tutorials = caseTools.copyTutorials(folder/"tutorials")
    case = Case(tutorials/tutorial)
    control = case/"system"/"controlDict"
    end = None
    for line in control.read_text().splitlines():
        if line.startswith("endTime "):
            end = SHORT*float(line.split()[1].rstrip(";"))
    case.set("system/controlDict", {"endTime": end, "writeInterval": end/2})
    return case


def colours(file):
    """The size of a picture, and the share of pixels that are not white."""
    with Image.open(file) as image:
        pixels = np.asarray(image.convert("RGB"))
    return pixels.shape, np.mean(np.any(pixels < 250, axis=2)), len(
        np.unique(pixels.reshape(-1, 3), axis=0))


def written(case, time, region):
    """Names of the point fields of a region."""
    return sorted(file.name for file in (case/time/region).iterdir()
                  if file.is_file())


def compare(f, case, region, body, time, decomposed):
    """The points and all point fields of a region."""
    points = case.points(region)
    size = np.ptp(points, axis=0).max()
    # VTK has single precision; points that several ranks share appear on each
    # of them
    X = np.asarray(body.points, dtype=float)
    index = np.arange(len(points))
    if decomposed:
        distance = np.linalg.norm(points[:, None] - X[None], axis=2)
        index = distance.argmin(axis=0)
    f.equal(f"{region}: points found", len(np.unique(index)), len(points))
    names = written(case, time, region)
    f.equal(f"{region}: point fields, with as many values",
            len([name for name in body.point_data.keys()
                 if len(body[name]) == len(X)]), len(names))
    worst, where = np.abs(X - points[index]).max()/size, "points"
    for name in names:
        ours = case.field(time, region, name)[index]
        # VTK does not reorder the components of uniform fields
        if ours.shape[1] == 6 and np.ptp(ours, axis=0).any():
            ours = ours[:, VTK_ORDER]
        found = np.asarray(body[name], dtype=float).reshape(ours.shape)
        error = np.abs(found - ours).max()/max(np.abs(ours).max(), 1e-30)
        if error > worst:
            worst, where = error, name
    f.atMost(f"{region}: largest difference / largest value, {where}", worst,
             1e-6)
    now = points[index] + case.field(time, region, "pointD")[index]
    f.atMost(f"{region}: deformed points, difference / size",
             np.abs(deformed(body).points - now).max()/size, 1e-6)
    assert decomposed or len(X) == len(points)


def check(f, case, decomposed):
    """All values of all point fields at the last time."""
    reader = Reader(case.path, decomposed)
    last = timeFolders(case.path)[-1]
    regions = sorted(file.parent.parent.name for file in
                     case.path.glob("constant/*/polyMesh/points"))
    f.equal("regions", sorted(reader.regions), regions)
    f.within("last time [s]", reader.times[-1], float(last), 1e-9*float(last))
    for region, body in reader.read(reader.times[-1]).items():
        compare(f, case, region, body, last, decomposed)


def render(f, case, decomposed):
    file = case/"render.png"
    Scene(case.path, decomposed=decomposed).draw(file)
    shape, filled, number = colours(file)
    f.equal("width of the picture", shape[1], 640)
    f.atLeast("pixels that are not white", filled, 0.05)
    f.atLeast("colours", number, 50)


@pytest.mark.parametrize("tutorial", TUTORIALS)
def test_tutorial(tmp_path, figures, tutorial):
    parallel = tutorial in DECOMPOSED
    case = prepare(tutorial, tmp_path)
    checked(["./Allrun"], case.path, **coarse(tutorial), PLOT="0",
            NP="3" if parallel else "1")
    assert (case/"case.foam").exists()
    for decomposed in (False, True) if parallel else (False,):
        kind = ", decomposed" if decomposed else ""
        with figures(f"ParaView: {tutorial}{kind}") as f:
            check(f, case, decomposed)
            render(f, case, decomposed)


def test_picture_of_a_tutorial(tmp_path):
    """Run makePictures for one tutorial."""
    tutorials = caseTools.copyTutorials(tmp_path/"tutorials")
    name = "spinningCube"
    checked([str(tutorials/"makePictures"), name], tmp_path)
    shape, filled, number = colours(tutorials/name/"picture.png")
    assert shape[1] == 640 and filled > 0.05 and number > 50


def test_pictures_are_kept():
    """Each tutorial has its picture in its README, small enough for git.
    Allrun and Allclean do not change it."""
    for tutorial in TUTORIALS:
        folder = caseTools.root/"tutorials"/tutorial
        assert (folder/"picture.png").stat().st_size < 60e3
        assert "(picture.png)" in (folder/"README.md").read_text()
    strip = caseTools.root/"tutorials"/"pictures.png"
    assert strip.stat().st_size < 250e3
    assert (strip.parent/"collision.gif").stat().st_size < 1e6


def test_allclean_keeps_the_picture(tmp_path):
    tutorials = caseTools.copyTutorials(tmp_path/"tutorials")
    case = tutorials/"spinningCube"
    shutil.copy(caseTools.root/"tutorials"/"spinningCube"/"picture.png", case)
    (case/"histories.png").touch()
    checked(["./Allclean"], case)
    assert [file.name for file in case.glob("*.png")] == ["picture.png"]


def test_command(tmp_path):
    """renderCase.py, called as a user calls it."""
    case = prepare("ringCollision", tmp_path)
    checked(["./Allrun"], case.path, **coarse("ringCollision"), PLOT="0",
            NP="2")
    checked([*RENDER, "-f", "pointU", "-c", "0", "-t", "0.001", "0.002",
             "-o", "two.png", "-d"], case.path)
    assert colours(case/"two.png")[0][1] == 640


def test_no_case(tmp_path):
    done = caseTools.execute(RENDER, tmp_path)
    assert done.returncode != 0 and "is not a case" in done.stdout
    assert "Traceback" not in done.stdout
