"""Decomposed runs give the serial result."""

from dataclasses import replace

import numpy as np
import pytest

from vertexContactTests.caseTools import DEFAULT, Case, Scene
from vertexContactTests.collisions import (COPPER, SCENES as COLLISIONS,
                                           collision)
from vertexContactTests.smallCases import (RUBBER, Body, GmshBody, SmallCase,
                                           coulomb, largest)

LINE = Scene("similar", elements=128, preset=DEFAULT,
             control=(("writeInterval", 0.1),))
PLANE = Scene("similar", elements=24, dimensions=2, across=12, preset=DEFAULT,
              control=(("writeInterval", 0.1),))
SOLID = Scene("dissimilar", elements=16, dimensions=3, across=6, preset=DEFAULT,
              control=(("endTime", 0.2), ("writeInterval", 0.1)))
RUNS = ((LINE, 2), (PLANE, 2), (SOLID, 3))


def decomposed(scene, ranks):
    return replace(scene, ranks=ranks)


@pytest.mark.scenes(*(s for s, _ in RUNS), *(decomposed(*r) for r in RUNS))
@pytest.mark.parametrize("scene, ranks", RUNS,
                         ids=lambda x: getattr(x, "dimensions", x))
def test_parallel_is_serial(run, figures, scene, ranks):
    serial, parallel = run(scene), run(decomposed(scene, ranks))
    assert (parallel/f"processor{ranks - 1}").is_dir()

    def difference(a, b, scale):
        assert np.shape(a) == np.shape(b)
        return np.max(np.abs(a - b))/scale

    with figures(f"{ranks} ranks, {scene.dimensions}D") as f:
        for field, scale in (("pointU", 0.1), ("pointD", 0.01),
                             ("sigma", 0.05), ("F", 1)):
            f.atMost(f"{field} at 0.2 s: difference to serial / scale",
                     max(difference(serial.field("0.2", bar, field),
                                    parallel.field("0.2", bar, field), scale)
                         for bar in ("bar1", "bar2")), 1e-10)
        for name in "A", "B":
            t, u = serial.probe(f"point{name}", "pointU")
            t1, u1 = parallel.probe(f"point{name}", "pointU")
            assert len(t) == len(t1)
            # Written with ten digits; the last digit may differ
            f.atMost(f"v at {name}: difference to serial / scale",
                     max(difference(t, t1, 0.1), difference(u, u1, 0.1)),
                     3e-10)
        for key in "kinetic", "strain", "numericalDissipation":
            f.atMost(f"{key} energy: difference to serial / initial energy",
                     difference(serial.energies[f"total:{key}"],
                                parallel.energies[f"total:{key}"],
                                serial.totalEnergy[0]), 1e-10)
        f.atMost("impulse of contact: difference to serial / momentum",
                 max(difference(serial.momentum[f"{bar}:px"],
                                parallel.momentum[f"{bar}:px"],
                                serial.momentum["bar1:px"][0])
                     for bar in ("bar1", "bar2")), 1e-10)


@pytest.mark.parametrize("method", ("metis", "random"))
@pytest.mark.parametrize("name", COLLISIONS)
def test_collision(tmp_path, figures, name, method):
    """Every field on three ranks equals the field on one rank."""
    serial = collision(tmp_path/"serial", name, preset=DEFAULT).run()
    parallel = collision(tmp_path/"parallel", name, preset=DEFAULT)
    parallel.runParallel(3, method)
    last = serial.last
    assert parallel.last == last
    with figures(f"{name}, 3 ranks, {method}") as f:
        for body in serial.bodies:
            for file in sorted((serial.path/last/body.name).iterdir()):
                if not file.is_file():
                    continue
                a, b = (case.at(file.name, region=body.name)
                        for case in (serial, parallel))
                # The slip is a difference of displacements
                scale = (serial.at("pointD", region=body.name)
                         if file.name == "contactSlide" else a)
                f.atMost(f"{body.name} {file.name}: difference / largest",
                         largest(a - b)/max(largest(scale), 1e-12), 1e-10)


LONG = {
    "2D": Body((96, 3), size=(24, 1, 1)),
    "a mirror along it": Body((72, 3, 3), size=(24, 1, 1),
                              sides={"bottom": "symmetryPlane"}),
    "metal, correction 0": Body((72, 3, 3), size=(24, 1, 1), material=COPPER,
                                scheme={"correction": 0}),
    "nearly incompressible": Body((72, 3, 3), size=(24, 1, 1),
                                  material=dict(RUBBER, nu=0.49)),
}


def compared(tmp_path, figures, title, body, decompose):
    """Every field of a body on several ranks equals the field on one."""
    # No velocity normal to a mirror
    body = replace(body, velocity=lambda X: 0.3*np.sin(X[:, :1])
                   * (1, 0, 1) * (X[:, 1:2] + 1))
    serial, parallel = (
        SmallCase(tmp_path/case, body, 1, preset=DEFAULT)
        for case in ("serial", "parallel"))
    serial.run()
    decompose(parallel)
    last = serial.last
    assert parallel.last == last
    with figures(title) as f:
        for file in sorted((serial.path/last/body.name).iterdir()):
            if file.is_file():
                a, b = (case.at(file.name, region=body.name)
                        for case in (serial, parallel))
                f.atMost(f"{file.name}: difference / largest",
                         largest(a - b)/max(largest(a), 1e-12), 1e-10)


