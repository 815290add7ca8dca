"""A heap of a hundred discs."""

import numpy as np
import pytest

from vertexContactCases import heap
from vertexContactTests.caseTools import DEFAULT, Tutorial, rise

DISCS = Tutorial("hundredDiscs", "2", preset=DEFAULT,
                 control=(("writeInterval", 0.2),))


@pytest.mark.scenes(DISCS)
def test_weight_and_momentum_of_a_heap(run, figures):
    """Momentum, energy and weight of a heap. No disc is inside another one or
    in the box."""
    case = run(DISCS)
    _, parts = heap.ledger(case.path)
    gone, *others = parts.values()
    kinetic = parts["kinetic energy"]
    own = kinetic + parts["strain energy"] - gone
    t, force, _, _ = heap.box(case.path)
    rest = t > 0.599
    weight = heap.mass(2)*heap.GRAVITY
    depths = np.array([heap.overlaps(case.path, float(time))
                       for time in case.times])
    state = (case.path/case.times[-1]/"uniform"/"solidSystem").read_text()
    with figures("a hundred discs") as f:
        f.atMost("momentum less impulses / impulse of gravity",
                 np.abs(heap.momentumResidual(case.path, 2)).max(), 1e-12)
        f.atMost("energy that the ledger lacks / turned over",
                 np.abs(gone - sum(others)).max()/gone[-1], 2e-4)
        f.atMost("largest rise of the energy / turned over",
                 rise(own, gone[-1]), 1e-3)
        for name in "friction", "numerical dissipation":
            f.atLeast(f"{name}: least rise in 5 ms / turned over",
                      np.diff(parts[name]).min()/gone[-1], -1e-5)
        f.atMost("kinetic energy at the end / largest",
                 kinetic[-1]/kinetic.max(), 2e-4)
        f.within("force of the box / weight, mean from 0.6 s on",
                 force[rest, 1].mean()/weight, 1, 0.01)
        f.within("force of the box to the side / weight",
                 force[rest, 0].mean()/weight, 0, 0.01)
        f.atMost("deepest corner in a disc / largest radius",
                 depths[:, 0].max()/0.012, 0.1)
        f.atMost("deepest corner in the box / largest radius",
                 depths[:, 1].max()/0.012, 1e-4)
        f.atLeast("pairs that have touched", state.count('"all.'), 250)

