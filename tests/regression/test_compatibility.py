"""Differences between OpenFOAM's releases are in one header.
tests/compatibility compiles sources against the headers of a release, or
builds and runs the release. Here only the arguments that it refuses and its
comparison are tested."""

import copy
import os
import re

import pytest

from vertexContactTests import checkRelease
from vertexContactTests.caseTools import checked, execute, root

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
    """Only compat.H asks for the release."""
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
    """Compile a few files against the installed release."""
    code, output = compatibility(os.environ["WM_PROJECT_DIR"], *FEW)
    lines = output.splitlines()
    with figures("tests/compatibility, installed release") as f:
        f.equal("exit code", code, 0)
        f.equal("files ok", sum(line == f"ok      {file}" for line in lines
                                for file in FEW), len(FEW))
        f.equal("count", lines[-1].split(": ")[1], "3 files, 3 ok, 0 FAILED")


def test_failures_show():
    """A file that does not compile is an error, and the reason is shown."""
    code, output = compatibility(os.environ["WM_PROJECT_DIR"], FEW[1],
                                 CXX="false")
    assert code == 1
    assert f"FAILED  {FEW[1]}" in output
    assert "1 files, 0 ok, 1 FAILED" in output


@pytest.mark.parametrize("arguments, reason", (
    ((), "which OpenFOAM?"), (("/nowhere",), "no src/OpenFOAM"),
    (("-jobs", "none"), "-jobs needs a number"),
    ((os.environ.get("WM_PROJECT_DIR", "."), "src/none.C"),
     "'src/none.C' is in no Make/files")))
def test_wrong_arguments(arguments, reason):
    code, output = compatibility(*arguments)
    assert code == 2
    assert reason in output


# tests/compatibility -run

@pytest.mark.parametrize("arguments, reason", (
    ((), "which release?"),
    (("v1906",), "v1906 is older than v1912"),
    (("/nowhere",), "neither a release such as v2506 nor a folder"),
    (("-jobs", "none", "v2506"), "-jobs needs a number"),
    (("v2306", "v2506"), "one release at a time"),
    (("-fast", "v2506"), "unknown argument '-fast'"),
    (("-from",), "-from needs an address or a folder"),
    (("-from", "/nowhere", os.environ.get("WM_PROJECT_DIR", ".")),
     "-from is for a release")))
def test_wrong_arguments_of_run(arguments, reason):
    code, output = compatibility("-run", *arguments)
    assert code == 2
    assert reason in output


# tests/compatibility -root: what it refuses before it checks for root and the
# tools

@pytest.mark.parametrize("arguments, reason", (
    ((), "which distribution?"),
    (("debian:11",), "none of debian:12, debian:13, ubuntu:22.04"),
    (("debian:12", "debian:13"), "one distribution at a time"),
    (("-jobs", "0", "debian:13"), "-jobs needs a number"),
    (("-mirror",), "-mirror needs an address"),
    (("-compiler", "icpx", "debian:13"), "-compiler needs a name such as"),
    (("-fast", "debian:13"), "unknown argument '-fast'")))
def test_wrong_arguments_of_root(arguments, reason):
    code, output = compatibility("-root", *arguments)
    assert code == 2
    assert reason in output


def test_run_without_setup(tmp_path):
    code, output = compatibility("-run", "v2506",
                                 VERTEXCONTACT_CACHE=str(tmp_path))
    assert code == 2
    assert "run etc/setup first" in output
    assert list(tmp_path.iterdir()) == []


def test_run_without_the_release(tmp_path):
    """The script prints its requirements before it fails because the release
    is missing."""
    cache = tmp_path/"cache"
    cache.mkdir()
    (cache/"environment").write_text("VC_OPENFOAM='/nowhere'\n")
    checked(["git", "init", "-q", "--bare", "empty"], tmp_path)
    code, output = compatibility(
        "-run", "-from", tmp_path/"empty", "v2506",
        VERTEXCONTACT_CACHE=str(cache))
    assert code == 2
    assert re.search(r"about \d+ minutes", output)
    assert re.search(r"\d GB in\n", output)
    assert "no tag OpenFOAM-v2506" in output


