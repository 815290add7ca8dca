"""Runs that are killed, asked to stop, changed while they run, or find no
space to write: the written times stay valid, and runs continue from them."""

import os
import random
import re
import resource
import shutil
import signal
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest

from vertexContactTests.caseTools import (DEFAULT, PRESET, Case, checked,
                                          rankFolders, solver, timeFolders,
                                          timeLimit)
from vertexContactTests.collisions import collision
from vertexContactTests.smallCases import (FLOOR, RUBBER, Body, SmallCase,
                                           condition, coulomb, interface, table)

INTERVALS = 40
NAME = "friction, nearestFace"


def contents(case, time, ranks=1):
    """All files of a time. In parallel without the accounts, since a restarted
    run sums them over the ranks in another order. Without the files that
    OpenFOAM's function objects write for themselves after the time."""
    others = {"functionObjectProperties"}
    if ranks > 1:
        others.add("solidSystem")
    return {str(file.relative_to(case.path)): file.read_bytes()
            for folder in rankFolders(ranks)
            for file in (case/folder/time).rglob("*")
            if file.is_file() and file.name not in others}


def differing(a, b):
    return sorted(name for name in a.keys() | b.keys()
                  if a.get(name) != b.get(name))


def frequent(folder, name=NAME, ranks=1, endTime=0.8):
    """A case that writes often and has not run yet."""
    case = collision(folder, name, endTime=endTime, preset=DEFAULT)
    case.set("system/controlDict", {"writeInterval": endTime/INTERVALS})
    if ranks > 1:
        case.decompose(ranks)
    return case


class Running:
    """A run that goes on while the test changes something."""

    def __init__(self, case, ranks=1, limit=None):
        self.case, self.ranks = case, ranks
        self.log = case/"log"
        with open(self.log, "w") as out:
            self.process = subprocess.Popen(
                solver(ranks), cwd=case.path, stdin=subprocess.DEVNULL,
                stdout=out, stderr=subprocess.STDOUT, start_new_session=True,
                env={**os.environ, "PWD": str(case.path)}, preexec_fn=limit)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.kill()

    def kill(self):
        """Kill the run with its ranks, which mpirun puts in groups of their
        own. Otherwise they would write while the next run starts."""
        session = str(self.process.pid)
        begin = time.time()
        while self.process.poll() is None or re.search("^[^Z]", subprocess.run(
                ["ps", "-s", session, "-o", "stat="], capture_output=True,
                text=True, check=False).stdout, re.MULTILINE):
            subprocess.run(["pkill", "-KILL", "-s", session], check=False)
            assert time.time() - begin < 60
            time.sleep(0.01)

    def end(self, limit=timeLimit):
        """Exit code and output."""
        code = self.process.wait(limit)
        return code, self.log.read_text(errors="replace")

    def reach(self, instant):
        """Wait until a time after this one is written."""
        folder = self.case/rankFolders(self.ranks)[-1]
        while self.process.poll() is None:
            if any(float(t) > instant for t in timeFolders(folder)):
                return
            time.sleep(0.01)
        raise RuntimeError(self.log.read_text()[-3000:])


@pytest.fixture(scope="module")
def straight(tmp_path_factory):
    """The undisturbed run, by scene and number of ranks, and its duration."""
    made = {}

    def get(name=NAME, ranks=1):
        if (name, ranks) not in made:
            case = frequent(tmp_path_factory.mktemp("straight")/"case", name,
                            ranks)
            shutil.copytree(case.path, case.path.parent/"pristine")
            begin = time.time()
            checked(solver(ranks), case.path)
            made[name, ranks] = case, time.time() - begin
        return made[name, ranks]
    return get


def copied(case, path, what="pristine"):
    return Case(shutil.copytree(case.path.parent/what, path))


@pytest.mark.parametrize("name, ranks, kills", (
    (NAME, 1, 25), ("plastic, sphere", 1, 15), ("friction, AMI", 2, 10)))
