"""Decomposed runs give the serial result."""

from dataclasses import replace

import numpy as np
import pytest

from vertexContactTests.caseTools import DEFAULT, Scene
from vertexContactTests.collisions import SCENES as COLLISIONS, collision
from vertexContactTests.smallCases import largest

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
            # Written with ten digits, of which the last one may differ
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
    """Every field of three ranks is that of one."""
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
                # What has slid is a difference of displacements
                scale = (serial.at("pointD", region=body.name)
                         if file.name == "contactSlide" else a)
                f.atMost(f"{body.name} {file.name}: difference / largest",
                         largest(a - b)/max(largest(scale), 1e-12), 1e-10)
