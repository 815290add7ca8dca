"""Contact of curved surfaces, whose faces are flat and do not match: two
rings, one inside the other."""

from dataclasses import dataclass

import numpy as np
import pytest

from vertexContactTests.caseTools import DEFAULT
from vertexContactTests.smallCases import (Body, SmallCase, condition,
                                           friction, interface, largest, polar,
                                           smooth, table)

INNER, MIDDLE, OUTER = 1, 1.5, 2    # radii
CONTROL = {"maxCo": 0.9}


def pressure(p, time):
    """A pressure that rises smoothly within a time."""
    s = np.linspace(0, 1, 101)
    return condition("pressure", pressure=table(
        *zip(time*s, p*smooth(s))))


def between(k=0, **more):
    """The interface between both rings, with or without friction."""
    return {"contact": interface(("inner", "right"), ("outer", "left"),
                                 friction(k), pairing="nearestFace", **more)}


def quarter(name, a, b, n, around, **sides):
    """A quarter of a ring between mirrors."""
    return Body((n, around), name=name, start=(a, 0, 0),
                size=(b - a, np.pi/2, 1), moved=polar,
                sides={"bottom": "symmetryPlane", "top": "symmetryPlane",
                       **sides})


def squeezed(folder, bodies, interfaces=None):
    """The rings are compressed by a sixth of their radius."""
    T = 40
    for body in bodies:
        if body.name != "inner":
            body.sides["right"] = pressure(0.1, 0.6*T)
    return SmallCase(folder, bodies, T, interfaces=interfaces, preset=DEFAULT,
                     control=CONTROL).run()


def inwards(case, region):
    """Radial displacement of the nodes on the middle radius, inwards."""
    X, D = case.X(region), case.at("pointD", region=region)
    r = np.hypot(X[:, 0], X[:, 1])
    there = np.abs(r - MIDDLE) < 1e-6
    return -np.sum((X*D)[there, :2], axis=1)/r[there]


def test_curved_patch(tmp_path, figures):
    """Uniform pressure on the outer ring: the errors of the displacement of
    both surfaces, and the unevenness of the displacement, fall with the square
    of h."""
    whole = squeezed(tmp_path/"whole", [quarter("ring", INNER, OUTER, 24, 96)])
    exact = inwards(whole, "ring").mean()
    errors = []
    for n in 2, 4, 8:
        case = squeezed(tmp_path/f"{n}", [
            quarter("inner", INNER, MIDDLE, n, 3*n, right="contact"),
            quarter("outer", MIDDLE, OUTER, n, 4*n, left="contact")],
            between())
        u = [inwards(case, region) for region in ("inner", "outer")]
        errors.append([max(abs(v.mean()/exact - 1) for v in u),
                       max(v.std()/exact for v in u)])
    errors = np.array(errors)
    with figures("pressure on two rings whose meshes do not match") as f:
        f.within("displacement of one ring", exact, 0.178, 0.001)
        for name, e, last in zip(("mean", "scatter"), errors.T,
                                 (2e-3, 5e-5)):
            f.atMost(f"error of the displacement, {name}, finest", e[-1], last)
            f.atLeast(f"{name}, ratio of two meshes, least",
                      min(e[:-1]/e[1:]), 3)


@dataclass
class Ring(Body):
    """A whole ring. The cells are through and around it; size is its radii."""

    def mesh(self):
        n, around = self.cells
        square = ((1, 0), (0, 1), (-1, 0), (0, -1))
        corners = [(r*x, r*y, z) for z in (0, 1) for r in self.size
                   for x, y in square]
        blocks = []
        faces = {side: [] for side in self.patches}
        for i in range(4):
            j = (i + 1) % 4
            back = i, 4 + i, 4 + j, j
            front = tuple(k + 8 for k in back)
            blocks += ["hex", back + front, (n, around//4, 1),
                       "simpleGrading (1 1 1)"]
            faces["left"].append((i, i + 8, j + 8, j))
            faces["right"].append((4 + i, 4 + j, 12 + j, 12 + i))
            faces["back"].append(back)
            faces["front"].append(front)
        return {"vertices": corners, "blocks": blocks,
                "boundary": self.boundary(faces)}

    @property
    def patches(self):
        return "left", "right", "back", "front"


def round_(X):
    """Rings from squares that stand on their corners."""
    x, y = X[:, 0], X[:, 1]
    r = np.abs(x) + np.abs(y)
    s = np.where(y >= 0, np.where(x >= 0, y, 2*r - y),
                 np.where(x < 0, 2*r - y, 4*r + y))
    angle = np.pi/2*s/r
    return np.stack((r*np.cos(angle), r*np.sin(angle), X[:, 2]), axis=1)


def turning(folder, n, **more):
    """The inner ring rotates in the outer one, which is pressed onto it."""
    spin, T = 0.1, 60
    return SmallCase(
        folder,
        [Ring((n, 12*n), name="inner", size=(INNER, MIDDLE), moved=round_,
              velocity=lambda X: spin*X[:, (1, 0, 2)]*(-1, 1, 0),
              sides={"right": "contact"}),
         Ring((n, 16*n), name="outer", size=(MIDDLE, OUTER), moved=round_,
              sides={"left": "contact", "right": pressure(0.05, T/3)})],
        T, interfaces=between(**more), preset=DEFAULT, control=CONTROL).run()


def test_turning_in_each_other(tmp_path, figures):
    """Almost one turn without friction. Faces that pass each other reduce the
    spin slightly and never increase it, however far they slide between two
    pairings. The change of the angular momentum is that of the load: a single
    ring under the pressure has 1e-6 of it."""
    lost = {}
    with figures("a ring turns in another one") as f:
        for n in 4, 8:
            for distance in 0.1, 0.4:
                case = turning(tmp_path/f"{n}-{distance}", n,
                               updateDistance=distance)
                L = case.momentum["inner:Lz"]
                total = L + case.momentum["outer:Lz"]
                kinetic = case.energies["total:kinetic"]
                lost[n, distance] = 1 - L[-1]/L[0]
                name = f"{n} cells, updateDistance {distance}"
                f.atMost(f"{name}: change of the angular momentum",
                         largest(total/total[0] - 1), 2e-5)
                f.atMost(f"{name}: most that contact gives / kinetic energy",
                         case.energies["total:contactWork"].max()/kinetic[0],
                         1e-6)
        f.within("4 cells: spin lost", lost[4, 0.1], 0.050, 0.01)
        f.within("4 cells, updateDistance 0.4", lost[4, 0.4], 0.080, 0.02)
        for distance in 0.1, 0.4:
            f.atLeast(f"loss of 4 / of 8 cells, {distance}",
                      lost[4, distance]/lost[8, distance], 3)


@pytest.mark.parametrize("k", (0.1, 0.5))
def test_turning_with_friction(tmp_path, figures, k):
    """The energy that friction dissipates is the energy that contact
    dissipates, up to a few per cent."""
    case = turning(tmp_path, 8, k=k)
    e = case.energies
    friction = e["total:frictionDissipation"][-1]
    with figures(f"a ring turns in another one, k = {k}") as f:
        f.within("work of contact / friction",
                 -e["total:contactWork"][-1]/friction, 1, 0.02)
        f.atMost("difference of the spins at the end / at first", abs(
            case.momentum["inner:Lz"][-1]/(MIDDLE**4 - INNER**4)
            - case.momentum["outer:Lz"][-1]/(OUTER**4 - MIDDLE**4))
            / (case.momentum["inner:Lz"][0]/(MIDDLE**4 - INNER**4)), 0.1)