def byHand(case, ranks):
    """Decompose a body so, and run it."""
    (case/f"constant/{case.bodies[0].name}/cellDecomposition").write_text(
        "FoamFile { version 2.0; format ascii; class labelList; "
        f"object cellDecomposition; }}\n{len(ranks)}\n("
        f"{' '.join(map(str, ranks))})\n")
    case.runParallel(max(ranks) + 1, "manual")


@pytest.mark.parametrize("name", LONG)
def test_edges_that_are_done_early(tmp_path, figures, name):
    """Passes follow each other where a rank has many nodes that it does not
    share. What is exchanged is done before (earlyEdges). Most bodies of this
    file are too small for that."""
    compared(tmp_path, figures, f"{name}, 2 ranks", LONG[name],
             lambda case: case.runParallel(2))


def test_early_edges_beside_thin_ranks(tmp_path, figures):
    """One half of a bar on one rank, which does edges early. The other half on
    two ranks, one cell thick each: all their edges are at shared nodes. Three
    ranks meet. Small strains."""
    body = Body((96, 2, 2), size=(24, 1, 1), material={
        "type": "linearElastic", "rho": 1, "E": 1, "nu": 0.3})
    x, y, _ = np.unravel_index(np.arange(96*2*2), (96, 2, 2), order="F")
    compared(tmp_path, figures, "half a bar, and two quarters", body,
             lambda case: byHand(case, np.where(x < 48, 0, 1 + y)))


@pytest.mark.parametrize("dimensions", (2, 3))
def test_rank_without_a_cell_of_a_region(tmp_path, figures, dimensions):
    """All ranks write the same fields, also where they have no node of the
    body. Otherwise reconstructPar stops. A rank used to leave out the
    hourglassShare of metal, which has no entries there."""
    def metals(name):
        bodies = [Body((3,)*dimensions, name=body, start=(x, 0, 0),
                       material=COPPER, velocity=lambda X: 0.2*X*(1, 0, 0))
                  for body, x in (("one", 0), ("other", 2))]
        return SmallCase(tmp_path/name, bodies, 1, preset=DEFAULT)

    serial, parallel = metals("serial").run(), metals("parallel")
    for rank, body in enumerate(parallel.bodies):
        n = 3**dimensions
        (parallel/f"constant/{body.name}/cellDecomposition").write_text(
            "FoamFile { version 2.0; format ascii; class labelList; "
            f"object cellDecomposition; }}\n{n} {{{rank}}}\n")
    parallel.runParallel(2, "manual")
    with figures(f"{dimensions}D, each body on one of two ranks") as f:
        for body in serial.bodies:
            a, b = (case.at("hourglassShare", region=body.name)
                    for case in (serial, parallel))
            f.atMost(f"{body.name}: smallest share of stiffness that is left",
                     a.min(), 0.5)
            f.atMost(f"{body.name}: difference to serial", largest(a - b),
                     1e-10)


def test_largest_frequency_with_a_mirror(tmp_path, figures):
    """A body with fewer unknowns than the search for its largest frequency has
    steps. Round-off normal to the mirror grew in it, so that the step depended
    on the place of the body, and on the number of ranks."""
    def frequency(place):
        body = Body((2, 3), start=(0, place, 0),
                    size=(0.820093533357078, 0.7236854848560936, 1),
                    material=dict(RUBBER, rho=2, E=4, nu=0.4),
                    sides={"right": "symmetryPlane"})
        _, log = SmallCase(tmp_path/str(place), body, 0.01,
                           preset=DEFAULT).attempt()
        return float(log.split("largest frequency ")[1].split()[0])

    found = [frequency(0.07069232149716853*i) for i in range(20)]
    with figures("a body with a mirror, moved along it") as f:
        f.atMost("largest / least frequency - 1", max(found)/min(found) - 1,
                 1e-9)


BOXES = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Box(2) = {1.02, 0.2, 0.1, 1, 1, 1};
Mesh.CharacteristicLengthMax = 0.4;
Physical Volume("volume", 1) = {1, 2};
Physical Surface("surface", 2) = {1:12};
"""


def test_surface_with_itself(tmp_path, figures):
    """Two boxes of one region; their surface touches itself and slides. The
    choice of the minus face does not depend on the number of ranks."""
    def boxes(name):
        body = GmshBody(
            name="boxes", geometry=BOXES, sides={"surface": "contact"},
            material=RUBBER, velocity=lambda X: np.where(
                X[:, :1] < 1.01, 1, -1)*np.array((0.05, 0.1, 0.03)))
        return SmallCase(tmp_path/name, body, 1.0, preset=DEFAULT,
                         control={"maxCo": 0.9}, interfaces={
                             "all": {"surfaces": "all", "law": coulomb(0.3)}})
    serial = boxes("serial").run()
    parallel = boxes("parallel").runParallel(3, "random")
    e = serial.energies
    with figures("surface with itself, 3 ranks") as f:
        f.atLeast("friction / initial energy",
                  e["total:frictionDissipation"][-1]/e["total:kinetic"][0],
                  1e-2)
        for name in "pointU", "acceleration":
            a, b = (Case(c.path).field("1", "boxes", name)
                    for c in (serial, parallel))
            f.atMost(f"{name}: difference / largest",
                     largest(a - b)/largest(a), 1e-10)
