"""Many regions. Regions without a file of their own use the file of the case,
and the results are equal to the last bit. Each region can be on one rank as a
whole."""

import re
import shutil

import numpy as np
import pytest

from vertexContactTests.caseTools import (DEFAULT, Case, checked, contents,
                                          differingFiles, execute, timeFolders)
from vertexContactTests.smallCases import (RUBBER, Body, SmallCase, condition,
                                           coulomb)

STIFF = {**RUBBER, "E": 4}
NAMES = "b1", "b2", "b3"
PUSH = {"push": {"type": "uniform", "acceleration": (0.01, 0, 0)}}


def collision(folder, rigid=False):
    """Three blocks in a row with gaps between them. The second one is stiffer,
    or rigid."""
    touching = {"left": "contact", "right": "contact"}
    soft = {"forces": PUSH, "scheme": {"correction": 0.2}, "sides": {
        **touching, "top": condition("traction", traction=(0, -0.01, 0))}}
    kinds = dict.fromkeys(NAMES, {"material": RUBBER, **soft})
    kinds["b2"] = {"material": {"type": "rigid", "rho": 1},
                   "sides": touching} if rigid else {"material": STIFF, **soft}
    bodies = [
        Body(cells=(3, 3), name=name, start=(1.02*i, 0, 0),
             velocity=(0.05, 0.01, 0), **kinds[name])
        for i, name in enumerate(NAMES)]
    return SmallCase(
        folder, bodies, 2.0, preset=DEFAULT, functions=("contactForces",),
        interfaces={"all": {"surfaces": "all", "law": coulomb(0.2)}})


def share(case):
    """Remove from the regions the files that the case can have for all."""
    pointU = case.path/"0/b1/pointU"
    text = pointU.read_text()
    start, end = text.index("nonuniform"), text.index("boundaryField")
    pointU.write_text(text[:start] + "uniform (0.05 0.01 0);\n" + text[end:])
    shutil.move(pointU, case.path/"0/pointU")
    shutil.move(case.path/"constant/b1/bodyForces",
                case.path/"constant/bodyForces")
    shutil.copy(case.path/"system/b1/fvSchemes", case.path/"system/fvSchemes")
    for name in NAMES:
        for file in (f"0/{name}/pointU", f"constant/{name}/bodyForces",
                     f"constant/{name}/mechanicalProperties"):
            (case.path/file).unlink(missing_ok=True)
        # OpenFOAM's tools need the file, even without our dictionary
        case.dictionary(f"system/{name}/fvSchemes", {
            f"{kind}Schemes": {} for kind in ("ddt", "grad", "div", "laplacian",
                                              "interpolation", "snGrad")})
    case.dictionary("constant/solidProperties",
                    {'"b.*"': RUBBER, "b2": STIFF})


def results(folders):
    """Contents of the last time of each folder."""
    return [contents(folder/timeFolders(folder)[-1]) for folder in folders]


def differing(a, b, parts=(".",)):
    return differingFiles(results(a.path/part for part in parts),
                          results(b.path/part for part in parts))


def test_same_results(tmp_path):
    """Names have precedence over expressions: b2 is the stiff block."""
    own = collision(tmp_path/"own").run()
    shared = collision(tmp_path/"shared")
    share(shared)
    shared.run()
    assert differing(own, shared) == []


def test_what_regions_have_in_common_is_reported_once(tmp_path):
    """A region that is as one before is one line of the log. Of the stiff block
    only what differs is there."""
    _, log = collision(tmp_path).attempt()
    first, second = log.split("\nRegion ")[1:3]
    assert first.startswith("b1\n") and "dual mesh" in first
    assert second.startswith("b2, otherwise as b1\n    material neoHookean")
    assert "largest frequency" in second and "dual mesh" not in second
    assert "\nRegion b3, as b1\n\nInterface" in log


def test_on_two_ranks(tmp_path):
    """decomposePar does not know shared files. They are found in the folder of
    the case."""
    own, shared = collision(tmp_path/"own"), collision(tmp_path/"shared")
    share(shared)
    for case in own, shared:
        case.runParallel(2)
    assert differing(own, shared, ("processor0", "processor1")) == []


STRETCH = np.array((1.02, 0.01, 0, 0, 0.99, 0, 0, 0, 1))


