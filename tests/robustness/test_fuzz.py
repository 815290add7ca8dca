"""Inputs of small cases with one random fault each. The result is a clean run,
or one error that names the file and, if the fault is in an entry, the keyword.
There is never a crash or a hang, and an unknown keyword is never accepted in
silence.

FUZZ in the environment is the number of faults (default 500), SEED the first
seed."""

import os
import random
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor

import pytest

from vertexContactTests.caseTools import DEFAULT, Case
from vertexContactTests.collisions import collision

COUNT = int(os.environ.get("FUZZ", 500))
SEED = int(os.environ.get("SEED", 1))
SCENES = ("friction, AMI", "plastic, nearestFace", "elastic, rising sphere")
PATIENCE = 60           # seconds; a run takes 0.2 s

# Entries for which a wrong number only makes the run long
LENGTHS = {"endTime", "deltaT", "maxCo", "writeInterval", "adjustTimeStep",
           "logInterval"}
# OpenFOAM also has messages of its own about these
OTHERS = {"controlDict", "pointU", "fvSolution"}

ENTRY = re.compile(r"^([ \t]*)([A-Za-z]\w*)[ \t]+([^;{}\n]+);", re.M)
NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:e[-+]?\d+)?")


def files(case):
    found = [case/"system/controlDict"]
    found += sorted((case/"constant").glob("*Properties"))
    found += sorted(case.path.glob("constant/*/*Properties"))
    found += sorted(case.path.glob("system/*/fvSchemes"))
    found += sorted(case.path.glob("0/*/pointU"))
    return [f for f in found if f.is_file()]


def inHeader(text, position):
    return position < text.index("}")


def faults(text, chance):
    """Name of the fault, the changed text, and the keywords of which the
    message may name one."""
    kind = chance.choice((
        "deleted", "doubled", "swapped", "negative", "huge", "nan", "word",
        "number", "misspelt", "renamed", "cut", "garbage", "empty"))
    if kind == "cut":
        return kind, text[:chance.randrange(len(text))], ()
    if kind == "garbage":
        at = chance.randrange(len(text))
        junk = bytes(chance.randrange(1, 256) for _ in range(40))
        return kind, text[:at] + junk.decode("latin1") + text[at + 40:], ()
    if kind == "empty":
        return kind, "", ()
    entries = [m for m in ENTRY.finditer(text)
               if not inHeader(text, m.start())]
    if kind in ("negative", "huge", "nan", "word"):
        entries = [m for m in entries if NUMBER.search(m[3])
                   and m[2] not in LENGTHS]
    if not entries:
        return "none", text, ()
    m = chance.choice(entries)
    key, value = m[2], m[3]
    if kind == "deleted":
        new = ""
    elif kind == "doubled":
        other = chance.choice(entries)[3]
        new = f"{m[0]}\n{key} {other};"
    elif kind == "swapped":
        other = chance.choice(entries)
        new = f"{key} {other[3]};"
    elif kind in ("negative", "huge", "nan", "word"):
        by = {"negative": lambda n: f"-{n[0].lstrip('+-')}",
              "huge": lambda n: "1e300", "nan": lambda n: "nan",
              "word": lambda n: "many"}[kind]
        numbers = list(NUMBER.finditer(value))
        n = chance.choice(numbers)
        new = f"{key} {value[:n.start()]}{by(n)}{value[n.end():]};"
    elif kind == "number":
        new = f"{key} 42;"
    elif kind == "misspelt":
        i = chance.randrange(len(key))
        key = key[:i] + "x" + key[i:]
        new = f"{key} {value};"
    else:
        new = f"{key} somewhere;"
    return kind, text[:m.start()] + new + text[m.end():], (m[2], key)


def run(case):
    """Exit code and output; None if the run does not end."""
    try:
        done = subprocess.run(
            ["vertexContactFoam"], cwd=case.path, timeout=PATIENCE,
            env={**os.environ, "PWD": str(case.path)}, text=True,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, errors="replace")
    except subprocess.TimeoutExpired as timeout:
        return None, (timeout.stdout or b"").decode(errors="replace")
    return done.returncode, done.stdout


def verdict(kind, file, keywords, code, output):
    """The fault in the program's response; empty if the response is right."""
    if code is None:
        return "hangs"
    if code < 0 or "sigSegv" in output or "sigFpe" in output \
            or code not in (0, 1):
        return f"crashes ({code})"
    if code == 0:
        if "\nEnd" not in output:
            return "ends without End"
        if kind == "misspelt" and file.name not in OTHERS - {"controlDict"}:
            return "unknown keyword taken in silence"
        return ""
    messages = re.findall(r"--> FOAM FATAL(?: IO)? ERROR", output)
    if len(messages) != 1:
        return f"{len(messages)} messages"
    message = output[output.index("--> FOAM FATAL"):]
    if "Likely cures" in message:
        return ""           # a run whose input was not impossible at first
    named = any(k in message for k in keywords)
    if file.name in OTHERS:
        # Messages of OpenFOAM; they name one of these keywords
        return "" if file.name in message or named \
            or "Valid entries" in message else "message names nothing"
    if file.name not in message:
        return "message without the file"
    if keywords and not named:
        return "message without the keyword"
    return ""


@pytest.fixture(scope="module")
def cases(tmp_path_factory):
    made = []
    for i, name in enumerate(SCENES):
        case = collision(tmp_path_factory.mktemp("fuzz")/"case", name,
                         endTime=0.1, preset=DEFAULT)
        case.set("system/controlDict", {"writeFormat": "ascii"})
        made.append(case)
    return made


def tried(cases, folder, seed):
    chance = random.Random(seed)
    case = chance.choice(cases)
    path = folder/str(seed)
    case = Case(shutil.copytree(case.path, path))
    file = chance.choice(files(case))
    kind, text, keywords = faults(file.read_text(), chance)
    file.write_text(text, encoding="latin1", errors="replace")
    code, output = run(case)
    wrong = verdict(kind, file, keywords, code, output)
    at = output.find("--> FOAM FATAL")
    shutil.rmtree(path)
    return (kind, code), f"SEED={seed} {file.relative_to(path)}: {kind} " \
        f"{'/'.join(keywords)}: {wrong}: {output[at:at + 600]}" if wrong else ""


def test_fuzz(cases, tmp_path, figures):
    for case in cases:
        assert run(case)[0] == 0
        shutil.rmtree(case/"postProcessing")
        for time in case.path.glob("0.*"):
            shutil.rmtree(time)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(lambda s: tried(cases, tmp_path, s),
                                range(SEED, SEED + COUNT)))
    wrong = [text for _, text in results if text]
    print("\n\n".join(wrong))
    with figures(f"{COUNT} faults in the input") as f:
        f.atLeast("refused", sum(code == 1 for (_, code), _ in results),
                  0.4*COUNT)
        f.atLeast("run", sum(code == 0 for (_, code), _ in results),
                  0.05*COUNT)
        f.equal("taken wrongly", len(wrong), 0)
