"""The README and the pages for users. The commands of the tour run as they are
written. Links, programs and options exist. The pages of keywords and presets
equal the output of the solver. The costs of the presets equal the measured
ones."""

import os
import re

import pytest

from vertexContactTests.caseTools import checked, copyTutorials, root
from vertexContactTests.fieldReferences import TUTORIALS
from vertexContactTests.trade.cases import CASES
from vertexContactTests.trade.rows import tradeTable

README = (root/"README.md").read_text()
TOUR = re.findall(r"(?ms)^```sh\n(.*?)^```$", README)
REFERENCE = root/"tutorials"/"reference"
PAGES = [root/"README.md", root/"tutorials"/"README.md",
         root/"tests"/"README.md", root/"tutorials"/"gallery.md",
         *sorted(REFERENCE.glob("*.md"))]
TEXT = {page: page.read_text() for page in PAGES}
ALL = "\n".join(TEXT.values())


def test_tour(tmp_path):
    """The set-up and the compilation are done already."""
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


def anchors(page):
    """The anchors of the titles of a page, as GitHub makes them."""
    titles = re.findall(r"(?m)^#+ (.*)$", re.sub(
        r"(?ms)^```.*?^```$", "", page.read_text()))
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
            for title in titles}


@pytest.mark.parametrize(
    "page", PAGES, ids=lambda page: str(page.relative_to(root)))
def test_links(page):
    """Files and titles to which a page links exist."""
    links = {"".join(link) for link in re.findall(
        r"\]\(([^)\s]+)\)|src=\"([^\"]+)\"", TEXT[page])}
    missing = []
    for link in links:
        name, _, title = link.partition("#")
        target = page.parent/name if name else page
        if not (link.startswith("http") or target.exists()
                and (not title or title in anchors(target))):
            missing.append(link)
    assert missing == []


def test_readme_leads_to_each_page():
    for page in PAGES[1:]:
        assert f"({page.relative_to(root)}" in README


def test_readme_is_short():
    """The README has a screen and a half for newcomers; everything else has
    its own page."""
    assert len(README.splitlines()) <= 120


def test_programs():
    """Indented commands, and commands in backquotes, name files that exist."""
    named = set(re.findall(r"(?m)^    ((?:tutorials|tests|etc)/[\w/]+)", ALL))
    named |= set(re.findall(
        r"`((?:tutorials|tests|etc|src|applications)/[\w./]+)", ALL))
    assert len(named) > 8
    missing = [name for name in named if not (root/name).exists()]
    assert not missing
    for name in "tests/Alltest", "tutorials/twoBarImpact/similar/Allrun":
        assert os.access(root/name, os.X_OK)


def test_options(tmp_path):
    """Options of the solver that the pages name exist."""
    known = checked(["vertexContactFoam", "-help"], tmp_path)
    named = {option for option in re.findall(
        r"`(?:vertexContactFoam )?(-[a-z]\w+)`", ALL)
        if option.startswith(("-list", "-dry"))}
    assert len(named) >= 9
    assert [option for option in named if option not in known] == []


# The pages of reference

def test_keywords(tmp_path):
    """The page equals the output of the solver. If it does not, run
    writeKeywords.py."""
    checked([str(REFERENCE/"writeKeywords.py"), "keywords.md"], tmp_path)
    assert ((tmp_path/"keywords.md").read_text()
            == TEXT[REFERENCE/"keywords.md"])


def rows(text):
    """Rows of the tables in a text, without the lines below their heads."""
    return [[cell.strip(" `") for cell in line.strip("|").split("|")]
            for line in text.splitlines()
            if line.startswith("|") and not line.startswith("|---")]


def test_presets(tmp_path):
    """The table has all options of each preset as -listPresets prints them."""
    printed = checked(["vertexContactFoam", "-listPresets"], tmp_path)
    lines = printed.split("the default is balanced\n\n", 1)[1].splitlines()
    expected = [re.split(r" {2,}", line.strip()) for line in lines if line]
    head = ["keyword", *expected[0]]
    table = rows(TEXT[REFERENCE/"options.md"])
    first = table.index(head)
    assert table[first:first + len(expected)] == [head, *expected[1:]]


def test_what_presets_cost():
    """Errors and costs of the presets equal those of the trade, to two
    digits."""
    table = rows(TEXT[REFERENCE/"accuracy.md"].split("## Which preset\n")[1])
    measured = {(row["case"], row["label"]): row
                for row in tradeTable().rows.values()}
    for case, row in zip(CASES.values(), table[1:]):
        runs = [measured[case.name, preset]
                for preset in ("fast", "balanced", "accurate", "paper")]
        assert row[:5] == [case.title, *(
            f"{100*float(run['error']):.2g} %, "
            f"{float(run['cost'])/float(runs[1]['cost']):.2g}"
            for run in runs)]


def test_gallery():
    """Each tutorial has a row with picture, page, and figures."""
    table = rows(TEXT[root/"tutorials"/"gallery.md"])[1:]
    assert all(len(row) == 4 and all(row) for row in table)
    named = [re.search(r"\]\(([^)]+)/README\.md\)$", row[0])[1]
             for row in table]
    assert len(named) == len(set(named))
    assert {path for path, *_ in TUTORIALS} <= set(named)
    assert set(named) == {
        str(page.parent.relative_to(root/"tutorials"))
        for page in (root/"tutorials").rglob("*/README.md")}
    for name, row in zip(named, table):
        assert f'src="{name}/picture.png"' in row[0]


def test_example_of_a_test(tmp_path, figures):
    """The example of a test in tests/README.md passes."""
    (block,) = re.findall(r"(?ms)^```python\n(.*?)^```$",
                          TEXT[root/"tests"/"README.md"])
    names = {}
    exec(block, names)
    (test,) = [name for name in names if name.startswith("test_")]
    names[test](tmp_path, figures)
