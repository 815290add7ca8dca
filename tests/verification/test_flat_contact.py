"""Contact on a flat base: without friction no force acts along the base, no
gap remains, and forces over a gap are distinguished from closed contact."""

import numpy as np
import pytest

from vertexContactTests.caseTools import DEFAULT
from vertexContactTests.contactScenes import rigid
from vertexContactTests.smallCases import (ELASTIC, FLOOR, Body, SmallCase,
                                           condition, interface, slowly)

SOFT = {"type": "neoHookean", "rho": 1, "E": 1, "nu": 0.3}
STEEL = {"type": "neoHookean", "rho": 8, "E": 200, "nu": 0.3}
HELD = rigid(freeTranslation="()", freeRotation="()")


def rest(folder, block, base, g, time, **more):
    """A block on a base (a body or an obstacle), under gravity that rises
    smoothly."""
    block.forces = slowly(time/2, np.zeros(3), np.array((0, -g, 0)))
    bodies, touch = [block], {"side": ("block", "bottom"), "obstacle": base}
    if isinstance(base, Body):
        bodies.append(base)
        touch = interface(("block", "bottom"), ("base", "top"),
                          pairing="nearestFace")
    return SmallCase(folder, bodies, time, interfaces={"contact": touch},
                     functions=("contactForces",), preset=DEFAULT,
                     **more).run()


def along(contact, part=slice(None)):
    """Forces on the block along the base and normal to it, by time."""
    return (np.array([contact[f"block.bottom:F{c}"] for c in x])[:, part]
            for x in ("xz", "y"))


# Without friction

def wide(cells, material, **sides):
    """A base under the whole path of the block."""
    return Body(cells=cells, name="base", start=(-1, -0.5, -1),
                size=(5, 0.5, 3 if len(cells) == 3 else 1), material=material,
                sides={"top": "contact", **sides})


CLAMP = condition("fixedVelocity", velocity=(0, 0, 0))
BASES = {"plane": FLOOR, "rigid": wide((9, 3), HELD),
         "rigid, 3D": wide((9, 2, 5), HELD),
         "steel": wide((9, 3), STEEL, bottom=CLAMP)}


