"""checkContact: its figures for good interfaces, and the bad interfaces for
which it fails."""

import re

import numpy as np
import pytest
import pyvista

from vertexContactTests.caseTools import DEFAULT, execute
from vertexContactTests.smallCases import (Body, SmallCase, interface,
                                           largest, turned)

NUMBER = r"-?\d[-+.e\d]*"


class Checked:
    """A run of checkContact: exit code, output, and table."""

    def __init__(self, case, *options, ranks=1):
        command = ["checkContact", *options]
        if ranks > 1:
            command = ["mpirun", "-np", str(ranks), *command, "-parallel"]
        done = execute(command, case.path)
        self.code, self.log = done.returncode, done.stdout
        self.failed = re.findall(r"(?m)^  \*\*\*(.*)$", self.log)
        self.path = case.path

    def __getitem__(self, name):
        """Values of a row: one, or one for each side."""
        row = re.search(rf"(?m)^    {re.escape(name)}\s\s+(\S.*)$", self.log)
        return np.array([float(x) for x in re.findall(NUMBER, row[1])])

    def counts(self, name):
        return [int(n) for n in self[name]]

    def vtk(self, name="contact", time="0"):
        return pyvista.read(
            self.path/"postProcessing"/"checkContact"/time/f"{name}.vtk")


def blocks(minusCells, plusCells, gap=0.0, height=1, **more):
    """Two blocks with a gap along x. The second one is higher, or shifted."""
    dimensions = len(minusCells)
    size = (1, *(height if i < dimensions else 1 for i in (1, 2)))
    return [Body(cells=minusCells, name="left", sides={"right": "contact"}),
            Body(cells=plusCells, name="right", start=(1 + gap, 0, 0),
                 size=size, sides={"left": "contact"}, **more)]


def small(path, bodies, pairing, **more):
    return SmallCase(path, bodies, endTime=0.01, interfaces={
        "contact": interface(("left", "right"), ("right", "left"),
                             pairing=pairing)}, **more)


# Good interfaces

GOOD = {"matching 1D": ("matching", (4,), (6,)),
        "matching 2D": ("matching", (4, 4), (3, 4)),
        "matching 3D": ("matching", (3, 3, 3), (2, 3, 3)),
        "AMI 2D": ("AMI", (4, 4), (4, 8)),
        "AMI 3D": ("AMI", (3, 3, 3), (3, 6, 6)),
        "AMI 3D, 3 on 4": ("AMI", (3, 3, 3), (3, 4, 4)),
        "nearestFace 2D": ("nearestFace", (4, 4), (4, 8)),
        "nearestFace 3D": ("nearestFace", (3, 3, 3), (3, 6, 6))}
GAP = 0.01