def fakeRelease(folder, api):
    """Folders of a release that contain nothing that compiles."""
    for name in ("src/OpenFOAM/a", "applications/utilities/a", "wmake/a",
                 "etc/a", "bin/a"):
        (folder/name).parent.mkdir(parents=True)
        (folder/name).write_text("")
    (folder/"META-INFO").mkdir()
    (folder/"META-INFO/api-info").write_text(f"api={api}\npatch=0\n")
    return folder


@pytest.mark.parametrize("api, reason", (
    ("2506", "no source tree of OpenFOAM in"), ("2412", "is not v2506 but v2412")))
@pytest.mark.parametrize("way", ("folder", "address"))
def test_run_of_a_fake_release(tmp_path, api, reason, way):
    """A tag is fetched from a folder or an address. Its sources are unpacked
    in the cache and checked."""
    cache = tmp_path/"cache"
    cache.mkdir()
    (cache/"environment").write_text("VC_OPENFOAM='/nowhere'\n")
    release = fakeRelease(tmp_path/"release", api)
    for command in (["init", "-q"], ["add", "-A"],
                    ["-c", "user.name=a", "-c", "user.email=a@b", "commit",
                     "-q", "-m", "a"], ["tag", "OpenFOAM-v2506"]):
        checked(["git", *command], release)
    code, output = compatibility(
        "-run", "-from", release if way == "folder" else release.as_uri(),
        "v2506", VERTEXCONTACT_CACHE=str(cache))
    assert code != 0
    assert reason in output
    unpacked = cache/"compatibility/v2506/OpenFOAM"
    assert f"api={api}\n" in (unpacked/"META-INFO/api-info").read_text()


def test_run_of_a_fake_folder(tmp_path):
    """Sources that are not compiled yet are copied; the originals stay
    unchanged."""
    cache = tmp_path/"cache"
    cache.mkdir()
    (cache/"environment").write_text("VC_OPENFOAM='/nowhere'\n")
    release = fakeRelease(tmp_path/"release", "2506")
    before = sorted(release.rglob("*"))
    code, output = compatibility("-run", release,
                                 VERTEXCONTACT_CACHE=str(cache))
    assert code != 0
    assert "no source tree of OpenFOAM in" in output
    copied, = cache.glob("compatibility/v2506-*/OpenFOAM/src/OpenFOAM/a")
    assert copied.is_file()
    assert sorted(release.rglob("*")) == before


def sceneResults():
    return {"energies": {"Time": [0, 0.1, 0.2], "total:kinetic": [8, 6, 5],
                         "total:strain": [0, 2, 2.5]},
            "norms": {"bar pointD": [2, -1], "bar contactGap": [1e-9, 0]}}


def test_comparison_of_releases():
    """Differences are relative to the largest energy and to the norm of the
    field (for a gap, to the norm of the displacements). Differences that are
    too large fail."""
    ours, theirs = sceneResults(), sceneResults()
    assert checkRelease.compareScene(ours, theirs) == (0, 0)
    ours["energies"]["total:strain"][1] += 8e-12
    ours["norms"]["bar pointD"][1] += 4e-12
    ours["norms"]["bar contactGap"][0] += 2e-12
    pair = checkRelease.compareScene(ours, theirs)
    assert pair == pytest.approx((1e-12, 2e-12), rel=1e-3)
    assert checkRelease.verdict(*pair) == "energies 1.0e-12, fields 2.0e-12"
    for bad in (2e-10, 0), (0, 2e-10), (float("nan"), 0), (0, float("nan")):
        with pytest.raises(checkRelease.Failed):
            checkRelease.verdict(*bad)


@pytest.mark.parametrize("spoil, reason", (
    (lambda x: [row.pop() for row in x["energies"].values()], "2 steps, not 3"),
    (lambda x: x["energies"].pop("total:strain"), "other energies"),
    (lambda x: x["norms"].pop("bar pointD"), "other fields")))
def test_what_cannot_be_compared(spoil, reason):
    theirs = sceneResults()
    ours = copy.deepcopy(theirs)
    spoil(ours)
    with pytest.raises(checkRelease.Failed, match=reason):
        checkRelease.compareScene(ours, theirs)
