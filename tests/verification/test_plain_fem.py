"""The plain finite elements with which the trade compares: they are correct,
so that the comparison is meaningful, and how they are called."""

import pytest

from vertexContactCases import readResults
from vertexContactTests.caseTools import execute
from vertexContactTests.trade import peers
from vertexContactTests.trade.cases import CASES

# At the end: impulse, energy, plastic work, and number of steps, on coarse
# meshes. The histories agree to 1e-4 with those of another program that was
# written independently
KNOWN = {
    ("rings", 5): (-2.32314, 0.978053, 0, 1216),
    ("taylor", 2): (0.485925, 0.0025271, 0.955063, 1593)}


@pytest.fixture(scope="module")
def program():
    return str(peers.program())


def test_patch_test_and_closed_forms(program, tmp_path):
    """Patch test, energies, and closed forms: one line for each."""
    done = execute([program, "verify"], tmp_path)
    assert done.returncode == 0, done.stdout
    assert done.stdout.count(" ok\n") == len(done.stdout.splitlines()) > 40


@pytest.mark.parametrize("name, mesh", KNOWN)
def test_histories_of_another_program(name, mesh, program, tmp_path, figures):
    file = tmp_path/"histories.csv"
    said = peers.run(name, mesh, file)
    end = {key: column[-1] for key, column in readResults.csv(file).items()}
    impulse, energy, work, steps = KNOWN[name, mesh]
    with figures(f"plain FEM, {CASES[name].title}, {mesh} elements") as f:
        f.within("impulse [N s]", end["impulse"], impulse, 1e-3*abs(impulse))
        f.within("energy / initial", end["energy"], energy, 1e-3)
        f.within("plastic work / initial", end["plasticWork"], work, 1e-3)
        f.within("steps", said["steps"], steps, 1e-3*steps)
        f.atMost("rise of the energy", said["rise"], 1e-3)


def test_errors(program):
    """Both kinds of runs have the same columns. The time of two bodies is
    twice the time of one."""
    errors, costs = peers.once("incompressible", 4)
    assert {"error", "velocity", "force", "energy", "rise"} <= set(errors)
    assert costs["nodes"] == 2*5*21
    assert costs["us"] == pytest.approx(
        1e6*costs["seconds"]/costs["steps"]/costs["nodes"])
    errors, costs = peers.once("similar", 256)
    assert errors["error"] == pytest.approx(0.00954, rel=0.01)
    assert costs["nodes"] == 2*257


@pytest.mark.parametrize("words", (
    "", "rings", "rings 0", "rings -5", "rings 5.5", "rings five", "taylor 3",
    "square 4", "verify 4", "rings 5 6", "rings 5 -co", "rings 5 -co 0",
    "rings 5 -co nan", "rings 5 -samples 0", "rings 5 -speed 2",
    "rings 5 -out /no/such/folder/file"))
def test_wrong_words(words, program, tmp_path):
    """One line names the fault."""
    done = execute([program, *words.split()], tmp_path)
    assert done.returncode == 1
    assert done.stdout.startswith("plainFEM: ")
    assert len(done.stdout.splitlines()) == 1


def test_help(program, tmp_path):
    done = execute([program, "-h"], tmp_path)
    assert done.returncode == 0 and all(name in done.stdout for name in CASES)


def test_unstable(program, tmp_path):
    """A step above the stable one is an error, and there is no table."""
    done = execute([program, "similar", "64", "-co", "1.3"], tmp_path)
    assert done.returncode == 1 and done.stdout.startswith("plainFEM: not")
