"""Fixtures of all tests: simulations run once, and measured figures that are
printed at the end, whether the test passes or not."""

import shutil

import pytest

import searchPath     # first: it has the folders of what is imported below

import caseTools

_figures = []


class Figures:
    """Measured figures of an acceptance item, each with its limit. All are
    recorded before the first that is out of bounds fails the test."""

    def __init__(self, item):
        self.item = item
        self.bad = []

    def __enter__(self):
        return self

    def __exit__(self, kind, value, traceback):
        if kind is None and self.bad:
            pytest.fail("\n".join(self.bad), pytrace=False)

    def _record(self, what, value, limit, good):
        text = value if isinstance(value, str) else f"{value:.6g}"
        _figures.append((self.item, what, text, limit, bool(good)))
        if not good:
            self.bad.append(f"{what}: {text}, but should be {limit}")

    def atMost(self, what, value, limit):
        self._record(what, value, f"<= {limit:g}", value <= limit)

    def atLeast(self, what, value, limit):
        self._record(what, value, f">= {limit:g}", value >= limit)

    def within(self, what, value, expected, tolerance):
        self._record(what, value, f"{expected:g} +- {tolerance:g}",
                     abs(value - expected) <= tolerance)

    def falling(self, what, values):
        self._record(what, " > ".join(f"{v:.4g}" for v in values), "falling",
                     all(a > b for a, b in zip(values, values[1:])))

    def equal(self, what, value, expected):
        self._record(what, str(value), str(expected), value == expected)


@pytest.fixture
def figures():
    return Figures


def pytest_terminal_summary(terminalreporter):
    if not _figures:
        return
    rows = [("item", "figure", "measured", "limit", "")]
    rows += [(*row[:4], "" if row[4] else "FAILED") for row in _figures]
    widths = [max(len(row[i]) for row in rows) for i in range(5)]
    terminalreporter.section("measured figures")
    for row in rows:
        terminalreporter.write_line("  ".join(
            cell.ljust(width) for cell, width in zip(row, widths)).rstrip())


@pytest.fixture(scope="session", autouse=True)
def environment():
    for program in "vertexContactFoam", "blockMesh", "decomposePar":
        if shutil.which(program) is None:
            pytest.exit(f"no {program} on PATH: run etc/setup, source "
                        "etc/bashrc and run Allwmake first", returncode=2)
    # Once for all, not by several Allruns at the same time
    caseTools.checked([str(caseTools.root/"Allwmake"), "-j", "-s"],
                      caseTools.root)


@pytest.fixture(scope="session")
def run(request, tmp_path_factory):
    """run(scene): the finished case of a caseTools.Scene. Each is run once;
    those that the selected tests announce in their mark 'scenes' are started
    at once, on all cores."""
    with caseTools.Runs(tmp_path_factory.mktemp("cases")) as runs:
        for item in request.session.items:
            for mark in item.iter_markers("scenes"):
                for scene in mark.args:
                    runs.start(scene)
        yield runs.result