def test_killed(straight, tmp_path, figures, name, ranks, kills):
    """The run is killed at random instants until it reaches the end, and
    starts again from the beginning until there were enough kills."""
    whole, duration = straight(name, ranks)
    last = timeFolders(whole/rankFolders(ranks)[0])[-1]
    expected = contents(whole, last, ranks)
    chance = random.Random(name)
    path = tmp_path/"killed"
    done = ends = halfWritten = 0
    different, failed = [], []
    while (done < kills or path.exists()) and not failed:
        case = Case(path) if path.exists() else copied(whole, path)
        with Running(case, ranks) as run:
            patience = (chance.uniform(0.1, 1)*duration if done < kills
                        else timeLimit)
            try:
                code, log = run.end(patience)
            except subprocess.TimeoutExpired:
                run.kill()
                done += 1
                log = run.log.read_text()
                code = 0 if "FOAM FATAL" not in log else 1
            else:
                different += differing(expected, contents(case, last, ranks))
                ends += 1
                shutil.rmtree(path)
        halfWritten += "is not complete" in log
        if code != 0:
            failed.append(log[-2000:])
    with figures(f"killed {done} times, {name}, {ranks} ranks") as f:
        f.equal("runs that failed", failed, [])
        f.equal("files that differ at the end", different, [])
        f.atLeast("ends", ends, 1)
        f.atLeast("times that were half written", halfWritten, 0)


def onlyTime(folder):
    for entry in folder.iterdir():
        if entry.name != "uniform":
            shutil.rmtree(entry)
    (folder/"uniform/solidSystem").unlink()


def empty(folder):
    shutil.rmtree(folder)
    folder.mkdir()


def cut(file):
    def action(folder):
        path = folder/file
        path.write_bytes(path.read_bytes()[:-300])
    return action


def noLater(folder):
    """The last time ends within a field, or without the accounts."""
    (folder/"below/sigma").unlink()
    cut("below/F")(folder)
    (folder/"uniform/solidSystem").write_text("FoamFile\n{")


@pytest.mark.parametrize("harm", (onlyTime, empty, noLater,
                                  cut("uniform/solidSystem")),
                         ids=("only time", "empty", "in a field", "at the end"))
