"""mapState: a case starts with the state of another case on another mesh."""

import shutil

import numpy as np
import pytest

from vertexContactTests.caseTools import (DEFAULT, Case, checked, execute,
                                          solver)
from vertexContactTests.smallCases import (FLOOR, Body, SmallCase, condition,
                                           coulomb, distorted, largest, polar)

HELD = condition("fixedVelocity", velocity=(0, 0, 0))
MIRRORS = {"left": "symmetryPlane", "right": "symmetryPlane"}


def make(folder, body, endTime=1.0, **more):
    return SmallCase(folder, body, endTime, preset=DEFAULT, control={
        "maxCo": 0.9, **more.pop("control", {})}, **more)


def mapped(source, case, *options):
    case.output = checked(["mapState", str(source.path), *options], case.path)
    return case


SLOPE = np.array(((0.1, 0.02, 0), (-0.03, -0.05, 0), (0, 0, 0)))
SLOPE3 = SLOPE + np.array(((0, 0, 0.04), (0, 0, -0.01), (0.02, 0.03, 0.06)))


@pytest.mark.parametrize("dimensions", (1, 2, 3))
def test_linear_fields(tmp_path, figures, dimensions):
    """Linear fields are kept to round-off, from any mesh to any other mesh."""
    slope = np.zeros((3, 3))
    slope[:dimensions, :dimensions] = SLOPE3[:dimensions, :dimensions]

    def body(cells, amplitude, **fields):
        moved = distorted(amplitude, dimensions=dimensions)
        return Body(cells=cells[:dimensions], moved=moved if dimensions > 1
                    else None, **fields)

    def linear(X):
        return X @ slope.T + 0.01*np.array((1, -2, 3))*np.any(slope, axis=1)
    source = make(tmp_path/"source", body(
        (5, 6, 4), 0.4, velocity=lambda X: -2*linear(X), displacement=linear))
    case = mapped(source, make(tmp_path/"case", body((7, 4, 6), -0.3)))
    X = case.X()
    with figures(f"mapState of linear fields, {dimensions}D") as f:
        f.atMost("displacement less that", largest(
            case.at("pointD", "0") - linear(X)), 1e-13)
        f.atMost("velocity less that", largest(
            case.at("pointU", "0") + 2*linear(X)), 1e-13)
        f.equal("says that points are outside", "outside" in case.output, False)


def test_curved_surface(tmp_path, figures):
    """Points of the finer mesh lie outside the coarser mesh."""
    def ring(cells, **fields):
        return Body(cells=cells, start=(1, 0, 0), size=(0.5, 1, 1), moved=polar,
                    **fields)
    source = make(tmp_path/"source", ring(
        (3, 4), displacement=lambda X: X @ SLOPE.T))
    case = mapped(source, make(tmp_path/"case", ring((4, 9))))
    with figures("mapState outside the mesh") as f:
        f.atMost("linear displacement, error", largest(
            case.at("pointD", "0") - case.X() @ SLOPE.T), 1e-13)
        f.equal("says that points are outside", "outside" in case.output, True)


def test_preload(tmp_path, figures):
    """A block that has come to rest under its weight on a coarse mesh hardly
    moves on a finer mesh."""
    def block(n):
        return Body(cells=(n, n), sides={"bottom": HELD})
    g = {"gravity": (0, -0.1, 0)}
    source = make(tmp_path/"source", block(8), 40.0, **g, control={
        "damping": {"body": {"coefficient": 1}}}).run()
    case = mapped(source, make(tmp_path/"case", block(16), 4.0, **g)).run()
    anew = make(tmp_path/"anew", block(16), 4.0, **g).run()
    e = case.energies
    strain = source.energies["total:strain"][-1]
    with figures("mapState of a preload to a finer mesh") as f:
        f.within("strain energy / of the other mesh",
                 e["total:strain"][0]/strain, 1, 0.03)
        f.atMost("kinetic energy, largest, / of a block without the preload",
                 e["total:kinetic"].max()
                 / anew.energies["total:kinetic"].max(), 0.01)
        f.atMost("displacement at the start, largest / of the other mesh",
                 abs(largest(case.at("pointD", "0"))
                     / largest(source.at("pointD")) - 1), 1e-12)