@pytest.mark.parametrize("name", GOOD)
def test_good_bodies(tmp_path, figures, name):
    """Flat surfaces of the same size: each point is covered once, and
    constants, linear fields, forces and moments are transferred exactly, in
    serial and on two ranks. The VTK file has a line for each overlap."""
    pairing, minus, plus = GOOD[name]
    case = small(tmp_path, blocks(minus, plus, gap=GAP), pairing)
    serial = Checked(case, "-minCoverage", "1")
    lines = serial.vtk()
    case.decompose(2)
    parallel = Checked(case, "-minCoverage", "1", ranks=2)

    faces = [int(np.prod(cells[1:])) for cells in (minus, plus)]
    perFace = 2**(len(minus) - 1)
    with figures(f"checkContact, {name}") as f:
        for run, ranks, vtk in ((serial, "serial", lines),
                                (parallel, "2 ranks", parallel.vtk())):
            f.equal(f"{ranks}: exit code", run.code, 0)
            f.equal(f"{ranks}: verdict", "Contact OK." in run.log, True)
            f.equal(f"{ranks}: faces", run.counts("Faces"), faces)
            f.equal(f"{ranks}: corners", run.counts("Corners"),
                    [n*perFace for n in faces])
            f.equal(f"{ranks}: corners without partner",
                    run.counts("Corners without partner"), [0, 0])
            f.equal(f"{ranks}: corners partly covered",
                    run.counts("Corners partly covered"), [0, 0])
            for row in ("Coverage", "Least sum of weights (of covered)",
                        "Greatest sum of weights"):
                f.atMost(f"{ranks}: {row} - 1", largest(run[row] - 1), 1e-10)
            for row in ("Transfer of a constant, error",
                        "Transfer of a linear field (2)",
                        "  at the other side's point",
                        "  tangential offset / face width",
                        "Sum of value weights, error",
                        "Sum of flux weights, error",
                        "  difference, relative",
                        "  difference, relative (1)",
                        "Force balance of unit pressure",
                        "Moment balance (1)",
                        "Traction of covered faces, error"):
                f.atMost(f"{ranks}: {row.strip()}", largest(run[row]), 1e-12)
            for row in "Least", "Mean", "Greatest":
                f.within(f"{ranks}: {row} gap", run[f"{row} gap [m]"][0],
                         GAP, 1e-12)

            n = int(run["Overlaps"][0])
            length = np.linalg.norm(
                vtk.points[1::2] - vtk.points[::2], axis=1)
            f.equal(f"{ranks}: vertices and lines in the VTK file",
                    (vtk.n_verts, vtk.n_lines), (n, n))
            f.atMost(f"{ranks}: length of the lines / gap - 1",
                     largest(length/GAP - 1), 1e-9)
            f.within(f"{ranks}: area of the lines",
                     vtk.cell_data["area"][n:].sum(), 1, 1e-9)
            f.atMost(f"{ranks}: gap in the VTK file / gap - 1",
                     largest(vtk.cell_data["gap"]/GAP - 1), 1e-9)
        f.equal("the same overlaps on 2 ranks",
                parallel["Overlaps"][0], serial["Overlaps"][0])


def planeAt(x, normal):
    return {"side": ("left", "right"), "obstacle": {
        "type": "plane", "planeType": "pointAndNormal",
        "pointAndNormalDict": {"point": (x, 0, 0), "normal": normal}}}


def beforeWall(path, x, normal, cells=(4, 4)):
    body = Body(cells=cells, name="left", sides={"right": "contact"})
    return SmallCase(path, body, endTime=0.01,
                     interfaces={"contact": planeAt(x, normal)})


@pytest.mark.parametrize("nDim", (2, 3))
def test_gap_of_an_edge(tmp_path, figures, nDim):
    """The gap between an edge and a floor is along the normal of the floor, as
    in the solver. It is measured at the middle of the part of the first
    corner, a quarter of a cell from the edge."""
    angle, gap, cells = 0.4, 0.01, 4
    start, size = ((0.27, gap, 0), (1, 1, 1)) if nDim == 2 else (
        (0.27, gap, 0.1), (1, 1, 0.3))
    block = Body(cells=(cells,)*nDim, name="block", size=size,
                 sides={"bottom": "contact"},
                 moved=lambda X: start + turned(X, (0, 0, 1), angle))
    floor = Body(cells=(1,)*nDim, name="floor", start=(-1, -1, 0),
                 size=(3, 1, 1), sides={"top": "contact"})
    checked = Checked(SmallCase(
        tmp_path, [block, floor], endTime=0.01, preset=DEFAULT, interfaces={
            "contact": interface(("block", "bottom"), ("floor", "top"),
                                 pairing="nearestFace")}))
    with figures(f"checkContact, edge over a floor, {nDim}D") as f:
        f.within("least gap / true one", checked["Least gap [m]"][0]
                 / (gap + 0.25/cells*np.sin(angle)), 1, 1e-5)


@pytest.mark.parametrize("cells", ((4,), (4, 4), (3, 3, 3)),
                         ids=("1D", "2D", "3D"))
