#!/usr/bin/env python3
"""Run what a release of OpenFOAM has to be able to do, in its environment, and
compare the results with those of another release.

    tests/vertexContactTests/checkRelease.py FOLDER [REFERENCE]

is called by tests/compatibility -run, in an environment with the project built.
Cases are run in FOLDER, and results left in FOLDER/results.json. REFERENCE is
such a file of the other release; without it, to make one, only the tutorials are
run. One line a check, 'ok' or 'FAILED', and at the end a row of the table in
tutorials/reference/releases.md. The exit code is 0 only if all are ok.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import traceback
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

root = Path(__file__).resolve().parents[2]

LIMIT = 1e-10       # of energies and of fields, against the other release
COLUMNS = ("compiled", "linked", "unit tests", "tutorials", "restart",
           "parallel", "tools")
SUITES = {"restart": ("tests/regression/test_restart.py",),
          "parallel": ("tests/regression/test_parallel.py",),
          "tools": ("tests/robustness/test_command_line.py",
                    "tests/verification/test_check_contact.py",
                    "tests/verification/test_plugin.py")}


class Failed(Exception):
    pass


# Comparison with another release

def compareScene(ours, theirs):
    """The largest differences of a scene's energies, relative to its largest
    energy, and of its fields, relative to their norms."""
    a, b = ours["energies"], theirs["energies"]
    if a.keys() != b.keys():
        raise Failed(f"other energies: {sorted(a.keys() ^ b.keys())}")
    if len(a["Time"]) != len(b["Time"]):
        raise Failed(f"{len(a['Time'])} steps, not {len(b['Time'])}")
    scale = max(np.abs(values).max() for key, values in b.items()
                if key != "Time")
    energy = np.max([np.abs(np.subtract(a[key], b[key])).max()
                     / (b["Time"][-1] if key == "Time" else scale)
                     for key in b])
    a, b = ours["norms"], theirs["norms"]
    if a.keys() != b.keys():
        raise Failed(f"other fields: {sorted(a.keys() ^ b.keys())}")
    # A gap is a difference of positions
    field = np.max([np.abs(np.subtract(a[key], b[key])).max()
                    / max(b[key.replace("contactGap", "pointD")][0], 1e-12)
                    for key in b])
    return float(energy), float(field)


def verdict(energy, field):
    """Print a line with both differences. It is an error if one is too large,
    or no number."""
    text = f"energies {energy:.1e}, fields {field:.1e}"
    if not (energy <= LIMIT and field <= LIMIT):
        raise Failed(f"{text}: more than {LIMIT:g}")
    return text


def row(release, cells, equal, note):
    """A row of the table in tutorials/reference/releases.md."""
    return f"| {release} | " + " | ".join(
        [*(cells.get(column, "not run") for column in COLUMNS), equal,
         note]) + " |"


# Checks

class Checks:
    """Run checks, print a line for each, and keep the failed ones."""

    def __init__(self):
        self.failed = []

    def __call__(self, name, function, *arguments):
        try:
            text = function(*arguments)
        except Failed as reason:
            self.failed.append(name)
            print(f"FAILED  {name}: {reason}", flush=True)
            return None
        except Exception as error:
            self.failed.append(name)
            print(f"FAILED  {name}: {type(error).__name__}: {error}",
                  flush=True)
            traceback.print_exc(file=sys.stderr)
            return None
        print(f"ok      {name}: {text}", flush=True)
        return text


def output(command, folder, **environment):
    from vertexContactTests.caseTools import execute
    done = execute(command, folder, **environment)
    if done.returncode != 0:
        raise Failed(f"{' '.join(map(str, command))}: exit code "
                     f"{done.returncode}: {done.stdout.strip()[-400:]}")
    return done.stdout


def linked():
    """The programs and the library find all their libraries, and OpenFOAM's
    libraries in the right release."""
    release = Path(os.environ["FOAM_LIBBIN"]).resolve()
    here = Path(os.environ["FOAM_USER_LIBBIN"]).resolve()
    products = [here/"libvertexContact.so",
                *sorted(Path(os.environ["FOAM_USER_APPBIN"]).iterdir())]
    count = set()
    for product in products:
        text = output(["ldd", product], root)
        if "not found" in text:
            raise Failed(f"{product.name}: {text}")
        libraries = dict(re.findall(r"(?m)^\s*(\S+) => (\S+)", text))
        if "libOpenFOAM.so" not in libraries:
            raise Failed(f"{product.name} is not linked with libOpenFOAM")
        for name, path in libraries.items():
            if not (release/name).exists() and not list(
                    release.glob(f"*/{name}")):
                continue
            if not Path(os.path.abspath(path)).is_relative_to(release):
                raise Failed(f"{product.name} takes {path}")
            count.add(name)
    return f"{len(products)} products, {len(count)} libraries of OpenFOAM"


def unitTests(ranks):
    command = ["vertexContactUnitTests"]
    if ranks > 1:
        command = ["mpirun", "-np", str(ranks), *command, "-parallel"]
    # In colours under mpirun
    text = re.sub(r"\x1b\[[0-9;]*m", "", output(command, root))
    found = re.findall(r"All tests passed \((\d+) assertions? in (\d+) "
                       r"test cases?\)", text)
    if not found:
        raise Failed(f"no count in {text[-400:]}")
    return f"{found[-1][1]} tests, {found[-1][0]} assertions"


def suite(folder, files):
    """Run tests of the project unchanged; none may be skipped."""
    report = folder/"report.xml"
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider",
         f"--junitxml={report}", f"--basetemp={folder/'tests'}", *files],
        cwd=root, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True)
    if not report.exists():
        raise Failed(f"pytest ended without a report: {done.stdout[-400:]}")
    cases = list(ElementTree.parse(report).iter("testcase"))
    bad = [case.get("name") for case in cases for kind in
           ("failure", "error", "skipped") if case.find(kind) is not None]
    if bad or not cases or done.returncode != 0:
        log = folder/f"log.{Path(files[0]).stem}"
        log.write_text(done.stdout)
        raise Failed(f"{len(bad)} of {len(cases)} tests ({', '.join(bad)}), "
                     f"see {log}")
    shutil.rmtree(folder/"tests")
    return f"{len(cases)} tests"


def results(case):
    """Energies by time, and norms of fields at the end."""
    from vertexContactTests.fieldReferences import norms
    return {"energies": {key: values.tolist()
                         for key, values in case.energies.items()
                         if key == "Time" or key.startswith("total:")},
            "norms": norms(case)}


def tools(case):
    """OpenFOAM's tools work on a finished case of ours."""
    import pyvista
    region = case.regions[0]
    value = output(["foamDictionary", "-entry", "endTime", "-value",
                    "system/controlDict"], case.path).strip()
    if float(value) != float(case.energies["Time"][-1]):
        raise Failed(f"foamDictionary: endTime {value}")
    if "Mesh OK" not in output(["checkMesh", "-region", region], case.path):
        raise Failed("checkMesh: no 'Mesh OK'")
    output(["foamToVTK", "-region", region, "-latestTime"], case.path)
    grids = [pyvista.read(file) for file in (case/"VTK").rglob("internal.vtu")]
    found = [grid["pointD"] for grid in grids if "pointD" in grid.point_data]
    if len(found) != 1:
        raise Failed(f"foamToVTK: {len(found)} internal.vtu with pointD")
    ours = case.field(case.times[-1], region, "pointD")
    error = np.abs(found[0] - ours).max()/np.abs(ours).max()
    if not error < 1e-6:
        raise Failed(f"foamToVTK: pointD differs by {error:.1e}")
    return f"foamDictionary, checkMesh, foamToVTK (pointD to {error:.0e})"