def test_metal_that_has_flowed(tmp_path, figures):
    """The stress and epsilonPEq of a metal and pointT of a hot metal are
    mapped, from a given time. Fields of other regions start as usual."""
    pulled = condition("fixedVelocity", velocity=(0.05, 0, 0),
                       components=("x",))
    metal = {"type": "HenckyVonMises", "rho": 1, "E": 1, "nu": 0.3,
             "tauY": 0.02, "Hardening": 0.1,
             "adiabaticHeating": {"cp": 1e-3, "T0": 300}}

    def bar(n):
        return Body(cells=(n, 4), size=(1, 0.25, 1), material=metal,
                    sides={"left": HELD, "right": pulled})
    other = Body(cells=(3, 3), name="other", start=(0, 2, 0))
    source = make(tmp_path/"source", bar(12), 3.0, control={
        "writeInterval": 1.5}).run()
    case = mapped(source, make(tmp_path/"case", (bar(20), other), 0.1),
                  "-sourceTime", "1.5").run()
    C = case.at("CpInv")
    xx, xy, xz, yy, yz, zz = C.T
    det = (xx*(yy*zz - yz**2) - xy*(xy*zz - yz*xz) + xz*(xy*yz - yy*xz))
    at = np.abs(source.energies["Time"] - 1.5).argmin()
    with figures("mapState of a metal that has flowed") as f:
        f.atMost("determinant of CpInv less 1", largest(det - 1), 1e-13)
        f.atLeast("plastic strain, largest",
                  case.at("epsilonPEq", "0").max(), 5e-3)
        for name in "epsilonPEq", "pointT":
            f.within(f"{name}, largest / of the other mesh",
                     case.at(name, "0").max()
                     / source.at(name, "1.5").max(), 1, 1e-12)
        f.within("strain energy / of the other mesh",
                 case.energies["body:strain"][0]
                 / source.energies["body:strain"][at], 1, 0.03)
        f.equal("names the other region", "Region other: not in the other case"
                in case.output, True)


@pytest.mark.parametrize("cells, kept", (
    ((8, 6), 0.02), ((16, 12), 0.35), ((11, 7), 0.35)))
def test_metal_that_was_bent(tmp_path, figures, cells, kept):
    """The elastic strain is a hundredth of the plastic strain, and is kept: on
    the same mesh to the change in a step, on others without what alternates
    from node to node. When only its deviator was mapped, the energy became 1.9,
    3.4 and 1.7 times as large, and the metal flowed on."""
    metal = {"type": "HenckyVonMises", "rho": 1, "mu": 400, "kappa": 1000,
             "tauY": 5, "Hardening": 20}

    def block(n, **fields):
        return Body(cells=n, material=metal, sides={"left": HELD}, **fields)
    source = make(tmp_path/"source", block((8, 6), velocity=lambda X: np.stack(
        (-2*X[:, 0], 1.5*X[:, 0]**2, 0*X[:, 0]), axis=1)), 0.3, control={
            "damping": {"body": {"coefficient": 3}}}).run()
    case = mapped(source, make(tmp_path/"case", block(cells), 0.02)).run()
    strain = source.energies["body:strain"][-1]
    with figures(f"mapState of a metal that was bent, to {cells}") as f:
        f.atLeast("plastic strain, largest",
                  source.at("epsilonPEq").max(), 0.25)
        f.within("strain energy / of the other mesh",
                 case.energies["body:strain"][0]/strain, 1, kept)
        f.atMost("work of the flow after it / strain energy",
                 case.energies["body:plasticDissipation"][-1]/strain, 0.05)
        f.equal("names the strain", "elasticStrain" in case.output, True)


def test_metal_that_has_not_flowed(tmp_path, figures):
    """The metal starts as elastic bodies do: without a plastic state."""
    metal = {"type": "HenckyVonMises", "rho": 1, "E": 1, "nu": 0.3, "tauY": 10}

    def block(n):
        return Body(cells=(n, n), material=metal, sides={"bottom": HELD})
    g = {"gravity": (0, -0.1, 0)}
    source = make(tmp_path/"source", block(4), 10.0, **g).run()
    case = mapped(source, make(tmp_path/"case", block(8), 0.1, **g)).run()
    one = np.array((1, 0, 0, 1, 0, 1))
    with figures("mapState of a metal that has not flowed") as f:
        f.atLeast("displacement at the start, largest",
                  largest(case.at("pointD", "0")), 0.01)
        f.atMost("CpInv less I", largest(case.at("CpInv") - one), 1e-14)
        f.atMost("displacement of the held side at the start", largest(
            case.at("pointD", "0")[case.X()[:, 1] == 0]), 0)


