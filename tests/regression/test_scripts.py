"""The scripts for all tutorials, and the progress that Allrun shows."""

import os
import pty
import re
import shutil
import signal
import subprocess
import time

import pytest

from vertexContactTests.caseTools import (TUTORIALS, checked, copyTutorials,
                                          execute, root)

CASE = "twoBarImpact/similar"
SETTINGS = {"MESH": "32", "PLOT": "0"}


@pytest.fixture
def tutorials(tmp_path):
    return copyTutorials(tmp_path/"tutorials")


@pytest.fixture
def slowSolver(tmp_path):
    """PATH with a program instead of the solver. It takes four seconds, and
    then fails if FAILS is set."""
    folder = tmp_path/"bin"
    folder.mkdir()
    program = folder/"vertexContactFoam"
    program.write_text("""#!/bin/sh
for left in 4 3 2 1 0
do
    echo "Step 1$left  Time 0.1 s  contacts 0  left $left s"
    [ $left = 0 ] || sleep 1
done
[ -z "${FAILS:-}" ] || { echo "--> FOAM FATAL ERROR: no luck"; exit 3; }
""")
    program.chmod(0o755)
    return f"{folder}:{os.environ['PATH']}"


def percentages(output):
    return [int(n) for n in re.findall(r"(\d+) % done, \d+ s left", output)]


def test_progress_in_a_log(tutorials, slowSolver):
    case = tutorials/CASE
    output = checked(["./Allrun"], case, **SETTINGS, PATH=slowSolver)
    shares = percentages(output)
    assert 1 <= len(shares) <= 9 and shares == sorted(set(shares))
    assert "\r" not in output
    log = (case/"log.vertexContactFoam").read_text()
    assert len(log.splitlines()) == 5 and "done" not in log


def test_progress_on_a_terminal(tutorials, slowSolver):
    ours, theirs = pty.openpty()
    with subprocess.Popen(
            ["./Allrun"], cwd=tutorials/CASE, stdin=subprocess.DEVNULL,
            stdout=theirs, stderr=theirs,
            env={**os.environ, **SETTINGS, "PATH": slowSolver}) as process:
        os.close(theirs)
        output = b""
        try:
            while chunk := os.read(ours, 4096):
                output += chunk
        except OSError:
            pass        # the end of the command line, on Linux
        process.wait()
    os.close(ours)
    output = output.decode()
    assert process.returncode == 0
    assert percentages(output) and "\r" in output
    # No process of it is left
    assert output.endswith("\r\033[K")


def test_failure_with_progress(tutorials, slowSolver):
    done = execute(["./Allrun"], tutorials/CASE, **SETTINGS, PATH=slowSolver,
                   FAILS="1")
    assert done.returncode == 1
    assert "FAILED: vertexContactFoam (exit code 3)" in done.stdout
    assert "FOAM FATAL ERROR: no luck" in done.stdout
    assert "done" not in done.stdout[done.stdout.index("FAILED"):]


@pytest.mark.parametrize("number", (signal.SIGINT, signal.SIGKILL))
def test_interrupted(tutorials, slowSolver, number):
    """No process continues and keeps the output open, even if the tests were
    started with SIGINT ignored, as by '&' in a shell."""
    with subprocess.Popen(
            ["./Allrun"], cwd=tutorials/CASE, start_new_session=True,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            env={**os.environ, **SETTINGS, "PATH": slowSolver}) as process:
        while not (tutorials/CASE/"log.vertexContactFoam").exists():
            time.sleep(0.1)
        if number == signal.SIGINT:
            os.killpg(process.pid, number)
        else:
            process.kill()
        process.communicate(timeout=60)
    assert process.returncode != 0


def test_allrun(tutorials):
    names = "spinningCube", "twistingColumn"
    output = checked([str(tutorials/"Allrun"), *names], tutorials.parent,
                     MESH="2", PLOT="0")
    table = [line.split() for line in output.splitlines()[-2:]]
    assert [row[0] for row in table] == list(names)
    assert all(row[2:] == ["s", "ok"] for row in table)
    checked([str(tutorials/"Allclean")], tutorials.parent)
    assert not list(tutorials.rglob("log.*"))
    assert not list(tutorials.rglob("0/*/pointU"))


def test_allrun_with_a_failure(tutorials):
    (tutorials/"spinningCube/constant/cube/mechanicalProperties").unlink()
    done = execute(["./Allrun", "spinningCube", "twistingColumn"], tutorials,
                   MESH="2", PLOT="0")
    assert done.returncode != 0
    assert re.search(r"spinningCube +\d+ s  FAILED", done.stdout)
    assert re.search(r"twistingColumn +\d+ s  ok", done.stdout)


@pytest.mark.parametrize("ranks", ("1", "2"))
def test_alltest(tutorials, ranks):
    names = [] if ranks == "1" else [CASE, "torusImpact/elastoPlastic"]
    before = sorted(tutorials.rglob("*"))
    output = checked(["./Alltest", *names], tutorials, NP=ranks)
    rows = re.findall(r"(?m)^(\S+) +\d+ s  ok$", output)
    assert len(rows) == (len(list(tutorials.rglob("*/Allrun")))
                         if ranks == "1" else 2)
    assert sorted(tutorials.rglob("*")) == before


