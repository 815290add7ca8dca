"""The README: its tour runs as it stands, its programs and pages exist, and
the pictures are those that a command of the repository makes."""

import os
import re

import pytest

from caseTools import checked, copyTutorials, root

README = (root/"README.md").read_text()
TOUR = re.findall(r"(?ms)^```sh\n(.*?)^```$", README)


def test_tour(tmp_path):
    """Of the set-up and the compilation there is nothing left to do."""
    copy = copyTutorials(tmp_path/"tutorials")
    first, *rest = TOUR
    assert "etc/setup" in first and "Allwmake" in first and len(rest) >= 2
    commands = "".join(rest)
    assert commands.count("cd tutorials/") == 1
    commands = commands.replace("cd tutorials/", f"cd {copy}/")
    output = checked(
        ["bash", "-c", f"set -eo pipefail\ncd {root}\n{first}\n{commands}"],
        tmp_path, OMPI_MCA_mpi_yield_when_idle="1")
    case = copy/re.search(r"cd tutorials/(\S+)", README)[1]
    for text in "Dry run: nothing is written", "frictionCoeff":
        assert text in output
    for picture in "deformation.png", "rings.png":
        assert (case/picture).stat().st_size > 5000
    assert (case/"case.foam").exists()


@pytest.mark.parametrize("link", sorted(set(
    re.findall(r"\]\(([^)#]+)\)|src=\"([^\"]+)\"", README))))
def test_links(link):
    name = "".join(link)
    assert name.startswith("http") or (root/name).exists()


def test_programs():
    """Indented commands, and those between backquotes, name files that there
    are."""
    named = set(re.findall(r"(?m)^    ((?:tutorials|tests|etc)/[\w/]+)",
                           README))
    named |= set(re.findall(
        r"`((?:tutorials|tests|etc|src|applications)/[\w./]+)", README))
    assert len(named) > 8
    missing = [name for name in named if not (root/name).exists()]
    assert not missing
    for name in "tests/Alltest", "tutorials/twoBarImpact/similar/Allrun":
        assert os.access(root/name, os.X_OK)


def test_options(tmp_path):
    """Options of the solver that the README names are those it has."""
    known = checked(["vertexContactFoam", "-help"], tmp_path)
    for option in set(re.findall(r"`(?:vertexContactFoam )?(-[a-z]\w+)`",
                                 README)) - {"-quick", "-sanitize"}:
        if option.startswith(("-list", "-dry")):
            assert option in known, option