def main(folder, reference=None):
    from vertexContactTests.caseTools import Runs
    from vertexContactTests.fieldReferences import REFERENCES

    folder = Path(folder).resolve()
    release = os.environ["WM_PROJECT_VERSION"]
    theirs = json.loads(Path(reference).read_text()) if reference else None
    cases = folder/"cases"
    shutil.rmtree(cases, ignore_errors=True)
    cases.mkdir(parents=True)

    check = Checks()
    cells = {"compiled": "ok"}
    if theirs:
        cells["linked"] = "ok" if check("linked", linked) else "FAILED"
        counts = [check(f"unit tests, {ranks} rank{'s'*(ranks > 1)}",
                        unitTests, ranks) for ranks in (1, 2)]
        cells["unit tests"] = (counts[0].split(",")[0] if all(counts)
                               else "FAILED")

    scenes = {}
    worst = [0, 0]
    unequal = []
    with Runs(cases) as runs:
        finished = None
        for name, scene in REFERENCES.items():
            runs.start(scene)
        for name, scene in REFERENCES.items():
            def ran():
                case = runs.result(scene)
                scenes[name] = results(case)
                return f"{len(case.energies['Time'])} rows of energies"
            if not check(f"tutorial {name}", ran):
                continue
            finished = finished or runs.result(scene)
            if theirs:
                def equal():
                    pair = compareScene(scenes[name], theirs["scenes"][name])
                    text = verdict(*pair)
                    worst[:] = map(max, worst, pair)
                    return text
                if not check(f"equal {name}", equal):
                    unequal.append(name)
        cells["tutorials"] = f"{len(scenes)} of {len(REFERENCES)}"
        if theirs:
            for name, files in SUITES.items():
                cells[name] = check(name, suite, folder, files) or "FAILED"
            if not check("tools of OpenFOAM", tools, finished):
                cells["tools"] = "FAILED"

    if unequal or len(scenes) < len(REFERENCES):
        equal = f"FAILED ({len(unequal)} of {len(REFERENCES)})"
    else:
        equal = f"{worst[0]:.0e}, {worst[1]:.0e}"
    if check.failed:
        print(f"{release}: {len(check.failed)} FAILED: "
              f"{', '.join(check.failed)}")
    else:
        shutil.rmtree(cases)
        print(f"{release}: all checks ok")
    (folder/"results.json").write_text(json.dumps(
        {"release": release, "failed": check.failed, "scenes": scenes}))
    if theirs:
        print(row(release, cells, equal,
                  os.environ.get("VC_RELEASE_NOTE", "-")))
    return 1 if check.failed else 0


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3) or sys.argv[1].startswith("-"):
        print(__doc__.strip())
        sys.exit(0 if sys.argv[1:2] in (["-h"], ["--help"]) else 2)
    sys.exit(main(*sys.argv[1:]))