def test_good_obstacle(tmp_path, figures, cells):
    """A plane close to a block: all corners are close to it and face it."""
    case = beforeWall(tmp_path, 1 + GAP, (-1, 0, 0), cells)
    serial = Checked(case)
    lines = serial.vtk()
    case.decompose(2)
    parallel = Checked(case, ranks=2)
    n = int(np.prod([2*c for c in cells[1:]]))
    with figures(f"checkContact, obstacle, {len(cells)}D") as f:
        for run, ranks, vtk in ((serial, "serial", lines),
                                (parallel, "2 ranks", parallel.vtk())):
            f.equal(f"{ranks}: exit code", run.code, 0)
            f.equal(f"{ranks}: verdict", "Contact OK." in run.log, True)
            for row in ("Corners", "Corners close to the obstacle",
                        "  that face it"):
                f.equal(f"{ranks}: {row.strip()}", int(run[row][0]), n)
            for row in "Least", "Mean", "Greatest":
                f.within(f"{ranks}: {row} gap", run[f"{row} gap [m]"][0],
                         GAP, 1e-12)
            f.equal(f"{ranks}: lines in the VTK file", vtk.n_lines, n)
            f.equal(f"{ranks}: all face it in the VTK file",
                    bool(np.all(vtk.cell_data["facing"] == 1)), True)


def test_obstacle_far_away(tmp_path, figures):
    """A body is still far away, on the right side of the obstacle: no
    failure."""
    run = Checked(beforeWall(tmp_path, 5, (-1, 0, 0)))
    with figures("checkContact, obstacle far away") as f:
        f.equal("exit code", run.code, 0)
        f.equal("corners close", run["Corners close to the obstacle"][0], 0.0)
        f.within("least gap", run["Least gap [m]"][0], 4, 1e-12)


def test_bodies_apart(tmp_path, figures):
    """Bodies that have not met yet: nothing is paired. This is a failure only
    if a coverage is required."""
    case = small(tmp_path, blocks((4, 4), (4, 8), gap=3), "nearestFace")
    run = Checked(case)
    asked = Checked(case, "-minCoverage", "0.5")
    with figures("checkContact, bodies apart") as f:
        f.equal("exit code", run.code, 0)
        f.equal("overlaps", run["Overlaps"][0], 0.0)
        f.equal("lines in the VTK file", run.vtk().n_cells, 0)
        f.equal("quotes in the line of the interface", re.search(
            "(?m)^Interface contact: .*", run.log)[0].count('"'), 0)
        f.equal("exit code with -minCoverage", asked.code, 1)
        f.equal("failed checks", len(asked.failed), 2)


@pytest.mark.parametrize("option, value", (
    ("minCoverage", "2"), ("minCoverage", "-0.1"), ("maxPenetration", "-1")))
def test_limit_out_of_its_range(tmp_path, option, value):
    """No surface could meet it."""
    case = small(tmp_path, blocks((4, 4), (4, 4)), "nearestFace")
    done = execute(["checkContact", f"-{option}", value], case.path)
    assert done.returncode == 1
    assert f"Option -{option} is {value}: it must be" in done.stdout


# Bad interfaces

@pytest.mark.parametrize("ranks", (1, 2))
def test_half_coverage(tmp_path, figures, ranks):
    """The second surface is twice as high, so half of it has no partner: a
    failure if a coverage is required."""
    case = small(tmp_path, blocks((4, 4), (4, 8), height=2), "AMI")
    if ranks > 1:
        case.decompose(ranks)
    run = Checked(case, ranks=ranks)
    asked = Checked(case, "-minCoverage", "0.9", ranks=ranks)
    with figures(f"checkContact, half coverage, {ranks} ranks") as f:
        f.within("coverage, first side", run["Coverage"][0], 1, 1e-10)
        f.within("coverage, second side", run["Coverage"][1], 0.5, 1e-10)
        f.equal("corners without partner",
                run.counts("Corners without partner"), [0, 8])
        f.equal("exit code", run.code, 0)
        f.equal("exit code with -minCoverage", asked.code, 1)
        f.equal("failed checks", len(asked.failed), 1)
        f.equal("verdict", "Failed 1 contact checks." in asked.log, True)
        f.equal("message", "Coverage of right.left" in asked.failed[0], True)


