"""A material and a contact law in a separate library (plugin/): compiled
outside the checkout, loaded by controlDict, and correct."""

import shutil
from pathlib import Path

import numpy as np
import pytest

from vertexContactTests import caseTools
from vertexContactTests.caseTools import DEFAULT, checked
from vertexContactTests.smallCases import (ELASTIC, Body, SmallCase, condition,
                                           interface, largest)

PLUGIN = Path(__file__).resolve().parent/"plugin"
NEW = "SaintVenantKirchhoff", "Orowan"

# M = lambda + 2 mu = 1 and rho = 1, so c_p = 1
MATERIAL = {"type": "SaintVenantKirchhoff", "rho": 1, "E": 1, "nu": 0}
V = 0.15

HEIGHT, LENGTH, WEIGHT, SPEED, FRICTION = 0.5, 2, 0.02, 0.04, 0.3
MASS = HEIGHT*LENGTH
LIMITS = {"limited": 0.001, "unlimited": 1}     # k p is 0.003


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """The library, compiled from a copy of its folder only."""
    folder = tmp_path_factory.mktemp("plugin")
    for name in ("Make", *NEW):
        shutil.copytree(PLUGIN/name, folder/name,
                        ignore=shutil.ignore_patterns("linux*", "darwin*"))
    files = folder/"Make"/"files"
    product = folder/"libplugin"
    text = files.read_text()
    files.write_text(text.replace("$(FOAM_USER_LIBBIN)/libplugin",
                                  str(product)))
    assert files.read_text() != text
    checked(["wmake", "-s", "libso"], folder)
    return product.with_suffix(".so")


def bars():
    """Two equal bars that collide at 2 V."""
    return [Body(cells=(100,), name=name, start=(x, 0, 0), material=MATERIAL,
                 velocity=(v, 0, 0), sides={side: "contact"})
            for name, x, v, side in (("left", -1, V, "right"),
                                     ("right", 0, -V, "left"))]


def compressed():
    """Stretch and pressure between the bars. Compression makes the bars
    softer, so the impact causes a fan and not a shock: du = c dF with c^2 =
    dP/dF, P = F (F^2 - 1)/2."""
    F = np.linspace(1, 0.6, 100001)
    c = np.sqrt((3*F**2 - 1)/2)
    u = np.concatenate(([0], np.cumsum((c[1:] + c[:-1])/2*-np.diff(F))))
    stretch = np.interp(V, u, F)
    return stretch, -stretch*(stretch**2 - 1)/2


def stack(name, x):
    """A block slides on a base; its weight is in equilibrium."""
    def settle(X):
        y = X[:, 1:2]
        return -WEIGHT*(2*HEIGHT*y - y**2/2)*(0, 1, 0)

    common = {"cells": (16, 4), "size": (LENGTH, HEIGHT, 1),
              "displacement": settle}
    clamp = condition("fixedVelocity", velocity=(0, 0, 0))
    return [Body(name=f"{name}Base", start=(x, 0, 0), material=ELASTIC,
                 sides={"bottom": clamp, "top": "contact"}, **common),
            Body(name=f"{name}Block", start=(x, HEIGHT, 0), material=MATERIAL,
                 velocity=(SPEED, 0, 0), sides={"bottom": "contact"},
                 **common)]