@pytest.mark.parametrize("ranks", (1, 2))
def test_half_written(straight, tmp_path, figures, harm, ranks):
    """One rank did not write a time completely."""
    whole, _ = straight(NAME, ranks)
    case = copied(whole, tmp_path/"case", "case")
    times = timeFolders(case/rankFolders(ranks)[0])
    middle, last = times[INTERVALS//2], times[-1]
    for folder in rankFolders(ranks):
        for t in times[INTERVALS//2 + 1:]:
            shutil.rmtree(case/folder/t)
    harmed = case/rankFolders(ranks)[-1]/middle
    harm(harmed)
    before = sorted(str(p.relative_to(harmed)) for p in harmed.rglob("*"))
    with Running(case, ranks) as run:
        code, log = run.end()
    aside = Path(f"{harmed}.incomplete")
    with figures(f"half-written time, {ranks} ranks") as f:
        f.equal("exit code", code, 0)
        f.atLeast("warnings", len(re.findall(
            f"Time {re.escape(middle)} is not complete", log)), 1)
        f.equal("set aside as it was", sorted(
            str(p.relative_to(aside)) for p in aside.rglob("*")), before)
        f.equal("files that differ at the end", differing(
            contents(whole, last, ranks), contents(case, last, ranks)), [])


def garbage(folder):
    path = folder/"below/F"
    data = path.read_bytes()
    at = data.index(b"internalField")
    path.write_bytes(data[:at] + bytes(range(1, 200)) + data[at + 199:])


def otherSize(folder):
    shutil.copy(folder/"above/F", folder/"below/F")


def noVelocity(folder):
    (folder/"below/pointU").unlink()


@pytest.mark.parametrize("size", (0, 40, 200, -100))
def test_half_written_notes(straight, tmp_path, figures, size):
    """An incomplete file that OpenFOAM writes after a time does not prevent a
    restart."""
    whole, _ = straight()
    case = copied(whole, tmp_path/"case", "case")
    times = timeFolders(case.path)
    last = times[-1]
    for t in times[INTERVALS//2 + 1:]:
        shutil.rmtree(case/t)
    notes = case/times[INTERVALS//2]/"uniform/functionObjects" \
        / "functionObjectProperties"
    notes.write_bytes(notes.read_bytes()[:size])
    with Running(case) as run:
        code, _ = run.end()
    with figures(f"functionObjectProperties cut to {size}") as f:
        f.equal("exit code", code, 0)
        f.equal("files that differ at the end", differing(
            contents(whole, last), contents(case, last)), [])


def noDisplacement(folder):
    (folder/"below/pointD").unlink()


@pytest.mark.parametrize("harm, file", (
    (cut("below/F"), "below/F"), (garbage, "below/F"), (otherSize, "below/F"),
    (noVelocity, "below/pointU"), (noDisplacement, "below/pointD"),
    (cut("below/contactStatus"), "below/contactStatus")),
    ids=("cut", "garbage", "other mesh", "missing", "no displacement",
         "cut text"))
def test_harmed_start(straight, tmp_path, figures, harm, file):
    """A file of a complete time was damaged later: the run does not start from
    this time, and changes nothing."""
    whole, _ = straight()
    case = copied(whole, tmp_path/"case", "case")
    last = timeFolders(case.path)[-1]
    harm(case/last)
    case.set("system/controlDict", {"endTime": 1})
    before = {t: contents(case, t) for t in timeFolders(case.path)}
    with Running(case) as run:
        code, log = run.end(60)
    with figures(f"start from a harmed {file}") as f:
        f.equal("exit code", code, 1)
        f.equal("messages", len(re.findall("--> FOAM FATAL", log)), 1)
        f.equal("names the file", f"{last}/{file}" in log, True)
        f.equal("times", {t: contents(case, t)
                          for t in timeFolders(case.path)} == before, True)


def test_missing_processor(straight, tmp_path, figures):
    """One processor folder of a decomposed case is missing."""
    whole, _ = straight(NAME, 2)
    case = copied(whole, tmp_path/"case")
    shutil.rmtree(case/"processor1")
    with Running(case, 2) as run:
        code, log = run.end(60)
    with figures("processor1 is missing") as f:
        f.equal("fails", code != 0, True)
        f.equal("says so", "no constant folder of processor1" in log, True)


def test_time_of_a_user(straight, tmp_path, figures):
    """A time with fields from a tool, without accounts, is a valid start."""
    whole, _ = straight()
    case = copied(whole, tmp_path/"case")
    (case/"0").rename(case/"0.5")
    (case/"0").mkdir()
    with Running(case) as run:
        code, log = run.end()
    with figures("fields at 0.5 s, none at 0 s") as f:
        f.equal("exit code", code, 0)
        f.equal("warning", "is not complete" in log, False)
        f.equal("start", (case/"postProcessing/solidEnergies/0.5").exists(),
                True)


@pytest.mark.parametrize("ranks", (1, 2))
@pytest.mark.parametrize("which, ends", (
    (signal.SIGUSR1, False), (signal.SIGUSR2, True), (signal.SIGTERM, True)))
def test_signals(straight, tmp_path, figures, which, ends, ranks):
    """The signal goes to the last rank only."""
    whole, _ = straight(NAME, ranks)
    case = copied(whole, tmp_path/"case")
    case.set("system/controlDict", {"writeInterval": 0.1, "endTime": 4,
                                    "logInterval": 1})
    asked = "A signal asks the run to write"
    with Running(case, ranks) as run:
        run.reach(0)
        process = run.process.pid
        if ranks > 1:
            children = subprocess.run(
                ["pgrep", "-P", str(process)], capture_output=True,
                text=True).stdout.split()
            process = int(children[-1])
        os.kill(process, which)
        if not ends:
            while asked not in run.log.read_text() \
                    and run.process.poll() is None:
                time.sleep(0.01)
            case.set("system/controlDict", {"stopAt": "nextWrite"})
        code, log = run.end()
    folder = rankFolders(ranks)[0]
    odd = [t for t in timeFolders(case/folder)
           if abs(10*float(t) - round(10*float(t))) > 1e-6]
    if not odd and tmp_path.parts.count("again") < 5:
        # The signal came in a step that ends at a write time. There are some
        # steps between these times: it may do so twice
        test_signals(straight, tmp_path/"again", figures, which, ends, ranks)
        return
    with figures(f"{which.name}, {ranks} ranks") as f:
        f.equal("exit code", code, 0)
        f.equal("said", asked in log, True)
        f.equal("times between write times", len(odd), 1)
        f.equal("the last time is one", timeFolders(case/folder)[-1] == odd[0],
                ends)
        f.equal("End", "\nEnd" in log, True)
    # And the run continues from this time
    case.set("system/controlDict", {"stopAt": "endTime", "endTime":
             float(odd[0]) + 0.01})
    for later in rankFolders(ranks):
        for t in timeFolders(case/later):
            if float(t) > float(odd[0]):
                shutil.rmtree(case/later/t)
    checked(solver(ranks), case.path)
    assert (case/"postProcessing/solidEnergies"/odd[0]).exists()


def small():
    """Files are limited to 12 kB: F is too large."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (12000, 12000))


def test_no_room(straight, tmp_path, figures):
    """A file that cannot be written completely, as on a full disk."""
    whole, _ = straight()
    case = copied(whole, tmp_path/"case")
    times = timeFolders(whole.path)
    with Running(case, limit=small) as run:
        code, log = run.end()
    again = Running(case)
    codeAgain, logAgain = again.end()
    # The first field that is not uniform
    told = re.search(r"FATAL[^>]*/([0-9.]+)/above/F", log)
    with figures("files of 12 kB at most") as f:
        f.equal("exit code", code, 1)
        f.equal("one error names the file", bool(told), True)
        f.equal("exit code with room", codeAgain, 0)
        f.equal("renamed", f"{told[1]} is not complete" in logAgain, True)
        f.equal("files that differ at the end", differing(
            contents(whole, times[-1]), contents(case, times[-1])), [])


@pytest.mark.parametrize("ranks", (1, 2))
def test_no_folder(straight, tmp_path, figures, ranks):
    """One rank cannot make a time folder."""
    whole, _ = straight(NAME, ranks)
    case = copied(whole, tmp_path/"case")
    times = timeFolders(whole/rankFolders(ranks)[0])
    (case/rankFolders(ranks)[-1]/times[3]).write_text("in the way")
    with Running(case, ranks) as run:
        code, log = run.end(60)
    with figures(f"a file where a time folder belongs, {ranks} ranks") as f:
        f.equal("fails", code != 0, True)
        f.equal("one error names the folder", bool(re.search(
            rf"FATAL[^>]*/{times[3]}/", log)), True)
        f.equal("times before are there", differing(
            contents(whole, times[2], ranks), contents(case, times[2], ranks)),
            [])


@pytest.mark.parametrize("ranks", (1, 2))
def test_short_step(straight, tmp_path, figures, ranks):
    """The stable step falls below minDeltaT, in contact."""
    whole, _ = straight(NAME, ranks)
    case = copied(whole, tmp_path/"case")
    case.set("system/controlDict", {"logInterval": 1})
    with Running(case, ranks) as run:
        _, log = run.end()
    steps = [(float(t), float(dt)/float(co)) for t, dt, co in re.findall(
        r"  Time (\S+) s  deltaT (\S+) s  Co (\S+)", log)]
    limits = [limit for _, limit in steps]
    least = (limits[0] + min(limits))/2
    # The limit of a step belongs to the state at its start
    stop = next(t for (t, _), (_, limit) in zip(steps, steps[1:])
                if limit < least)

    case = copied(whole, tmp_path/"short")
    case.set("system/controlDict", {"minDeltaT": least})
    with Running(case, ranks) as run:
        code, log = run.end(120)
    told = re.search(r"\(minDeltaT\): region (\w+), node at .*, at time (\S+) s",
                     log)
    with figures(f"step below minDeltaT, {ranks} ranks") as f:
        f.atLeast("first stable step / least - 1", limits[0]/least - 1, 1e-4)
        f.equal("fails", code != 0, True)
        f.equal("names the region", told[1] in ("below", "above"), True)
        f.within("time of the message [s]", float(told[2]), stop, 1e-5*stop)
        f.within("time written [s]",
                 float(timeFolders(case/rankFolders(ranks)[0])[-1]), stop,
                 1e-5*stop)


@pytest.mark.parametrize("ranks", (1, 2))
def test_short_step_of_an_impact(tmp_path, ranks):
    """In a step surfaces approach each other by a part of a cell: the message
    names them."""
    bodies = [Body((4, 4), "below", sides={"top": "contact"}),
              Body((4, 4), "above", (0, 1.05, 0), sides={"bottom": "contact"},
                   velocity=(0, -10, 0))]
    code, log = SmallCase(
        tmp_path, bodies, 1, preset="balanced",
        control={"minDeltaT": 0.05}, interfaces={"impact": interface(
            ("below", "top"), ("above", "bottom"), pairing="nearestFace")}
        ).attempt(ranks)
    assert code != 0
    assert ("(minDeltaT): the surfaces of interface impact approach each other "
            "too fast, at time 0 s") in log, log


def test_short_step_of_an_edge(tmp_path):
    """In a step no edge loses more than a part of its length: the message names
    a node of the edge."""
    body = Body((4, 4), material=RUBBER, velocity=lambda X: -100*(X - 0.5))
    code, log = SmallCase(tmp_path, body, 1, preset=DEFAULT,
                          control={"minDeltaT": 0.02}).attempt()
    assert code != 0
    assert re.search(r"\(minDeltaT\): region \S+, node at \(.* \(reference\)",
                     log), log


@pytest.mark.parametrize("ranks", (1, 2))
def test_energy_rise(tmp_path, figures, ranks):
    """A coarse cube rotates, without limiter: it gains energy."""
    cube = Body(cells=(3, 3, 3), material=RUBBER, scheme={"limiter": "none"},
                velocity=lambda X: np.cross((0, 0, 1), X - 0.5))
    bound = 1e-4
    cases = [SmallCase(tmp_path/name, cube, 3, control={
        "writeControl": "none", **control}) for name, control in (
            ("free", {}), ("watched", {"maxEnergyRise": bound}))]
    for case in cases:
        if ranks > 1:
            case.decompose(ranks)
    with Running(cases[0], ranks) as run:
        assert run.end()[0] == 0
    energy = cases[0].totalEnergy
    above = energy - np.minimum.accumulate(energy) \
        > bound*np.maximum.accumulate(energy)
    first = np.flatnonzero(above)[0]
    t = cases[0].energies["Time"]
    with Running(cases[1], ranks) as run:
        code, log = run.end(120)
    told = re.search(r"energy has risen by .*: region body, node at .*, in the "
                     r"step to time (\S+) s", log)
    with figures(f"maxEnergyRise, {ranks} ranks") as f:
        f.equal("fails", code != 0, True)
        f.within("time of the step [s]", float(told[1]), t[first],
                 1e-5*t[first])
        f.within("time written [s]", float(
            timeFolders(cases[1]/rankFolders(ranks)[0])[-1]), t[first - 1],
            1e-5*t[first])


@pytest.mark.parametrize("ranks, speed, kinematics", (
    (1, 20, "FHJ"), (1, 60, "FHJ"), (2, 20, "FHJ"), (3, 60, "FHJ"),
    (1, 60, "F"), (2, 20, "FJ"), (1, 60, ""), (3, 20, "")))
def test_bad_state(tmp_path, figures, ranks, speed, kinematics):
    """A corner is turned inside out, on one rank only: all ranks write the
    state at the start of this step, which equals that of a run that ends
    there. With kinematics the paper's scheme is used, otherwise the default
    preset."""
    def velocity(X):
        return np.where(X.sum(axis=1, keepdims=True) < 0.6, speed, 0)*(1, 1, 1)

    body = Body(cells=(5, 5, 5), material=RUBBER, velocity=velocity,
                scheme={"kinematics": kinematics} if kinematics else {})
    cases = [SmallCase(tmp_path/name, body, 1, control={
        "adjustTimeStep": "no", "deltaT": 1e-3, "timePrecision": 12},
        preset=PRESET if kinematics else DEFAULT)
        for name in ("failing", "ending")]
    for case in cases:
        if ranks > 1:
            case.decompose(ranks)
    failing, ending = cases
    with Running(failing, ranks) as run:
        code, log = run.end(120)
    told = re.search(r"The state is not finite or has a Jacobian that is not "
                     r"positive: region body, node at \((\S+) (\S+) (\S+)\) "
                     r"\(reference\).*, in the step to time (\S+) s", log)
    last = timeFolders(failing/rankFolders(ranks)[0])[-1]
    ending.set("system/controlDict", {
        "endTime": float(last), "writeInterval": float(last)})
    with Running(ending, ranks) as run:
        assert run.end(120)[0] == 0
    with figures(f"bad state, {speed} m/s, {kinematics}, {ranks} ranks") as f:
        f.equal("fails", code != 0, True)
        f.equal("says where and when", bool(told), True)
        f.atMost("distance of the place from the corner", float(
            np.linalg.norm([float(x) for x in told.groups()[:3]])), 0.8)
        f.within("step from the time written [s]",
                 float(told[4]) - float(last), 1e-3, 1e-9)
        f.equal("files that differ from the run that ends there", differing(
            contents(failing, last, ranks), contents(ending, last, ranks)), [])


def rewrite(case, file, **entries):
    """Change a file at once, since the running program may read it at any
    instant, and give it a time one minute later, since OpenFOAM only reads
    files again that are 10 s younger (fileModificationSkew)."""
    text = (case/file).read_text()
    for key, value in entries.items():
        # The first change; function objects with intervals of their own follow
        text, n = re.subn(rf"\b{key}\s+[^;]*;", f"{key} {value};", text,
                          count=1)
        assert n == 1, key
    (case/"rewritten").write_text(text)
    os.utime(case/"rewritten", (time.time() + 60,)*2)
    os.replace(case/"rewritten", case/file)


def test_modified(straight, tmp_path, figures):
    """Change friction, Courant number, write interval and end during the
    run."""
    whole, _ = straight()
    case = copied(whole, tmp_path/"case")
    case.set("system/controlDict", {
        "endTime": 1000, "writeInterval": 0.5, "logInterval": 1,
        "runTimeModifiable": True})
    with Running(case) as run:
        run.reach(0)
        rewrite(case, "constant/contactProperties", frictionCoeff=0)
        rewrite(case, "system/controlDict", maxCo=0.15, stopAt="nextWrite",
                writeInterval=1.7)
        code, log = run.end()
    courant = [float(x) for x in re.findall(r"  Co ([0-9.e-]+)", log)]
    last = float(timeFolders(case.path)[-1])
    slip = case.contact("contact")["slip"]
    with figures("modified while the run goes on") as f:
        f.equal("exit code", code, 0)
        f.atLeast("largest Courant number", max(courant[:50]), 0.25)
        f.atMost("of the last step", courant[-1], 0.15*(1 + 1e-9))
        f.within("last time / new write interval", last/1.7, round(last/1.7),
                 1e-6)
        f.equal("contactProperties read again",
                "Re-reading object contactProperties" in log, True)
        f.equal("slip at some time", bool(slip.max() > 0), True)


@pytest.mark.parametrize("file, entries, named", (
    ("constant/contactProperties", {"type": "coulom"}, "coulom"),
    ("system/controlDict", {"maxCo": -1}, "maxCo"),
    ("system/controlDict", {"maxDeltaT": 0}, "maxDeltaT"),
    ("system/controlDict", {"logInterval": 0}, "logInterval"),
    ("system/controlDict", {"adjustTimeStep": "maybe"}, "maybe")),
    ids=("law", "maxCo", "maxDeltaT", "logInterval", "adjustTimeStep"))
@pytest.mark.parametrize("ranks", (1, 2))
def test_modified_wrongly(straight, tmp_path, figures, ranks, file, entries,
                          named):
    """A wrong change gives one message, and no step is lost: the run continues
    when the file is corrected."""
    whole, _ = straight(NAME, ranks)
    case = copied(whole, tmp_path/"case")
    case.set("system/controlDict", {
        "endTime": 1000, "writeInterval": 0.5, "logInterval": 1,
        "maxDeltaT": 1, "adjustTimeStep": True, "runTimeModifiable": True})
    right = (case/file).read_text()
    with Running(case, ranks) as run:
        run.reach(0)
        rewrite(case, file, **entries)
        code, log = run.end(60)
    folder = case/"processor0" if ranks > 1 else case.path
    last = timeFolders(folder)[-1]
    steps = re.findall(r"^Step .*Time (\S+) s", log, re.MULTILINE)
    (case/file).write_text(right)
    case.set("system/controlDict", {"endTime": float(last) + 0.01})
    with Running(case, ranks) as run:
        again, _ = run.end(60)
    with figures(f"modified wrongly, {named}, {ranks} ranks") as f:
        f.equal("fails", code != 0, True)
        f.equal("names it", named in log[log.index("--> FOAM FATAL"):], True)
        f.within("time that was written / last step",
                 float(last)/float(steps[-1]), 1, 1e-5)
        f.equal("exit code of the next run", again, 0)


@pytest.mark.parametrize("change", ("order", "pairs"))
def test_pairs_modified(tmp_path, figures, change):
    """Laws belong to the pairs of their entries, whatever the order of the
    entries. The pairs stay as they were at the start."""
    def block(name, x):
        return Body((2, 2), name=name, start=(x, 0.5, 0), size=(0.5, 0.5, 1),
                    velocity=(0.02, 0, 0), sides={"bottom": "contact"})
    base = Body((8, 2), name="base", size=(4, 0.5, 1), sides={
        "top": "contact", "bottom": condition(
            "fixedVelocity", velocity=(0, 0, 0))})
    slick = "((slick bottom) (base top)) { law { type frictionless; } }"
    rough = ("((rough bottom) (base top)) "
             "{ law { type Coulomb; frictionCoeff 0.3; } }")
    case = SmallCase(
        tmp_path, [block("slick", 0.2), block("rough", 1.2), base], 1000,
        gravity=(0, -0.005, 0), interfaces={"all": {
            "surfaces": "all", "self": "no", "pairs": f"({slick} {rough})"}},
        control={"writeInterval": 0.5, "runTimeModifiable": "yes"},
        preset=DEFAULT)
    file = case/"constant/contactProperties"
    text = file.read_text()
    assert slick in text and rough in text
    with Running(case) as run:
        run.reach(0)
        text = text.replace(f"{slick} {rough}", f"{rough} " + (
            slick if change == "order" else slick.replace("bottom", "left")))
        (case/"rewritten").write_text(text)
        os.utime(case/"rewritten", (time.time() + 60,)*2)
        os.replace(case/"rewritten", file)
        if change == "order":
            # It slides for 13 s
            run.reach(20)
            run.kill()
        log = run.end()[1]
    p = [case.momentumOf(name)[:, 0] for name in ("slick", "rough")]
    with figures(f"pairs with a law of their own, other {change}") as f:
        f.equal("read again", "Re-reading object contactProperties" in log,
                True)
        f.equal("refused", "'pairs': while the run goes on" in log,
                change == "pairs")
        f.within("slick: momentum / at the start", p[0][-1]/p[0][0], 1, 0.02)
        if change == "order":
            f.atMost("rough: momentum / at the start", p[1][-1]/p[1][0], 0.1)


def test_stop_in_the_first_step_of_friction(tmp_path, figures):
    """A floor jumps through a held block in the same step in which two other
    bodies begin to rub: the state before this step is written."""
    sides = {"bottom": "contact", "top": condition(
        "fixedVelocity", velocity=(0, 0, 0))}
    held = Body((3, 3), name="held", start=(10, 0, 0), sides=sides)
    left = Body((3, 3), name="left", start=(0, 5, 0), velocity=(0.1, 0, 0),
                sides={"right": "contact"})
    right = Body((3, 3), name="right", start=(4.3, 5, 0),
                 velocity=(-0.1, 0, 0), sides={"left": "contact"})
    crashed, lost = [], 0
    for jump in np.arange(9.6, 10.1, 0.06):
        path = table((0, (0, 0, 0)), (1, (0, 0.01, 0)),
                     (jump, (0, 0.01, 0)), (jump + 0.02, (0, 3, 0)),
                     (100, (0, 3, 0)))
        case = SmallCase(
            tmp_path/f"{jump:.2f}", [held, left, right], 20, interfaces={
                "floor": {"side": ("held", "bottom"), "obstacle": FLOOR,
                          "motion": {"displacement": path}},
                "all": {"surfaces": "((left right) (right left))",
                        "self": "no", "law": coulomb(0.3)}},
            control={"writeInterval": 20, "maxCo": 0.5}, preset=DEFAULT)
        code, log = case.attempt()
        lost += "gone through" in log and "was written to time" in log
        if code < 0 or "FATAL" not in log:
            crashed.append((jump, code))
    with figures("stopped as friction begins") as f:
        f.equal("without a message", crashed, [])
        f.atLeast("stopped by the floor", lost, 9)


@pytest.mark.parametrize("handler, folder", (
    ("collated", "processors2"), ("masterUncollated", "processor1")))
def test_file_handlers(straight, tmp_path, figures, handler, folder):
    """Two ranks continue from the time that they wrote, also if all ranks
    write into one folder."""
    whole, _ = straight(NAME, 2)
    case = copied(whole, tmp_path/"case")
    for rank in "processor0", "processor1":
        shutil.rmtree(case/rank)
    chosen = ("-fileHandler", handler)
    checked(["decomposePar", "-allRegions", *chosen], case.path)
    run = ["mpirun", "-np", "2", "vertexContactFoam", "-parallel", *chosen]
    for end in 0.1, 0.2:
        case.set("system/controlDict", {"endTime": end})
        log = checked(run, case.path)
    with figures(f"two ranks, {handler}, restarted") as f:
        f.equal("times", sorted(
            t.name for t in (case/folder).iterdir()
            if t.name in ("0.1", "0.2")), ["0.1", "0.2"])
        f.equal("starts again", "is not complete" in log, False)
