"""Differences between OpenFOAM's releases: in one header, and
tests/compatibility compiles sources against the headers of a release."""

import os
import re

import pytest

from caseTools import execute, root

LIBRARY = "src/vertexContact"
HEADER = f"{LIBRARY}/include/compat.H"
FEW = (f"{LIBRARY}/contact/contactPairing/AMI/AMI.C",
       f"{LIBRARY}/contact/contactLaw/Coulomb/Coulomb.C",
       f"{LIBRARY}/materialModels/materialModel/materialModel.C")


def compatibility(*arguments, **environment):
    done = execute([str(root/"tests"/"compatibility"), *map(str, arguments)],
                   root, **environment)
    return done.returncode, done.stdout


def test_one_header(figures):
    """No source but compat.H asks for the release."""
    switches = {}
    for top in "src", "applications", "tests":
        for file in (root/top).rglob("*.[CH]"):
            if file.parent.name == "lnInclude":
                continue
            count = len(re.findall(r"(?m)^\s*#\s*(?:el)?if.*\bOPENFOAM",
                                   file.read_text()))
            if count:
                switches[str(file.relative_to(root))] = count
    with figures("switches by release") as f:
        f.equal("files", list(switches), [HEADER])
        f.atMost("switches", sum(switches.values()), 14)


def test_installed_release(figures):
    """A few files against the release that is installed."""
    code, output = compatibility(os.environ["WM_PROJECT_DIR"], *FEW)
    lines = output.splitlines()
    with figures("tests/compatibility, installed release") as f:
        f.equal("exit code", code, 0)
        f.equal("files ok", sum(line == f"ok      {file}" for line in lines
                                for file in FEW), len(FEW))
        f.equal("count", lines[-1].split(": ")[1], "3 files, 3 ok, 0 FAILED")


def test_failures_show():
    """What does not compile is an error, with the reason."""
    code, output = compatibility(os.environ["WM_PROJECT_DIR"], FEW[1],
                                 CXX="false")
    assert code == 1
    assert f"FAILED  {FEW[1]}" in output
    assert "1 files, 0 ok, 1 FAILED" in output


@pytest.mark.parametrize("arguments, reason", (
    ((), "which OpenFOAM?"), (("/nowhere",), "no src/OpenFOAM"),
    (("-jobs", "none"), "-jobs wants a number"),
    ((os.environ.get("WM_PROJECT_DIR", "."), "src/none.C"),
     "'src/none.C' is in no Make/files")))
def test_wrong_arguments(arguments, reason):
    code, output = compatibility(*arguments)
    assert code == 2
    assert reason in output