@pytest.mark.parametrize("pairing", ("matching", "AMI", "nearestFace"))
def test_penetration(tmp_path, figures, pairing):
    """Blocks that start 0.03 m inside each other, which is 12 % of a face
    width. The pairing 'matching' measures it relative to corners, which gives
    twice this share."""
    case = small(tmp_path, blocks((4, 4), (4, 4), gap=-0.03), pairing)
    run = Checked(case)
    allowed = Checked(case, "-maxPenetration", "0.2")
    with figures(f"checkContact, penetration, {pairing}") as f:
        f.equal("exit code", run.code, 1)
        f.equal("failed checks", len(run.failed), 1)
        f.equal("message", "penetrate" in run.failed[0], True)
        f.within("penetration / face width",
                 run["Penetration / face width"][0], 0.12, 1e-6)
        f.within("least gap", run["Least gap [m]"][0], -0.03, 1e-12)
        f.equal("exit code if it is allowed", allowed.code, 0)


@pytest.mark.parametrize("pairing", ("matching", "AMI", "nearestFace"))
def test_bodies_that_slid(tmp_path, figures, pairing):
    """The second block has slid by half of its height, which is two faces, and
    the gap is small: pairings of the reference configuration are wrong
    here."""
    case = small(
        tmp_path, blocks(
            (4, 4), (4, 4), gap=GAP,
            displacement=lambda X: np.zeros_like(X) + (0, 0.5, 0)), pairing)
    run = Checked(case)
    follows = pairing == "nearestFace"
    with figures(f"checkContact, bodies that slid, {pairing}") as f:
        f.equal("exit code", run.code, 0 if follows else 1)
        f.equal("failed checks", len(run.failed), 0 if follows else 1)
        f.within("tangential offset / face width",
                 run["  tangential offset / face width"][0],
                 0 if follows else 2, 1e-9)
        f.within("coverage", run["Coverage"][0], 0.5 if follows else 1, 1e-9)


# Position of the plane, and the effect of its normal: before the body, at its
# surface, and behind it
@pytest.mark.parametrize("x", (1.5, 1.01, 1.0))
@pytest.mark.parametrize("ranks", (1, 2))
def test_obstacle_turned_round(tmp_path, figures, x, ranks):
    """The normal of a plane points away from the body. The run would not see
    the plane at all."""
    case = beforeWall(tmp_path, x, (1, 0, 0))
    if ranks > 1:
        case.decompose(ranks)
    run = Checked(case, ranks=ranks)
    with figures(f"checkContact, normal points away, x = {x}, {ranks} ranks"
                 ) as f:
        f.equal("exit code", run.code, 1)
        f.equal("failed checks", len(run.failed), 1)
        f.equal("message", "point away from left.right" in run.failed[0], True)


def test_obstacle_penetrated(tmp_path, figures):
    run = Checked(beforeWall(tmp_path, 0.97, (-1, 0, 0)))
    with figures("checkContact, obstacle penetrated") as f:
        f.equal("exit code", run.code, 1)
        f.equal("failed checks", len(run.failed), 1)
        f.within("penetration / face width",
                 run["Penetration / face width"][0], 0.12, 1e-6)


def folded(X):
    """A strip from x = 1 on, along a curve that turns by 130 degrees to one
    side, to the other side, and back. It is flattened: seen along x, its ends
    and its middle cover each other at almost the same position."""
    s, n = X[:, 1], X[:, 0] - 1
    fine = np.linspace(0, 1, 2001)
    angle = np.pi/2 + np.radians(130)*np.sin(2*np.pi*fine)
    curve = [np.concatenate(((0,), np.cumsum((d[1:] + d[:-1])/4000)))
             for d in (np.cos(angle), np.sin(angle))]
    x, y, turn = (np.interp(s, fine, values) for values in (*curve, angle))
    flat = x - min(curve[0]) + n*np.sin(turn)
    return np.column_stack((1 + 0.005*flat, y - n*np.cos(turn), X[:, 2]))


