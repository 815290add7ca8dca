"""Fixtures of all tests. Simulations run once; measured figures are printed at
the end, whether the test passes or not."""

import functools
import os
import shutil

import pytest

from vertexContactTests import caseTools, slowTests


class Figures:
    """Measured figures of a test, each with its limit. All are recorded before
    the first one that is out of bounds fails the test."""

    def __init__(self, properties, item):
        self.properties = properties    # of the test, for its report
        self.item = item
        self.bad = []

    def __enter__(self):
        return self

    def __exit__(self, kind, value, traceback):
        if kind is None and self.bad:
            pytest.fail("\n".join(self.bad), pytrace=False)

    def _record(self, what, value, limit, good):
        text = value if isinstance(value, str) else f"{value:.6g}"
        self.properties.append(
            ("figure", (self.item, what, text, limit, bool(good))))
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
def figures(request):
    return functools.partial(Figures, request.node.user_properties)


def pytest_terminal_summary(terminalreporter):
    figures = [
        value for reports in terminalreporter.stats.values()
        for report in reports if getattr(report, "when", None) == "call"
        for name, value in report.user_properties if name == "figure"]
    if not figures:
        return
    rows = [("item", "figure", "measured", "limit", "")]
    rows += [(*row[:4], "" if row[4] else "FAILED") for row in figures]
    widths = [max(len(row[i]) for row in rows) for i in range(5)]
    terminalreporter.section("measured figures")
    for row in rows:
        terminalreporter.write_line("  ".join(
            cell.ljust(width) for cell, width in zip(row, widths)).rstrip())


@pytest.hookimpl(tryfirst=True)     # before -m selects tests
def pytest_collection_modifyitems(items):
    slow = slowTests.names()
    for item in items:
        file = item.path.relative_to(caseTools.root/"tests")
        if f"{file}::{item.originalname}" in slow:
            item.add_marker("slow")


def workers():
    """Number of processes that share the tests (pytest -n); 1 without -n."""
    return int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", 1))


def pytest_sessionstart(session):
    if hasattr(session.config, "workerinput"):
        return      # set by the process that starts the workers
    for program in "vertexContactFoam", "blockMesh", "decomposePar":
        if shutil.which(program) is None:
            pytest.exit(f"no {program} on PATH: run etc/setup, source "
                        "etc/bashrc and run Allwmake first", returncode=2)
    # Compile once for all, so that not several Allruns do it at the same time
    caseTools.checked([str(caseTools.root/"Allwmake"), "-j", "-s"],
                      caseTools.root)


@pytest.fixture(scope="session")
def runs(tmp_path_factory):
    """Scenes that run once; all workers share them."""
    folder = tmp_path_factory.getbasetemp()
    if workers() > 1:
        folder = folder.parent
    cores = len(os.sched_getaffinity(0))
    with caseTools.Runs(folder/"scenes",
                        max(1, cores//workers())) as runs:
        yield runs


@pytest.fixture(scope="session")
def run(runs):
    """run(scene) returns the finished case of a caseTools.Scene."""
    return runs.result


@pytest.fixture(scope="module", autouse=True)
def scenes(request):
    """Starts the scenes that the tests of a module list in their mark
    'scenes', on all cores."""
    wanted = [scene for item in request.session.items
              if item.path == request.path
              for mark in item.iter_markers("scenes") for scene in mark.args]
    if wanted:
        runs = request.getfixturevalue("runs")
        for scene in wanted:
            runs.start(scene)
