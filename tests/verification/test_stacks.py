"""Bodies that lie on each other: a stack of rubber and steel with its static
sag, and a block in the corner between two others."""

import numpy as np
import pytest

from vertexContactTests.caseTools import DEFAULT, rise
from vertexContactTests.smallCases import (FLOOR, Body, SmallCase, condition,
                                           interface, largest, slowly)

CLAMP = condition("fixedVelocity", velocity=(0, 0, 0))


def coming(weight, time):
    """Gravity that rises smoothly."""
    return slowly(time, np.zeros(3), np.array(weight))


def test_sag_of_a_stack(tmp_path, figures):
    """Rubber, steel and rubber on a plane, without matching meshes and
    friction: their heights at rest are the static ones, and remain."""
    g, h, T = 0.002, 0.5, 1200
    rubber = {"type": "neoHookean", "rho": 1, "E": 1, "nu": 0.45}
    steel = {"type": "neoHookean", "rho": 8, "E": 200, "nu": 0.3}
    names = "lower", "middle", "upper"
    blocks = [Body(
        cells=cells, name=name, start=(0, i*h, 0), size=(1, h, 1),
        material=material, forces=coming((0, -g, 0), T/3),
        sides={"left": "symmetryPlane", "bottom": "contact",
               **({} if name == "upper" else {"top": "contact"})})
        for i, (name, cells, material) in enumerate(zip(
            names, ((8, 4), (5, 3), (7, 4)), (rubber, steel, rubber)))]
    touch = {"floor": {"side": ("lower", "bottom"), "obstacle": FLOOR}}
    for below, above in zip(names, names[1:]):
        touch[above] = interface((below, "top"), (above, "bottom"),
                                 pairing="nearestFace")
    case = SmallCase(tmp_path, blocks, T, interfaces=touch,
                     functions=("contactForces",), preset=DEFAULT,
                     control={"writeInterval": T/12}).run()

    # Stress -(above + rho g (h - y)) in a strip that can widen freely
    above, foot, sags = 0, 0, {}
    loads = {}
    for body in reversed(blocks):
        loads[body.name] = above
        above += body.material["rho"]*g*h
    for body in blocks:
        m = body.material
        E = m["E"]/(1 - m["nu"]**2)
        sag = (loads[body.name]*h + m["rho"]*g*h**2/2)/E
        foot += sag
        sags[body.name] = foot

    def top(body, time):
        """Mean height over the width, which bulging does not change."""
        X = case.X(body.name)
        D = case.at("pointD", time, body.name)[:, 1]
        line = np.flatnonzero(np.isclose(X[:, 1], X[:, 1].max())
                              & np.isclose(X[:, 2], 0))
        line = line[np.argsort(X[line, 0])]
        return -np.trapezoid(D[line], X[line, 0])

    with figures("stack of rubber, steel and rubber") as f:
        for body in blocks:
            f.within(f"sag of the top, {body.name} / statics",
                     top(body, case.last)/sags[body.name], 1, 0.02)
            late = [top(body, t) for t in case.times[8:]]
            f.atMost(f"it moves in the last third, {body.name} / sag",
                     np.ptp(late)/sags[body.name], 6e-5)
        for name, body in zip(touch, names):
            contact = case.contact(name)
            sides = [c[:-3] for c in contact if c.endswith(":Fy")]
            Fx, Fy = (contact[f"{sides[0]}:F{c}"][-len(contact["Time"])//10:]
                      .mean() for c in "xy")
            f.within(f"force, {name} / weight above", abs(Fy)
                     / (loads[body] + g*h*next(
                         b.material["rho"] for b in blocks if b.name == body)),
                     1, 0.01)
            # Rubber widens more than steel: its edge bends round the edge of
            # the steel
            f.atMost(f"tangential / normal force, {name}", abs(Fx/Fy),
                     1e-6 if name == "floor" else 1e-4)


def forcesOf(case, named, pairs):
    """Forces on the block by each pair, in the last tenth of the time. The
    pair has a row of the interface of all surfaces, or an interface of its
    own."""
    forces = []
    for side, name, other in pairs:
        contact = case.contact(name if named else "all")
        label, its = f"block.{side}", slice(None)
        if not named:
            its = ((contact["minus"] == label)
                   & (contact["plus"] == f"{name}.{other}"))
            label = "minus"
        F = np.array([contact[f"{label}:F{c}"][its] for c in "xyz"])
        forces.append(F[:, -F.shape[1]//10:].mean(axis=1))
    return np.array(forces)


CORNERS = {"named": ((4, 4), (6, 5), (5, 6)),
           "general": ((4, 4), (6, 5), (5, 6)),
           "general, 3D": ((3, 3, 3), (5, 3, 4), (3, 5, 4))}


@pytest.mark.parametrize("name", CORNERS)
def test_corner_between_three(tmp_path, figures, name):
    """A block is pushed into the corner between two others: its edge touches
    both. By mirror symmetry both contacts agree."""
    cells, named = CORNERS[name], name == "named"
    g, T = 0.01, 300 if "3D" in name else 600
    material = {"type": "neoHookean", "rho": 1, "E": 1, "nu": 0.3}
    bodies = [
        Body(cells=cells[0], name="block", material=material, forces=coming(
            (-g, -g, 0), T/3), sides={"bottom": "contact", "left": "contact"}),
        Body(cells=cells[1], name="floor", start=(0, -1, 0), material=material,
             sides={"bottom": CLAMP, "top": "contact"}),
        Body(cells=cells[2], name="wall", start=(-1, 0, 0), material=material,
             sides={"left": CLAMP, "right": "contact"})]
    pairs = ("bottom", "floor", "top"), ("left", "wall", "right")
    touch = {"all": {"surfaces": "all"}}
    if named:
        touch = {name: interface(("block", side), (name, other),
                                 pairing="nearestFace")
                 for side, name, other in pairs}
    case = SmallCase(tmp_path, bodies, T, interfaces=touch, preset=DEFAULT,
                     functions=("contactForces",)).run()
    X, D = case.X("block"), case.at("pointD", region="block")
    row = {tuple(x): i for i, x in enumerate(np.round(X, 8) + 0.0)}
    swapped = [row[tuple(x)] for x in np.round(X[:, [1, 0, 2]], 8) + 0.0]
    corner = np.flatnonzero(np.isclose(X[:, 0] + X[:, 1], 0))
    K = case.energies["total:kinetic"]
    own = case.ownEnergy
    forces = forcesOf(case, named, pairs)/g
    with figures(f"block in a corner, {name} contact") as f:
        f.atMost("asymmetry / largest displacement", largest(
            D[swapped][:, [1, 0, 2]] - D)/largest(D), 1e-7)
        f.atMost("kinetic energy at the end / strain energy",
                 K[-1]/case.energies["total:strain"][-1], 1e-6)
        f.atMost("edge in both surfaces / cell",
                 largest(np.minimum(D[corner][:, :2], 0))*cells[0][0], 0.1)
        f.atMost("energy gained / strain energy",
                 rise(own, case.energies["total:strain"].max()), 1e-3)
        # Compliant surfaces are no longer flat: each carries a part of the
        # load of the other
        for i, c in enumerate("xy"):
            f.within(f"F{c} of both / weight", forces[:, i].sum(), 1, 1e-4)
            f.atMost(f"of the tangential one, F{c}", abs(forces[i, i]), 5e-3)
        f.atMost("difference of both, mirrored / weight",
                 largest(forces[0] - forces[1][[1, 0, 2]]), 1e-7)