@pytest.mark.parametrize("ranks", (1, 2))
def test_folded_surface(tmp_path, figures, ranks):
    """A surface that folds over itself lies opposite the other surface twice.
    The other surface would feel its pressure twice."""
    bodies = [Body(cells=(4, 10), name="left", sides={"right": "contact"}),
              Body(cells=(1, 80), name="right", start=(1, 0, 0),
                   size=(0.02, 1, 1), sides={"left": "contact"},
                   moved=folded)]
    case = small(tmp_path, bodies, "nearestFace")
    if ranks > 1:
        case.decompose(ranks)
    run = Checked(case, ranks=ranks)
    with figures(f"checkContact, folded surface, {ranks} ranks") as f:
        f.equal("exit code", run.code, 1)
        f.atLeast("greatest sum of weights",
                  run["  of overlaps about to touch"][0], 1.9)
        f.equal("message", "overlap each other" in run.log, True)


@pytest.mark.parametrize("gap", (0, 0.01, 0.08))
def test_cap_in_its_hollow(tmp_path, figures, gap):
    """Curved surfaces with different meshes, one inside the other. Where their
    gap is open, they cover each other slightly more than once, which is no
    failure."""
    bulge = 0.15
    inner, outer = ([(x + bulge, 0.5, z) for z in (0, 1)]
                    for x in (1, 1 + gap))
    bodies = [
        Body(cells=(8, 8), name="left", sides={"right": "contact"},
             edges=("arc", 1, 2, inner[0], "arc", 5, 6, inner[1])),
        Body(cells=(8, 13), name="right", start=(1 + gap, 0, 0),
             sides={"left": "contact"},
             edges=("arc", 0, 3, outer[0], "arc", 4, 7, outer[1]))]
    run = Checked(small(tmp_path, bodies, "nearestFace"))
    with figures(f"checkContact, cap in its hollow, gap {gap}") as f:
        f.equal("exit code", run.code, 0)
        f.atMost("sum of flux weights, error",
                 largest(run["Sum of flux weights, error"]), 1e-12)
        f.atMost("force balance",
                 run["Force balance of unit pressure"][0], 1e-12)
        f.atMost("tangential offset / face width",
                 run["  tangential offset / face width"][0], 1e-12)
        f.within("coverage", run["Coverage"][0], 1, 0.05)


def test_nothing_overlaps(tmp_path, figures):
    """AMI surfaces that do not face each other give an error that names
    them."""
    bodies = blocks((4, 4), (4, 4))
    bodies[1].start = (1, 3, 0)
    run = Checked(small(tmp_path, bodies, "AMI"))
    with figures("checkContact, nothing overlaps") as f:
        f.equal("exit code", run.code, 1)
        f.equal("message", "no face of left right overlaps" in run.log, True)


def test_times(tmp_path, figures):
    """Times are selected as in OpenFOAM's utilities. Without an option the
    time is the one from which a run would start."""
    case = small(tmp_path, blocks((4, 4), (4, 4), gap=GAP), "matching").run()
    with figures("checkContact, times") as f:
        for options, times in (((), ["0.01"]), (("-latestTime",), ["0.01"]),
                               (("-time", "0"), ["0"]),
                               (("-time", "0:"), ["0", "0.01"]),
                               (("-noZero",), ["0.01"])):
            run = Checked(case, *options)
            f.equal(f"times of {' '.join(options) or 'no option'}",
                    re.findall(r"(?m)^Time = (\S+)", run.log), times)
            f.equal("exit code", run.code, 0)
        f.equal("VTK file at the last time", run.vtk(time="0.01").n_lines, 8)
