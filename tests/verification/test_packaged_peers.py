"""Programs from packages with which the trade compares: their input files
describe our cases."""

import shutil

import numpy as np
import pytest

from vertexContactTests.peers import calculix
from vertexContactTests.peers.deck import deck, steps
from vertexContactTests.peers.scenes import SCENES


@pytest.mark.parametrize("name, mesh, nodes, volume", (
    ("column", 2, 3*3*13, 6),
    ("rings", 10, 2*11*124, np.pi*(0.04**2 - 0.03**2)*1e-3),
    ("taylor", 4, 703, np.pi/4*3.2e-3**2*32.4e-3)))
def test_meshes(name, mesh, nodes, volume):
    """Polygons are slightly smaller than circles."""
    scene = SCENES[name](mesh)
    ofNodes, ofElements = scene.mesh.volumes()
    assert len(scene.mesh.points) == nodes
    assert ofNodes.sum() == pytest.approx(ofElements.sum())
    assert 0.97*volume < ofElements.sum() < 1.0001*volume


def test_deck():
    """Steps end at the samples. The plate exists, and results are printed only
    if they are wanted."""
    scene = SCENES["rings"](5)
    every, step = steps(scene)
    assert step <= scene.step
    assert every*scene.samples*step == pytest.approx(scene.end)
    with_, without = (deck(scene, scene.end, p) for p in (True, False))
    assert "*CONTACT PAIR" in with_ and "\nELSE\n" in with_
    assert "\nELSE\n" not in without


@pytest.mark.parametrize("step, steps", (
    ("3.059735e-05", 1308), ("3.333333e-05", 1200)))
def test_steps_that_calculix_takes(step, steps):
    """The number of steps that CalculiX takes, whatever step it was told."""
    log = f" SELECTED time increment:{step}\n"
    assert calculix.stepsTaken(log, 0.04) == steps


@pytest.mark.skipif(not shutil.which("ccx"), reason="no CalculiX")
def test_column():
    table, said = calculix.run("column", 2)
    assert said["nodes"] == 117
    assert table["energy"][-1] == pytest.approx(1, abs=0.02)