@pytest.mark.parametrize("name", BASES)
def test_nothing_pulls_along_a_flat_base(tmp_path, figures, name):
    """A soft block slides; the meshes do not match. Its edges give way under
    its weight, so that its surface is slightly inclined there, more for a
    heavier block. Forces along a base that does not give way come only from
    this inclination, and change sign as the block vibrates. A plane has one
    normal everywhere."""
    cells = (4, 3, 4) if "3D" in name else (7, 4)
    block = Body(cells=cells, name="block", material=SOFT,
                 velocity=(0.02, 0, 0), sides={"bottom": "contact"})
    case = rest(tmp_path, block, BASES[name], 1e-3, 60)
    contact = case.contact("contact")
    half = slice(len(contact["Time"])//2, None)
    T, N = along(contact, half)
    exact = name == "plane"
    with figures(f"soft block slides on a flat base, {name}") as f:
        f.within("normal force / weight", N.mean()/1e-3, 1, 1e-3)
        f.atLeast("way / length", case.at("pointD")[:, 0].mean(), 1)
        f.atMost("impulse along / across", max(
            abs(contact[f"block.bottom:I{c}"][-1]) for c in "xz")
            / contact["block.bottom:Iy"][-1], 0 if exact else 1e-6)
        f.atMost("mean force along / across",
                 np.abs(T.mean(axis=1)).max()/N.mean(), 0 if exact else 1e-6)
        f.atMost("force along in any step / mean across",
                 np.abs(T).max()/N.mean(), 0 if exact else 1e-6)


def test_what_pulls_over_an_edge(tmp_path, figures):
    """A block with one end over the edge of a flat base bends round the edge.
    Its surface is inclined there, and the edge pushes it off the base, also
    without friction. The force is the energy that the block releases per
    length as more of it hangs over, dU/dw over the held length, where U is
    half of the work of the weight. It grows with the square of the weight. The
    edge has no normal of its own: the force acts along the normal of the
    block."""
    g, n, step = 1e-3, 14, 0.04
    forces, energies = [], []
    for width in 0.7 - step, 0.7, 0.7 + step:
        block = Body(cells=(n, 8), name="block", material=SOFT, sides={
            "bottom": "contact", "left": "symmetryPlane"})
        base = Body(cells=(18, 6), name="base", start=(-1, -0.5, 0),
                    size=(1 + width, 0.5, 1), material=HELD,
                    sides={"top": "contact"})
        case = rest(tmp_path/f"{width:.2f}", block, base, g, 100)
        contact = case.contact("contact")
        late = slice(-len(contact["Time"])//5, None)
        T, N = along(contact, late)
        forces.append(T[0].mean()/N.mean())
        energies.append(case.energies["total:strain"][late].mean()/N.mean())
    released = (energies[0] - energies[2])/(2*step)
    with figures("block that hangs over an edge") as f:
        f.falling("force along / weight, 0.66 to 0.74 held", forces)
        f.atLeast("dU/dw / weight", released, 1e-4)
        f.within("force along / (dU/dw)", forces[1]/released, 1, 0.1)


# Gaps

RUBBER = {"type": "neoHookean", "rho": 1100, "E": 0.8e6, "nu": 0.45}


@pytest.mark.parametrize("base", ("plane", "rigid"))
def test_nothing_floats(tmp_path, figures, base):
    """Rubber under its own weight, which lowers it by 54 um in theory, on a
    plane and on a rigid region whose mesh does not match. No gap is left, and
    no force acts over a gap. By reciprocity the mean displacement of the top
    is rho g h^2/(2 E'), however the block bulges, since a pressure on the top
    causes the same mean displacement at all heights."""
    g, h, n, time = 9.81, 0.1, 8, 0.2
    block = Body(cells=(n, n), name="block", size=(h, h, 1), material=RUBBER,
                 sides={"bottom": "contact", "left": "symmetryPlane"})
    under = FLOOR if base == "plane" else Body(
        cells=(11, 2), name="base", start=(-h/2, -h/5, 0),
        size=(2*h, h/5, 1), material=HELD, sides={"top": "contact"})
    case = rest(tmp_path, block, under, g, time)
    X, D = case.X("block"), case.at("pointD", region="block")
    foot = np.isclose(X[:, 1], 0)
    top = np.flatnonzero(np.isclose(X[:, 1], h) & (X[:, 2] < 0.5))
    top = top[np.argsort(X[top, 0])]
    theory = RUBBER["rho"]*g*h**2/2*(1 - RUBBER["nu"]**2)/RUBBER["E"]
    contact = case.contact("contact")
    late = contact["Time"] > 0.75*time
    gaps = case.at("contactGap", region="block")[foot]
    with figures(f"rubber rests, {base}") as f:
        f.within("sag in theory [um]", theory*1e6, 54, 0.5)
        f.within("sag / theory",
                 -np.trapezoid(D[top, 1], X[top, 0])/h/theory, 1, 0.02)
        f.within("force / weight",
                 contact["block.bottom:Fy"][late].mean()
                 / (RUBBER["rho"]*g*h**2), 1, 0.01)
        f.within("area / bottom", contact["area"][late].min()/h, 1, 0.01)
        f.atMost("gap or penetration / cell", np.abs(gaps).max()*n/h, 1e-4)
        f.atMost("bottom above or below the base / cell",
                 np.abs(D[foot, 1]).max()*n/h, 1e-4)
        f.equal("force over a gap, at rest",
                contact["gapForce"][late].max(), 0.0)
        f.equal("area of gaps that transmit, at rest",
                contact["gapArea"][late].max(), 0.0)


@pytest.mark.parametrize("against", ("plane", "body"))
def test_force_over_a_gap(tmp_path, figures, against):
    """A bar approaches a plane or another bar. Contact slows it before it
    touches; this force is completely counted as one over a gap. When the gap
    is closed, to 1e-4 of a cell, no such force remains."""
    n, speed, start = 20, 0.05, 0.02
    bar = Body(cells=(n,), name="block", start=(start, 0, 0),
               velocity=(-speed, 0, 0), material=ELASTIC,
               sides={"left": "contact"})
    bodies = [bar, Body(cells=(n,), name="base", start=(-1, 0, 0),
                        material=ELASTIC, sides={"right": "contact"})]
    touch = interface(("block", "left"), ("base", "right"),
                      pairing="nearestFace")
    probes = {"foot": ("block", (start, 0, 0)), "head": ("base", (0, 0, 0))}
    if against == "plane":
        del bodies[1], probes["head"]
        touch = {"side": ("block", "left"), "obstacle": {
            **FLOOR, "pointAndNormalDict": {"point": (0, 0, 0),
                                            "normal": (1, 0, 0)}}}
    case = SmallCase(tmp_path, bodies, 2, interfaces={"contact": touch},
                     functions=("contactForces",), probes=probes,
                     preset=DEFAULT).run()
    contact = case.contact("contact")
    force, over = contact["block.left:Fx"], contact["gapForce"]
    gap = start
    for name, sign in zip(probes, (1, -1)):
        t, D = case.probe(name, "pointD")
        gap = gap + sign*np.interp(contact["Time"], t, D[:, 0])
    gap = gap*n
    on = force > 0
    open_, closed = on & (gap > 2e-4), on & (gap < 5e-5)
    with figures(f"a bar comes upon a {against}") as f:
        f.within("gap when force begins / cell", gap[on][0], 0.05, 0.03)
        f.atLeast("largest force over a gap / (rho c v)", over.max()/speed,
                  0.9 if against == "plane" else 0.45)
        f.atMost("before it has closed: force - that over a gap / largest",
                 np.abs(force - over)[open_].max()/force.max(), 1e-12)
        f.atLeast("rows afterwards", np.count_nonzero(closed), 20)
        f.equal("force over a gap, afterwards", over[closed].max(), 0.0)
        f.equal("area of gaps that transmit, before",
                contact["gapArea"][open_].min(), 1.0)
        f.equal("the same, afterwards", contact["gapArea"][closed].max(), 0.0)