@pytest.mark.parametrize("tutorial", TUTORIALS)
def test_options(tutorials, tmp_path, tutorial):
    """All tutorials have the same options, and four meshes. A wrong mesh is
    refused before anything runs."""
    allrun = str(tutorials/tutorial/"Allrun")
    output = checked([allrun, "-h"], tmp_path)
    for option in "MESH=I|II|III|IV|", "[NP=N]", "[PLOT=0]":
        assert option in output
    done = execute([allrun], tmp_path, MESH="V")
    assert done.returncode != 0 and "MESH=V" in done.stdout
    assert not list((tutorials/tutorial).glob("log.vertexContactFoam"))


@pytest.mark.parametrize("script", (
    "Allrun", "Allclean", "Alltest", "makePictures", "renderCase.py",
    f"{CASE}/Allrun"))
def test_help(tutorials, script):
    output = checked([str(tutorials/script), "-h"], tutorials.parent)
    assert re.search(r"(?i)usage: .*", output)
    done = execute([str(tutorials/script), "--nonsense"], tutorials.parent)
    assert done.returncode != 0 and "Traceback" not in done.stdout


@pytest.mark.parametrize("script", (
    "features.py", "generalContact.py", "kernel.py", "plasticity.py",
    "scaling.py", "startup.py", "trade/trade.py"))
def test_help_of_benchmarks(tmp_path, script):
    """They run for long, and replace pages: not if a word is wrong."""
    script = str(root/"tests"/"benchmark"/script)
    assert "usage:" in checked([script, "-h"], tmp_path)
    done = execute([script, "--nonsense"], tmp_path)
    assert done.returncode != 0 and "unrecognized" in done.stdout


# Allwmake as one of OpenFOAM's modules: it links existing objects

@pytest.mark.parametrize("variables", (
    {"FOAM_MODULE_LIBBIN": "{}/lib", "FOAM_MODULE_APPBIN": "{}/bin"},
    {"FOAM_MODULE_PREFIX": "{}"}), ids=("folders", "prefix"))
def test_module(tmp_path, variables):
    output = checked(
        [str(root/"Allwmake"), "-fromWmake", "-s", "libso"], tmp_path,
        **{key: value.format(tmp_path) for key, value in variables.items()})
    assert output.splitlines()[-1].startswith("vertexContact: OK (library, ")
    made = {str(file.relative_to(tmp_path)) for file in tmp_path.rglob("*")
            if file.is_file()}
    assert made == {"lib/libvertexContact.so", "bin/vertexContactFoam",
                    "bin/checkContact", "bin/placeRegions", "bin/mapState"}


@pytest.mark.parametrize("arguments, variables, code, reason", (
    (["-fromWmake", "libso"], {"FOAM_MODULE_PREFIX": "false"}, 0,
     "OK (nothing compiled: FOAM_MODULE_PREFIX=false)"),
    (["libso"], {}, 1, "FAILED: unknown argument 'libso'"),
    ([], {"FOAM_MODULE_PREFIX": "here"}, 1, "is not an absolute path")))
def test_module_arguments(tmp_path, arguments, variables, code, reason):
    done = execute([str(root/"Allwmake"), *arguments], tmp_path, **variables)
    assert done.returncode == code
    assert reason in done.stdout.splitlines()[-1]


def test_a_header_that_moves(tmp_path):
    """Objects that depend on a moved header cannot be made from the old
    dependencies: all are compiled again. If a header only changes, they are
    kept."""
    shutil.copy(root/"Allwmake", tmp_path)
    shutil.copytree(root/"etc", tmp_path/"etc")
    header = tmp_path/"src"/"vertexContact"/"one.H"
    made = header.parent/"Make"/os.environ["WM_OPTIONS"]/"one.o"
    made.parent.mkdir(parents=True)
    for folder in "applications", "tests":
        (tmp_path/folder).mkdir()
    folders = {f"FOAM_USER_{which}": str(tmp_path/".build")
               for which in ("LIBBIN", "APPBIN")}

    def isKept():
        made.parent.mkdir(exist_ok=True)
        made.touch()
        execute([str(tmp_path/"Allwmake")], tmp_path,
                VERTEXCONTACT_DIR=str(tmp_path), **folders)
        return made.exists()

    header.touch()
    isKept()
    assert isKept()
    header.write_text("// changed")
    assert isKept()
    header.rename(header.with_name("other.H"))
    assert not isKept()
    assert isKept()


# Where Python finds its packages

def test_python_path(tmp_path):
    """The packages are on PYTHONPATH once, however often etc/bashrc is
    sourced, and before the earlier entries. Nothing is left of another
    checkout that was sourced before."""
    output = checked(
        ["bash", "-euc", f". {root}/etc/bashrc; . {root}/etc/bashrc; "
         'echo "$PYTHONPATH"; python3 -c "import vertexContactCases, '
         'vertexContactTests; print(vertexContactTests.__file__)"'],
        tmp_path, VERTEXCONTACT_DIR="/other",
        PYTHONPATH="/mine:/other/tests:/other/tutorials:/yours")
    path, file = output.splitlines()[-2:]
    assert path == f"{root}/tutorials:{root}/tests:/mine:/yours"
    assert file == f"{root}/tests/vertexContactTests/__init__.py"