@pytest.mark.parametrize("dimensions", (2, 3))
def test_on_two_ranks(tmp_path, figures, dimensions):
    """A decomposed case gets the same state as before the decomposition."""
    def body(n, **fields):
        return Body(cells=(n, n + 1, n - 1)[:dimensions], **fields)
    source = make(tmp_path/"source", body(
        5, velocity=lambda X: -2*X, displacement=lambda X: 0.1*np.sin(5*X)))
    before = mapped(source, make(tmp_path/"before", body(7)))
    before.decompose(2)
    after = make(tmp_path/"after", body(7))
    after.decompose(2)
    after.output = checked(["mpirun", "-np", "2", "mapState", str(
        source.path), "-parallel"], after.path)
    with figures(f"mapState on two ranks, {dimensions}D") as f:
        f.equal("says the same of the region", after.output.split(
            "Region ")[1].split("\n")[0], before.output.split(
            "Region ")[1].split("\n")[0])
        for rank in range(2):
            for name in "pointD", "pointU":
                a, b = (Case(case/f"processor{rank}").field("0", "body", name)
                        for case in (before, after))
                f.atLeast(f"{name} of rank {rank}, largest", largest(a), 0.05)
                f.atMost("difference", largest(a - b), 1e-15)


@pytest.mark.parametrize("handler", ("masterUncollated", "collated"))
def test_file_handlers(tmp_path, figures, handler):
    """The other case may use another file handler than this case."""
    chosen = ("-fileHandler", handler)
    source = make(tmp_path/"source", Body(
        cells=(5, 5), displacement=lambda X: 0.1*X))
    case = make(tmp_path/"case", Body(cells=(7, 7)))
    for region in "", "body":
        case.write(f"system/{region}/decomposeParDict", "dictionary",
                   "numberOfSubdomains 2; method metis;")
    checked(["decomposePar", "-allRegions", *chosen], case.path)
    checked(["mpirun", "-np", "2", "mapState", str(source.path), "-parallel",
             *chosen], case.path)
    checked(["reconstructPar", "-allRegions", "-withZero", "-fields",
             "(pointD)", *chosen], case.path)
    with figures(f"mapState with files of {handler}") as f:
        f.atMost("linear displacement, error", largest(
            case.at("pointD", "0") - 0.1*case.X()), 1e-13)


def test_two_parts_of_a_body(tmp_path, figures):
    """A point outside a coarse mesh belongs to the part that bulges there. It
    does not belong to a part across a slit, although small cells of that part
    have closer centres."""
    def bent(X):
        s = (0.5 - X[:, 0])*6
        bulge = np.where(s > 1, 0.09*np.sin(3*np.pi*(s - 1)/2)**2, 0)
        along, thick = np.clip(s, -1, 1)*np.pi/2, np.where(s > 0, 1, 0.1)
        r = 0.12 + thick*X[:, 1] - bulge*(1 - X[:, 1])
        Y = X.copy()
        Y[:, 0] = r*np.cos(along) - 1.5*np.maximum(np.abs(s) - 1, 0)
        Y[:, 1] = r*np.sin(along)
        return Y

    def arms(X):
        return np.stack((0*X[:, 0], 0.1*np.sign(X[:, 1]), 0*X[:, 0]), 1)
    source = make(tmp_path/"source", Body(
        cells=(12, 2), moved=bent, displacement=arms))
    case = mapped(source, make(tmp_path/"case", Body(
        cells=(60, 8), moved=bent)))
    X = case.X()
    wrong = np.abs(case.at("pointD", "0") - arms(X)).max(axis=1)
    with figures("mapState of a body with a slit") as f:
        f.equal("says that points are outside", "outside" in case.output, True)
        f.atMost("displacement of the arms, error / itself",
                 largest(wrong[X[:, 0] < -0.6])/0.1, 1e-12)


def test_stuck(tmp_path, figures):
    """Friction holds a block on a wall, with the weight along the wall. The
    mapped block hangs where it came to rest: it is pulled back to the point
    where it began to stick, and does not begin to stick at a new point."""
    def block(n):
        return Body(cells=(n, n), sides={
            "left": "contact", "right": condition("traction",
                                                  traction=(-0.05, 0, 0))})
    wall = {"wall": {"side": ("body", "left"), "law": coulomb(0.5),
                     "obstacle": {**FLOOR, "pointAndNormalDict": {
                         "point": (0, 0, 0), "normal": (1, 0, 0)}}}}
    weight = {"gravity": (0, -0.01, 0)}

    source = make(tmp_path/"source", block(6), 40.0, interfaces=wall, **weight,
                  control={"damping": {"body": {"coefficient": 1}}}).run()
    case = mapped(source, make(tmp_path/"case", block(12), 4.0,
                               interfaces=wall, **weight))
    slide = case.at("contactSlide", "0")
    with figures("mapState of a block that sticks") as f:
        f.within("largest slide / of the other mesh", largest(slide)
                 / largest(source.at("contactSlide")), 1, 1e-12)
        case.run()
        f.atMost("its change / itself", largest(
            case.at("contactSlide") - slide)/largest(slide), 0.05)