@pytest.mark.parametrize("ranks", (1, 2))
def test_shared_start(tmp_path, ranks):
    """A start field of the case applies to regions that have no such field and
    whose law accepts it. Here b2 is rigid, and b3 has its own field."""
    own, shared = (collision(tmp_path/name, rigid=True)
                   for name in ("own", "shared"))
    for case in own, shared:
        for body in case.bodies:
            F0 = STRETCH if body.name == "b1" else 2*np.eye(3).ravel()/1.98
            if body.name == "b3" or (case is own and body.name == "b1"):
                case.writePointField(
                    body, "F0", "[0 0 0 0 0 0 0]",
                    np.tile(F0, (len(case.X(body.name)), 1)), kind="tensor")
    value = " ".join(str(c) for c in STRETCH)
    shared.write("0/F0", "pointTensorField",
                 "dimensions [0 0 0 0 0 0 0];\n"
                 f"internalField uniform ({value});\nboundaryField {{}}")
    for case in own, shared:
        case.run() if ranks == 1 else case.runParallel(ranks)
    parts = (".",) if ranks == 1 else ("processor0", "processor1")
    assert differing(own, shared, parts) == []
    last = shared.path/parts[0]/timeFolders(shared.path/parts[0])[-1]
    assert (last/"b1/F0").exists() and not (last/"b2/F0").exists()


def test_bad_shared_start(tmp_path):
    """The error names the shared field as the user wrote it."""
    case = collision(tmp_path/"case")
    case.write("0/pointD", "pointVectorField",
               "dimensions [0 0 0 0 0 0 0];\n"
               "internalField uniform (0 0 0);\nboundaryField {}")
    message = refused(case)
    assert "0/pointD" in message and "dimensions" in message


def test_restart(tmp_path):
    """A written time has fields for each region, and a restarted run uses
    them."""
    whole = collision(tmp_path/"whole")
    share(whole)
    shutil.copytree(whole.path, tmp_path/"parts")
    parts = Case(tmp_path/"parts")
    for case, ends in (whole, (2,)), (parts, (1, 2)):
        case.set("system/controlDict", {"writeInterval": 1})
        for end in ends:
            case.set("system/controlDict", {"endTime": end})
            assert execute(["vertexContactFoam"], case.path).returncode == 0
    assert differing(whole, parts) == []


def refused(case):
    done = execute(["vertexContactFoam"], case.path)
    assert done.returncode
    return done.stdout


def test_no_material(tmp_path):
    case = collision(tmp_path/"case")
    share(case)
    case.dictionary("constant/solidProperties", {"b1": RUBBER, "b2": RUBBER})
    message = refused(case)
    for part in ("solidProperties", "No entry is for region 'b3'", "(b1 b2)",
                 "constant/b3/mechanicalProperties"):
        assert part in message, part


def test_entry_without_region(tmp_path):
    case = collision(tmp_path/"case")
    share(case)
    case.dictionary("constant/solidProperties",
                    {'"b.*"': RUBBER, "disc": RUBBER})
    message = refused(case)
    assert "Keyword 'disc' matches no region" in message
    assert "(b1 b2 b3)" in message


def test_entry_no_dictionary(tmp_path):
    case = collision(tmp_path/"case")
    share(case)
    case.dictionary("constant/solidProperties", {'"b.*"': RUBBER, "b2": 1})
    assert "Keyword 'b2' is not a dictionary" in refused(case)


def test_shared_patches_are_checked(tmp_path):
    """A wrong type in the shared pointU names that file."""
    case = collision(tmp_path/"case")
    share(case)
    file = case.path/"0/pointU"
    file.write_text(file.read_text().replace("type traction;",
                                             "type zeroGradient;"))
    message = refused(case)
    assert "zeroGradient" in message and "0/pointU" in message


def place(case, ranks, method="manual", more=None):
    """Write the dictionaries of decomposePar, run placeRegions, and return its
    output."""
    for region in ("", *NAMES):
        case.dictionary(f"system/{region}/decomposeParDict", {
            "numberOfSubdomains": ranks, "method": method,
            "manualCoeffs": {"dataFile": "ranks"}, **(more or {})})
    return execute(["placeRegions"], case.path)


