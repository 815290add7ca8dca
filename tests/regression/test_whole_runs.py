"""Whole runs of tutorials on coarse meshes: two ranks give the result of one.
Sums have another order there. Round-off must not be amplified, neither by
contact that opens and closes hundreds of times, nor by a sensor that
switches."""

import pytest

from vertexContactTests.caseTools import DEFAULT, Tutorial, timeFolders
from vertexContactTests.fieldReferences import TUTORIALS
from vertexContactTests.smallCases import largest

# Tutorials in which surfaces slide along each other, or which yield
CHOSEN = [(path, mesh, tuple(options.items()))
          for path, mesh, _, options in TUTORIALS
          if path in ("ringCollision", "torusImpact/elastoPlastic",
                      "selfContact", "taylorBar") or options]
SCENES = [[Tutorial(path, mesh, options=options, preset=DEFAULT, ranks=ranks)
           for ranks in (1, 2)] for path, mesh, options in CHOSEN]


@pytest.mark.scenes(*(scene for both in SCENES for scene in both))
@pytest.mark.parametrize("both", SCENES, ids=[path for path, _, _ in CHOSEN])
def test_two_ranks(run, figures, both):
    one, two = map(run, both)
    last = timeFolders(one.path)[-1]
    assert timeFolders(two.path)[-1] == last
    E = [case.totalEnergy for case in (one, two)]
    with figures(f"whole run of {both[0].path}, two ranks") as f:
        f.equal("steps", *map(len, E))
        f.atMost("energy at the end: difference / initial",
                 abs(E[1][-1] - E[0][-1])/E[0][0], 1e-10)
        for name in "pointD", "pointU":
            a, b = ([case.field(last, region, name)
                     for region in case.regions] for case in (one, two))
            scale = max(map(largest, a))
            f.atMost(f"{name} at the end: difference / largest", max(
                largest(x - y) for x, y in zip(a, b))/scale, 1e-10)