def test_plugin(tmp_path, figures, library):
    """Two bars of the new material collide: the pressure between them is that
    of the exact simple wave. Two blocks slide with the new law: where its
    limit is reached, the shear traction times the area slows the block,
    independent of the pressure. Otherwise Coulomb friction does. The impulse
    of contact equals the change of momentum."""
    stacks = [body for i, name in enumerate(LIMITS)
              for body in stack(name, 10*i)]
    interfaces = {"bars": interface(("left", "right"), ("right", "left"))}
    for name, limit in LIMITS.items():
        interfaces[name] = interface(
            (f"{name}Block", "bottom"), (f"{name}Base", "top"),
            {"type": "Orowan", "frictionCoeff": FRICTION, "tauMax": limit})
    case = SmallCase(
        tmp_path, [*bars(), *stacks], endTime=5, interfaces=interfaces,
        gravity=(0, -WEIGHT, 0), functions=("contactForces",),
        control={"libs": f'(vertexContact "{library}")'}).run()

    contact = case.contact("bars")
    plateau = (contact["Time"] > 0.2) & (contact["Time"] < 1.5)
    t, I = (contact[c][plateau] for c in ("Time", "left.right:Ix"))
    force = -np.polyfit(t, I, 1)[0]
    stretch, pressure = compressed()

    with figures("plugin: new material, impact of two bars") as f:
        f.within("pressure / exact", force/pressure, 1, 0.005)
        f.atLeast("the same for a linear law / exact", V/pressure, 1.1)
        f.atMost("balance residual / initial kinetic energy of the bars",
                 largest(case.energies["total:balance"])/V**2, 5e-3)

    t = case.momentum["Time"]
    sliding = t > 1
    exact = {"limited": LIMITS["limited"]*LENGTH,
             "unlimited": FRICTION*WEIGHT*MASS}
    with figures("plugin: new contact law, sliding blocks") as f:
        for name, friction in exact.items():
            p = case.momentumOf(f"{name}Block")[:, 0]
            slope = np.polyfit(t[sliding], p[sliding], 1)[0]
            f.within(f"{name}: friction / exact", -slope/friction, 1, 0.02)
            I = case.contact(name)[f"{name}Block.bottom:Ix"]
            f.atMost(f"{name}: impulse - change of momentum / initial",
                     abs(I[-1] - (p[-1] - p[0]))/p[0], 1e-12)


def test_sticks(tmp_path, figures, library):
    """With the default scheme a block slides down a base that is inclined by
    half of the angle of friction. It becomes slower and stays where it stops.
    It goes farther than a rigid block, because parts of its base vibrate
    backwards."""
    name = "block"
    case = SmallCase(
        tmp_path, stack(name, 0), endTime=55, preset=DEFAULT,
        interfaces={name: interface(
            (f"{name}Block", "bottom"), (f"{name}Base", "top"),
            {"type": "Orowan", "frictionCoeff": FRICTION,
             "tauMax": LIMITS["unlimited"]}, pairing="nearestFace")},
        gravity=(0.5*FRICTION*WEIGHT, -WEIGHT, 0), functions=("contactForces",),
        control={"libs": f'(vertexContact "{library}")'}).run()
    t, v = case.momentum["Time"], case.momentumOf(f"{name}Block")[:, 0]/MASS
    stopped = SPEED/(0.5*FRICTION*WEIGHT)
    way = np.concatenate(([0], np.cumsum((v[1:] + v[:-1])/2*np.diff(t))))
    # The stopped block vibrates on its base
    early, late = (way[(t > a*stopped) & (t < (a + 1)*stopped)].mean()
                   for a in (2, 3))
    with figures("plugin: new contact law, sticking block") as f:
        f.atLeast("way until it stops / of a rigid block",
                  early/(SPEED*stopped/2), 0.95)
        f.atMost("way after that / cell", abs(late - early)/(LENGTH/16), 1e-3)


def test_nothing_else_knows(figures):
    """Neither the library nor the programs contain the names that the plugin
    adds."""
    named = [path for top in ("src", "applications")
             for path in (caseTools.root/top).rglob("*")
             if path.is_file() and path.parent.name != "lnInclude"
             and (path.suffix in (".C", ".H") or path.parent.name == "Make")
             and any(name in path.read_text() for name in NEW)]
    with figures("plugin: only its own folder") as f:
        f.equal("files that name it", named, [])


def test_valid_choices(tmp_path, library):
    """The error about a wrong name also lists the models of the plugin."""
    body = Body(cells=(2,), material={**MATERIAL, "type": "Kirchhoff"})
    code, log = SmallCase(tmp_path, body, endTime=1, control={
        "libs": f'(vertexContact "{library}")'}).attempt()
    assert code != 0
    assert "SaintVenantKirchhoff" in log and "neoHookean" in log
