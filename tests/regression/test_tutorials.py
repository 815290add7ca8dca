"""Allrun and Allclean of the tutorials, as a user calls them."""

import shutil

import pytest

from vertexContactTests.caseTools import (TUTORIALS, checked, coarse,
                                          copyTutorials, execute, root)

FAULTY = "twoBarImpact/similar"     # the tutorial for the tests of failures


@pytest.fixture
def repository(tmp_path):
    """A copy of the tutorials in a git repository, with the project's ignore
    rules."""
    folder = copyTutorials(tmp_path/"tutorials")
    shutil.copy(root/".gitignore", tmp_path)
    checked(["git", "init", "-q"], tmp_path)
    checked(["git", "add", "-A"], tmp_path)
    return folder


def changes(repository):
    """Files that were made (ignored or not), and files that were changed or
    removed."""
    return (checked(["git", "ls-files", "--others"], repository)
            + checked(["git", "diff", "--name-status"], repository)).split()


@pytest.mark.parametrize("tutorial", TUTORIALS)
def test_tutorial(repository, figures, tmp_path, tutorial):
    case = repository/tutorial
    allrun = str(case/"Allrun")         # called from another folder
    output = checked([allrun], tmp_path, **coarse(tutorial))
    assert len(output.splitlines()) < 20
    pictures = sorted(case.glob("*.png"))
    assert pictures and all(p.stat().st_size > 10000 for p in pictures)
    first = (case/"postProcessing/solidEnergies/0/energies.dat").read_bytes()

    # Only files that git ignores
    untracked = checked(["git", "status", "--porcelain"], repository)
    untracked = [line for line in untracked.splitlines()
                 if not line.startswith("A  ")]
    assert untracked == []

    # A separate copy in the active environment, with the files that the run
    # left
    mine = tmp_path/"mine"
    shutil.copytree(case, mine)
    checked(["./Allrun"], mine, **coarse(tutorial), PLOT="0")
    assert not list(mine.glob("*.png"))
    second = (mine/"postProcessing/solidEnergies/0/energies.dat").read_bytes()

    checked([str(case/"Allclean")], tmp_path)
    with figures(f"7 {tutorial}") as f:
        f.equal("second Allrun repeats the first", first == second, True)
        f.equal("files left by Allclean", changes(repository), [])


@pytest.mark.parametrize("variable, value", (
    ("MESH", "V"), ("MESH", "-3"), ("NP", "0"), ("NP", "two")))
def test_wrong_option(repository, variable, value):
    case = repository/FAULTY
    done = execute(["./Allrun"], case, PLOT="0",
                   **{**coarse(FAULTY), variable: value})
    assert done.returncode != 0
    assert "FAILED" in done.stdout and f"{variable}={value}" in done.stdout


def test_failure_is_reported(repository):
    """The output has the program that failed, the end of its log and an exit
    code."""
    case = repository/FAULTY
    (case/"constant"/"bar2"/"mechanicalProperties").unlink()
    done = execute(["./Allrun"], case, PLOT="0", **coarse(FAULTY))
    assert done.returncode != 0
    assert "FAILED: vertexContactFoam" in done.stdout
    assert "FOAM FATAL" in done.stdout