def bad(case, *arguments):
    done = execute(["mapState", *arguments], case.path)
    assert done.returncode != 0, done.stdout
    return done.stdout[done.stdout.index("--> FOAM FATAL IO ERROR"):]


def test_bad_input(tmp_path):
    """One message, and nothing is written."""
    body = Body(cells=(4, 4))
    source = make(tmp_path/"source", body)
    case = make(tmp_path/"case", Body(cells=(4, 4), start=(5, 0, 0)))
    other = make(tmp_path/"other", Body(cells=(4, 4), name="other"))
    assert "-sourceTime" in bad(source, str(case.path), "-sourceTime", "3")
    message = bad(case, str(source.path))
    assert "nearest cell" in message and "source" in message
    message = bad(other, str(source.path))
    assert "(other)" in message and "(body)" in message
    ran = make(tmp_path/"ran", body, 0.05).run()
    before = ran.field("0.05", "body", "pointU")
    assert "this case has run to this time" in bad(ran, str(source.path))
    (ran/"0.05"/"uniform"/"solidSystem").unlink()
    message = bad(ran, str(source.path))
    assert "this case has run to this time" in message and "body/lm" in message
    assert np.array_equal(before, ran.field("0.05", "body", "pointU"))

    stale = make(tmp_path/"stale", body)
    stale.write("0/body/F0", "pointTensorField", """
dimensions [0 0 0 0 0 0 0]; internalField uniform (1.1 0 0 0 1 0 0 0 1);
boundaryField { ".*" { type calculated; } "front|back" { type empty; } }""")
    message = bad(stale, str(source.path))
    assert "body/F0" in message and "the other case has no such" in message

    # A fault of one region is found before any other region is written
    def pair(**first):
        return [Body(cells=(4, 4), name="a", **first),
                Body(cells=(4, 4), name="b", start=(3, 0, 0))]

    # The same regions, of another kind
    metal = {"type": "HenckyVonMises", "rho": 1, "E": 1, "nu": 0.3,
             "tauY": 0.02}
    hot = {**metal, "adiabaticHeating": {"cp": 1}}
    rigid = {"type": "rigid", "rho": 1}
    flown = {name: make(tmp_path/name, Body(
        cells=(4, 4), material=material, velocity=lambda X: 0.2*X), 0.1).run()
        for name, material in (("metal", metal), ("hot", hot))}
    for i, (there, changes, words) in enumerate((
            (source, {"cells": (4, 4, 4)}, ("(1 1 -1)", "(1 1 1)")),
            (source, {"material": rigid}, ("neoHookean", "rigid")),
            (flown["metal"], {}, ("CpInv", "HenckyVonMises", "neoHookean")),
            (flown["hot"], {"material": metal}, ("pointT", "HenckyVonMises")))):
        here = make(tmp_path/f"here{i}", Body(**{"cells": (4, 4), **changes}))
        start = (here/"0/body/pointU").read_bytes()
        message = bad(here, str(there.path))
        for word in ("'body'", *words):
            assert word in message, message
        assert (here/"0/body/pointU").read_bytes() == start
        assert [file.name for file in (here/"0/body").iterdir()] == ["pointU"]

    two = make(tmp_path/"two", pair(displacement=lambda X: 0.1*X))
    half = make(tmp_path/"half", pair())
    shutil.copytree(stale/"0"/"body", half/"0"/"b", dirs_exist_ok=True)
    assert "b/F0" in bad(half, str(two.path))
    assert not (half/"0"/"a"/"pointD").exists()

    killed = make(tmp_path/"killed", body, 0.05).run()
    record = killed/"0.05"/"uniform"/"solidSystem"
    record.write_bytes(record.read_bytes()[:-60])
    message = bad(make(tmp_path/"fine", body), str(killed.path))
    assert "not complete" in message and "0.05" in message

    apart = make(tmp_path/"apart", body, 0.05)
    apart.decompose(2)
    checked(solver(2), apart.path)
    message = bad(make(tmp_path/"fine2", body), str(apart.path))
    assert "later time 0.05" in message and "reconstructPar" in message

    (source/"0"/"body"/"pointU").unlink()
    assert "no field pointU" in bad(
        make(tmp_path/"same", body), str(source.path), "-sourceTime", "0")
    for each, region in (case, "body"), (other, "other"):
        assert not (each/"0"/region/"pointD").exists()
