"""Style of the files of the repository: scripts, C++ sources, lists of files,
and the names in the map of the source."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from vertexContactTests import slowTests
from vertexContactTests.caseTools import execute, root

SOURCE = root/"src"/"vertexContact"
HEAD = "/*" + 75*"-" + """*\\
    vertexContact: explicit large-strain contact dynamics in OpenFOAM
    Copyright (C) 2026 vertexContact developers
    SPDX-License-Identifier: GPL-3.0-or-later
"""


def tracked():
    """Files of the repository. In a copy without git: the files that no
    program generates."""
    done = subprocess.run(["git", "ls-files", "-z", "--cached", "--others",
                           "--exclude-standard"], cwd=root,
                          capture_output=True, text=True)
    if done.returncode == 0:
        names = done.stdout.split("\0")[:-1]
    else:
        made = r"(^|/)(\.build|lnInclude|__pycache__|linux[^/]*)/"
        names = [str(path.relative_to(root)) for path in root.rglob("*")]
        names = [name for name in names if not re.search(made, name)]
    return [root/name for name in sorted(names) if (root/name).is_file()]


FILES = tracked()
SOURCES = [file for file in FILES if file.suffix in (".C", ".H")]


def short(file):
    return str(file.relative_to(root))


def where(files, bad):
    """file:line of the bad lines."""
    return [f"{short(file)}:{i}" for file in files
            for i, line in enumerate(file.read_text().split("\n"), 1)
            if bad(line)]


# Scripts

def isScript(file, interpreter=rb"(ba)?sh"):
    with open(file, "rb") as stream:
        start = stream.read(4000)
    return (re.match(rb"#! *\S*/(env )?" + interpreter + rb"\b", start)
            or re.search(rb"(?m)^# shellcheck shell=", start))


def test_shellcheck():
    if shutil.which("shellcheck") is None:
        pytest.skip("no shellcheck; etc/setup installs it")
    scripts = [short(file) for file in FILES
               if file.suffix != ".py" and isScript(file)]
    assert len(scripts) > 25
    done = execute(["shellcheck", *scripts], root)
    assert done.returncode == 0, done.stdout


# Text

def test_white_space():
    text = [file for file in FILES
            if b"\0" not in file.read_bytes() and file.stat().st_size]
    assert where(text, lambda line: line != line.rstrip()) == []
    assert where([file for file in text if file.suffix in (
        ".C", ".H", ".py", ".md", ".geo")], lambda line: "\t" in line) == []
    assert [short(file) for file in text
            if not file.read_text().endswith("\n")] == []


def test_columns():
    assert where(SOURCES, lambda line: len(line) > 80) == []


# Headers of files

def test_licence():
    assert [short(file) for file in SOURCES
            if not file.read_text().startswith(HEAD)] == []


def test_description():
    """A header says what it is for, and where its sources are."""
    bad = []
    for file in SOURCES:
        if file.suffix == ".H":
            block = file.read_text().split("\\*---", 1)[0]
            if not re.search(r"(?m)^Description\n {4}\S", block):
                bad.append(f"{short(file)}: no Description")
            own = file.with_suffix(".C")
            if (file.is_relative_to(SOURCE) and own.exists()
                    and own.name not in block):
                bad.append(f"{short(file)}: SourceFiles without {own.name}")
    assert bad == []


def test_include_guards():
    """The include guard of a header has its name, with the name of its family
    in front if necessary."""
    bad = []
    for file in SOURCES:
        if file.suffix == ".H" and file.is_relative_to(SOURCE):
            guard = re.search(r"(?m)^#ifndef (\w+)\n#define \1$",
                              file.read_text())
            if not guard or not guard[1].endswith(f"{file.stem}_H"):
                bad.append(short(file))
    assert bad == []


# Make/files

@pytest.mark.parametrize("files", [
    file for file in FILES if file.parts[-2:] == ("Make", "files")], ids=short)
def test_make_files(files):
    """Every source in the list exists, and every other source is included
    somewhere."""
    folder = files.parents[1]
    text = re.sub(r"/\*.*?\*/", "", files.read_text(), flags=re.S)
    listed = re.findall(r"(?m)^\s*(\S+\.C)\s*$", text)
    assert len(listed) == len(set(listed))
    own = {str(file.relative_to(folder)) for file in SOURCES
           if file.suffix == ".C" and file.is_relative_to(folder)}
    included = {name for file in SOURCES if file.is_relative_to(folder)
                for name in re.findall(
                    r'(?m)^#\s*include "(?:\w+/)*(\w+\.C)"',
                    file.read_text())}
    assert set(listed) - own == set()
    assert {name for name in own - set(listed)
            if Path(name).name not in included} == set()


# The map of the source

def table(title):
    """Rows of the table below a title of src/vertexContact/README.md, by
    column."""
    text = (SOURCE/"README.md").read_text()
    part = text.split(f"{title}\n", 1)[1].split("\n## ", 1)[0]
    rows = [[cell.strip() for cell in line.strip("|").split("|")]
            for line in part.splitlines() if line.startswith("|")]
    return rows[2:]


def quoted(cell):
    return re.findall(r"`([^`]+)`", cell)


def paths(token):
    """The files and folders that a token can mean, by path or by name."""
    for top in SOURCE, root, root/"tests"/"vertexContactTests":
        if (top/token).exists():
            return [top/token]
    if re.fullmatch(r"\w+\.[CH]", token):
        return [file for file in SOURCES if file.name == token
                and file.is_relative_to(SOURCE)]
    return []


def test_folders():
    named = [quoted(row[0])[0] for row in table("# libvertexContact")]
    there = {file.relative_to(SOURCE).parts[0] for file in FILES
             if file.is_relative_to(SOURCE) and file.parent != SOURCE}
    assert sorted(named) == sorted(there - {"Make"})


def circles(uses):
    """The names that lead back to themselves.

    uses  by name, the set of names that it uses
    """
    def reached(name):
        found, new = set(), {name}
        while new:
            new = set().union(*(uses.get(n, set()) for n in new)) - found
            found |= new
        return found
    return sorted(name for name in uses if name in reached(name))


def test_folders_use_each_other_one_way():
    """A folder never includes a folder that uses it. So each folder can be
    read after the folders that it uses."""
    sources = [file for file in SOURCES if file.is_relative_to(SOURCE)
               and file.parent != SOURCE]
    folder = {file.name: file.relative_to(SOURCE).parts[0] for file in sources}
    uses = {}
    for file in sources:
        own = folder[file.name]
        its = {folder.get(name, own) for name in re.findall(
            r'(?m)^ *#include "([^"]+)"', file.read_text())}
        uses.setdefault(own, set()).update(its - {own})
    assert len(uses) > 20 and "solidBody" in uses["contact"]
    assert circles({"a": {"b"}, "b": {"c"}, "c": {"b"}}) == ["b", "c"]
    assert circles(uses) == []


def test_equations():
    """Each file in the map exists, and each function is in one of the files of
    its row."""
    bad = []
    rows = table("## From the paper's equations to the source")
    for equations, cell in rows:
        text, functions = "", []
        for token in quoted(cell):
            found = paths(token)
            if len(found) == 1:
                text += "".join(
                    file.read_text() for file in SOURCES
                    if file == found[0] or found[0] in file.parents)
            elif re.search(r"[./]", token):
                bad.append(f"{equations}: '{token}' is {len(found)} files")
            else:
                functions += token.split()
        bad += [f"{equations}: no '{name}'" for name in functions
                if not re.search(rf"\b{name}\b", text)]
        if not text:
            bad.append(f"{equations}: no file")
    assert bad == []


# Constants with a point or an exponent; folders that are not part of the
# scheme
CONSTANT = re.compile(r"(?:constexpr|static const) (?:Foam::)?(?:scalar|double) "
                      r"(\w+) = [^;]*\d(?:\.\d|e-?\d)")
REPORTS = ("passTimes", "dryRun", "solidFunctionObject")


def test_numbers():
    """Each number of the scheme is in a line of its file, on the line of its
    name or below it. Each test that is named for it exists."""
    bad = []
    rows = [row for row in table("## Numbers of the scheme")
            if quoted(row[0])]
    assert len(rows) > 25
    for number, where, *text in rows:
        file, name = quoted(where)
        lines = (SOURCE/file).read_text().splitlines()
        near = (" ".join(lines[i:i + 18]) for i, line in enumerate(lines)
                if re.search(rf"\b{name}\b", line))
        if not any(quoted(number)[0] in text for text in near):
            bad.append(f"{name}: no {number} in {file}")
        for token in quoted(" ".join(text)):
            if token.startswith("test_") and not list(
                    (root/"tests").glob(f"*/{token}")):
                bad.append(f"{name}: no {token}")

    # Each constant of the source is in the tables, except those of REPORTS
    section = (SOURCE/"README.md").read_text().split(
        "## Numbers of the scheme\n", 1)[1].split("\n## ", 1)[0]
    bad += [f"{name} of {file.name} is not in the tables"
            for file in SOURCES if SOURCE in file.parents
            and file.parent.name not in REPORTS
            for name in CONSTANT.findall(file.read_text())
            if f"`{name}`" not in section]
    assert bad == []


def test_guide():
    """Everything that the guide 'To add' names exists, except the X to be
    added."""
    bad = []
    words = "\n".join(file.read_text() for file in FILES
                      if file.suffix in (".C", ".H", ".py"))
    text = (SOURCE/"README.md").read_text().split("## To add\n", 1)[1]
    # An X in a path stands for the new name; sources and folders are paths
    for token in quoted(text):
        path = re.match(r"[\w./]+", token)[0]
        if re.search(r"(^|[/_])X", path):
            continue
        if re.search(r"/|\.[CH]$", path) and not paths(path):
            bad.append(token)
        elif not re.search(rf"\b{path}\b", words) and not paths(path):
            bad.append(token)
    linked = re.findall(r"\]\(([^)]+)\)", text)
    bad += [link for link in linked if not (SOURCE/link).exists()]
    assert bad == []


# Python

def test_one_search_path():
    """Modules are found by PYTHONPATH, which etc/bashrc sets. No file changes
    the path, and tests import nothing from each other."""
    python = [file for file in FILES
              if file.suffix == ".py" or isScript(file, rb"python3")]
    assert len(python) > 100 and root/"tutorials"/"makePictures" in python
    assert where(python, lambda line: re.match(
        r"\s*(sys\.path\b|(from|import) test_)", line)) == []


def test_slow_tests_are_there():
    """The functions in slowTests.txt, which tests/Alltest -quick leaves out,
    exist."""
    for name in sorted(slowTests.names()):
        file, function = name.split("::")
        assert f"def {function}(" in (root/"tests"/file).read_text(), name