def test_whole_regions_on_ranks(tmp_path, figures):
    """Two ranks for three bodies in a row: neighbours are on the same rank,
    and the motion is that of one rank."""
    case = collision(tmp_path/"serial").run()
    shared = collision(tmp_path/"case")
    done = place(shared, 2)
    assert done.returncode == 0, done.stdout
    assert "Rank 1: 1 regions, 9 cells" in done.stdout \
        or "Rank 1: 2 regions, 18 cells" in done.stdout
    checked(["decomposePar", "-allRegions"], shared.path)
    cells = []
    for rank in range(2):
        for name in NAMES:
            owner = (shared.path/f"processor{rank}/constant"/name
                     / "polyMesh/owner").read_text(errors="replace")
            cells.append(int(re.search(r"nCells:\s*(\d+)", owner)[1]))
    cells = np.array(cells).reshape(2, 3)
    assert (np.sort(cells, axis=0) == ((0, 0, 0), (9, 9, 9))).all()
    assert cells[0, 0] != cells[0, 2], "ends of the row on one rank"
    checked(["mpirun", "-np", "2", "vertexContactFoam", "-parallel"],
            shared.path)
    checked(["reconstructPar", "-allRegions"], shared.path)
    with figures("whole regions on two ranks") as f:
        for name in NAMES:
            D = case.field("2", name, "pointD")
            f.atMost(f"{name}: displacement, difference / largest",
                     np.abs(shared.field("2", name, "pointD") - D).max()
                     / np.abs(D).max(), 1e-12)


@pytest.mark.parametrize("ranks, method, more, message", (
    (2, "metis", {}, "Keyword 'method' is metis"),
    (4, "manual", {}, "Keyword 'numberOfSubdomains' is 4"),
    (2, "manual", {"manualCoeffs": 5},
     "Keyword 'manualCoeffs' is not a dictionary"),
    *((2, "manual", {"manualCoeffs": {"dataFile": f'"{name}"'}},
       f"Keyword 'dataFile' is \"{name}\"") for name in ("a/ranks", "../ranks")),
))
def test_place_regions_refuses(tmp_path, ranks, method, more, message):
    done = place(collision(tmp_path/"case"), ranks, method, more)
    assert done.returncode and message in done.stdout


@pytest.mark.parametrize("n", (None, "(1 3 1)", "(3 1 1)"))
def test_a_rank_for_each_region(tmp_path, n):
    """As many ranks as regions, also for columns of ranks across the row: each
    rank has one region."""
    case = collision(tmp_path/"case")
    done = place(case, 3,
                 more={"hierarchicalCoeffs": {"n": n}} if n else None)
    assert done.returncode == 0, done.stdout
    assert re.findall(r"Rank \d: 1 regions, 9 cells", done.stdout) == [
        f"Rank {rank}: 1 regions, 9 cells" for rank in range(3)]


def test_ranks_in_wrong_numbers(tmp_path):
    done = place(collision(tmp_path/"case"), 3,
                 more={"hierarchicalCoeffs": {"n": "(2 1 1)"}})
    assert done.returncode and "Keyword 'n' is (2 1 1)" in done.stdout


@pytest.mark.parametrize("number, stiff, told", (
    (3, 20, " b0 {} s b1 {} s b2 {} s\nWith steps of their own (subCycling "
     "yes), b0 1 b1 4 b2 1 in {} s"),
    (9, 20, " from b1 {} s to b{} {} s\nWith steps of their own (subCycling "
     "yes), from b{} 1 to b1 5 in {} s"),
    (9, 1, " from b{} {} s to b{} {} s\n\n")), ids=("few", "many", "alike"))
def test_steps_that_the_log_names(tmp_path, number, stiff, told):
    """Each region by its name, or of many regions the least and the largest.
    Nothing is said of sub-cycling that would save nothing."""
    bodies = [Body(cells=(2, 2), name=f"b{i}", start=(2*i, 0, 0),
                   material={**RUBBER, "E": stiff if i == 1 else 1})
              for i in range(number)]
    _, log = SmallCase(tmp_path, bodies, 0.2, preset=DEFAULT).attempt()
    told = re.escape(told).replace(r"\{\}", r"\S+")
    assert re.search(f"Stable steps at Co 1, at the end:{told}", log), \
        log[-2000:]
