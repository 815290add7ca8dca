"""The files in etc/ that describe the project, its authors and how to get it
are correct and agree with the README."""

import ast
import json
import re

from vertexContactTests.caseTools import root

ETC = root/"etc"
README = re.sub(r"\s+", " ", (root/"README.md").read_text())
CITATION = (ETC/"CITATION.cff").read_text()
RECIPE = (ETC/"spack/spack_repo/vertexcontact/packages/vertexcontact"
          / "package.py")


def test_citation():
    """The paper and its authors are the same as in the README."""
    article = CITATION.split("preferred-citation:\n", 1)[1]
    authors = re.findall(r"given-names: (.*)\n +family-names: (.*)\n", article)
    assert len(authors) == 5
    assert ", ".join(map(" ".join, authors)) in README
    title = re.search(r"title: >-\n +(.*)\n", article)[1]
    assert f"*{title}*" in README
    assert re.search(r"journal: (.*)\n", article)[1] in README
    year = re.search(r"year: (\d{4})\n", article)[1]
    assert f"{year}; and this repository" in README
    for line in CITATION.splitlines():
        assert re.match(r"( *(- )?[a-z-]+:( .*)?| {2,}\S.*|# .*)$", line), line


def test_codemeta():
    meta = json.loads((ETC/"codemeta.json").read_text())
    licence = meta["license"].rsplit("/", 1)[1]
    assert f"license: {licence}\n" in CITATION and licence in README
    assert meta["referencePublication"]["name"] in README
    assert meta["softwareRequirements"] == ["OpenFOAM (ESI) v1912 or newer"]
    assert "v1912 and newer" in README


def test_spack_recipe():
    """The recipe is valid Python, has the name that its folder requires, and
    finds this checkout."""
    recipe = ast.parse(RECIPE.read_text())
    assert [node.name for node in recipe.body
            if isinstance(node, ast.ClassDef)] == ["Vertexcontact"]
    depth = int(re.search(r"parents\[(\d+)\]", RECIPE.read_text())[1])
    assert RECIPE.resolve().parents[depth] == root


def test_container():
    """The scripts that the container runs exist, and it runs the first of the
    two commands of the README."""
    text = (ETC/"Containerfile").read_text()
    commands = re.findall(r"\b((?:etc|tutorials|tests)/[\w/]*\w)", text)
    assert "tutorials/twoBarImpact/similar/Allrun" in commands
    assert [name for name in commands if not (root/name).exists()] == []


def test_container_steps():
    """The steps of the container are those of tests/releases/cleanRoot, in the
    same order. All of these were run on its distribution."""
    container = (ETC/"Containerfile").read_text()
    steps = {"apt": "apt-get update", "setup": "etc/setup",
             "build": "./Allwmake -j", "units": "vertexContactUnitTests"}
    cleanRoot = (root/"tests/releases/cleanRoot").read_text()
    order = [name for name in re.findall(r"(?m)^step (\w+) ", cleanRoot)
             if name in steps]
    assert sorted(order) == sorted(steps)
    commands = "\n".join(line for line in container.splitlines()
                         if not line.startswith("#"))
    places = []
    for name in order:
        command = steps[name].removeprefix("./")
        assert command in cleanRoot
        assert commands.count(steps[name]) == 1, steps[name]
        places.append(commands.index(steps[name]))
    assert places == sorted(places)
    assert "LC_ALL=C.UTF-8" in cleanRoot and "LC_ALL=C.UTF-8" in commands

    base = re.search(r"(?m)^FROM (\S+)$", commands)[1]
    releases = (root/"tutorials/reference/releases.md").read_text()
    row = re.search(rf"(?m)^\| {re.escape(base)} \|.*", releases)[0]
    assert "not " not in row, row
