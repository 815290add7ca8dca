"""Options of the command line: help, a dry run, and lists of models."""

import hashlib
import re
import shutil

import pytest

from vertexContactTests import caseTools
from vertexContactTests.caseTools import DEFAULT, checked, execute
from vertexContactTests.smallCases import (ELASTIC, Body, SmallCase, condition,
                                           interface)

LISTS = {"listMaterials", "listStartFields", "listContactLaws",
         "listPairings", "listBoundaryConditions", "listBodyForces",
         "listSchemes", "listControls", "listPresets", "listIntegrators",
         "listFunctionObjects"}


def bars(path, cells=20, **control):
    """Two linear elastic bars in a row that hit each other."""
    touching = condition("contact")
    return SmallCase(
        path, [
            Body((cells,), "left", sides={"right": touching},
                 velocity=(0.1, 0, 0), material=ELASTIC),
            Body((cells,), "right", start=(1.01, 0, 0), sides={"left": touching},
                 velocity=(-0.1, 0, 0), material=ELASTIC)],
        endTime=1, interfaces={"bars": interface(("left", "right"),
                                                 ("right", "left"))},
        functions=("contactForces",), probes={"end": ("left", (1, 0, 0))},
        control={"writeInterval": 0.25, **control}, preset=DEFAULT)


def contents(folder):
    """All contents of a folder: files with their checksums, and folders."""
    return {str(path.relative_to(folder)):
            hashlib.sha1(path.read_bytes()).hexdigest() if path.is_file()
            else "folder" for path in folder.rglob("*")}


def dryRun(case, ranks=1):
    """Output of a dry run, which must change no file."""
    before = contents(case.path)
    command = ["vertexContactFoam", "-dry-run"]
    if ranks > 1:
        command = ["mpirun", "-np", str(ranks), *command, "-parallel"]
    done = execute(command, case.path)
    assert contents(case.path) == before
    return done


def number(pattern, text):
    found = re.search(pattern, text)
    assert found, f"no '{pattern}' in\n{text}"
    return float(found.group(1))


def steps(output):
    return int(number(r"\nSteps: (\d+) ", output))


@pytest.fixture(scope="module")
def case(tmp_path_factory):
    """A read-only case and its dry run."""
    case = bars(tmp_path_factory.mktemp("bars"))
    done = dryRun(case)
    assert done.returncode == 0, done.stdout
    case.output = done.stdout
    return case


def test_dry_run_reports(case):
    """The dry run reports the model of the case, and the cost of the run."""
    for what in ("Region left", "material linearElastic",
                 "Interface bars: left right - right left", "\nEnd\n"):
        assert what in case.output
    assert number(r"(\d+) bytes per node; ", case.output) > 50
    assert number(r"; (\S+) MB at most for the process", case.output) > 1
    assert number(r"\nStep: (\S+) s at the start", case.output) > 0
    assert number(r"\nTrial: (\d+) steps", case.output) > 0
    assert number(r"\nRun time: about (\S+) s", case.output) > 0
    assert "not included: the time to write 4 times, " in case.output


@pytest.mark.parametrize("control", [
    {}, {"writeInterval": 0.3}, {"writeInterval": 0.07},
    {"writeControl": "timeStep", "writeInterval": 20},
    {"adjustTimeStep": "no", "deltaT": 0.003}])
def test_number_of_steps(tmp_path, control):
    """With linear elastic bars that are much slower than waves, the stable
    step does not change: the number of steps is exact."""
    case = bars(tmp_path, **control)
    estimated = steps(dryRun(case).stdout)
    output = checked(["vertexContactFoam"], case.path)
    assert estimated == steps(output)
    if control == {}:
        # No step is left
        assert "\nSteps: none" in dryRun(case).stdout


def test_number_of_steps_beyond_all_digits(tmp_path):
    """Of wrong units, say: told, where the count is no integer any more."""
    case = bars(tmp_path)
    case.set("constant/left/mechanicalProperties", {"E": 1e59})
    done = dryRun(case)
    assert done.returncode == 0, done.stdout
    assert number(r"\nSteps: (\S+) to time", done.stdout) > 1e20


def test_dry_run_of_a_restart(tmp_path):
    """The dry run starts from the latest complete time. It does not rename an
    incomplete one."""
    case = bars(tmp_path)
    checked(["vertexContactFoam"], case.path)
    shutil.rmtree(case/"1")
    record = case/"0.75"/"uniform"/"solidSystem"
    record.write_bytes(record.read_bytes()[:-100])

    done = dryRun(case)
    assert done.returncode == 0, done.stdout
    assert "Time 0.75 is not complete" in done.stdout
    estimated = steps(done.stdout)

    output = checked(["vertexContactFoam"], case.path)
    assert (case/"0.75.incomplete").is_dir()
    assert estimated == steps(output)


def test_parallel_dry_run(case, tmp_path):
    case = caseTools.Case(shutil.copytree(case.path, tmp_path/"case"))
    serial = steps(dryRun(case).stdout)
    case.decompose(2)
    done = dryRun(case, ranks=2)
    assert done.returncode == 0, done.stdout
    assert steps(done.stdout) == serial
    assert number(r"; (\S+) MB at most for all processes", done.stdout) > 1


WRONG = {
    "material": ("constant/left/mechanicalProperties", "type", "elastic",
                 "linearElastic"),
    "scheme": ("system/left/fvSchemes", "vertexCentred/volum", "nodal",
               "volume"),
    "interface": ("constant/contactProperties", "interfaces/bars/paring",
                  "AMI", "pairing"),
    "function object": ("system/controlDict", "functions/end/fields",
                        ["pointX"], "pointU"),
    "preset": ("system/controlDict", "preset", "quick", "balanced")}


@pytest.mark.parametrize("what", WRONG)
def test_bad_input(case, tmp_path, what):
    """A dry run has the same error as a run."""
    file, keyword, value, cure = WRONG[what]
    case = caseTools.Case(shutil.copytree(case.path, tmp_path/"case"))
    case.set(file, {keyword: value})
    done = dryRun(case)
    assert done.returncode != 0, done.stdout

    def message(output):
        assert len(re.findall("--> FOAM FATAL", output)) == 1, output
        return re.search(r"(?s)--> FOAM FATAL.*?(?=\n\s*From |\Z)",
                         output).group(0)

    assert cure in message(done.stdout)
    assert message(done.stdout) == message(
        execute(["vertexContactFoam"], case.path).stdout)


def listed(option, folder, *more):
    """Output of a list, without OpenFOAM's banner."""
    output = checked(["vertexContactFoam", f"-{option}", *more], folder)
    return output[output.index("// * * *"):]


def test_help(tmp_path):
    """The help has all options, for users and for the completion of OpenFOAM's
    shell functions, which read -help-full."""
    for option in "-help", "-help-full":
        output = checked(["vertexContactFoam", option], tmp_path)
        found = set(re.findall(r"(?m)^  -(\S+)", output))
        assert LISTS | {"dry-run", "parallel", "case"} <= found, output
    assert "contactProperties" in output


# The lists that must have the same names as the error message about an unknown
# word: option, file, keyword to set
NAMES = {
    "materials": ("listMaterials", "constant/left/mechanicalProperties",
                  "type"),
    "laws": ("listContactLaws", "constant/contactProperties",
             "interfaces/bars/law/type"),
    "pairings": ("listPairings", "constant/contactProperties",
                 "interfaces/bars/pairing"),
    "transfers": ("listPairings", "constant/contactProperties",
                  "interfaces/bars/transfer"),
    "body forces": ("listBodyForces", "constant/left/bodyForces",
                    "shaking/type"),
    "presets": ("listPresets", "system/controlDict", "preset"),
    "integrators": ("listIntegrators", "system/controlDict",
                    "timeIntegrator"),
    "conditions": ("listBoundaryConditions", "0/left/pointU",
                   "boundaryField/left/type"),
    **{name: ("listSchemes", "system/left/fvSchemes", f"vertexCentred/{name}")
       for name in ("cells", "volume", "reconstruction", "limiter",
                    "kinematics", "jacobian", "waveSpeed")}}

# Names and dictionaries that only preset paper has
OF_PAPER = ("reconstruction", "limiter", "kinematics", "jacobian", "waveSpeed",
            "vertexCentred of the paper")

# Dictionaries in which an unknown keyword is set, and the entries that make
# them dictionaries of a certain model
KEYWORDS = {
    "linearElastic": ("listMaterials", "constant/left/mechanicalProperties",
                      "", {}),
    "MooneyRivlin": ("listMaterials", "constant/left/mechanicalProperties", "",
                     {"type": "MooneyRivlin"}),
    "HenckyVonMises": ("listMaterials", "constant/left/mechanicalProperties",
                       "", {"type": "HenckyVonMises"}),
    "JohnsonCook": ("listMaterials", "constant/left/mechanicalProperties",
                    "JohnsonCook/",
                    {"type": "HenckyVonMises", "JohnsonCook": {"A": 1}}),
    "adiabaticHeating": ("listMaterials", "constant/left/mechanicalProperties",
                         "adiabaticHeating/",
                         {"type": "HenckyVonMises", "tauY": 1,
                          "adiabaticHeating": {"cp": 1}}),
    "Coulomb": ("listContactLaws", "constant/contactProperties",
                "interfaces/bars/law/", {"interfaces/bars/law/type":
                                         "Coulomb"}),
    "matching": ("listPairings", "constant/contactProperties",
                 "interfaces/bars/", {}),
    "nearestFace": ("listPairings", "constant/contactProperties",
                    "interfaces/bars/", {"interfaces/bars/pairing":
                                         "nearestFace"}),
    "obstacle": ("listPairings", "constant/contactProperties",
                 "interfaces/wall/",
                 {"interfaces/wall": {"side": ["left", "right"]}}),
    "traction": ("listBoundaryConditions", "0/left/pointU",
                 "boundaryField/left/", {"boundaryField/left/type":
                                         "traction"}),
    "uniform": ("listBodyForces", "constant/left/bodyForces", "shaking/", {}),
    **{name: ("listSchemes", "system/left/fvSchemes", "vertexCentred/", {})
       for name in ("vertexCentred", "vertexCentred of the paper")},
    "pointProbes": ("listFunctionObjects", "system/controlDict",
                    "functions/end/", {})}


@pytest.fixture
def spoilt(case, tmp_path):
    """A copy of the case that also has a body force."""
    case = caseTools.Case(shutil.copytree(case.path, tmp_path/"case"))
    (case/"constant"/"left"/"bodyForces").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; "
        "object bodyForces; }\n"
        "shaking { type uniform; acceleration (1 0 0); }\n")
    return case


def valid(case):
    """Words in parentheses in the message about an unknown word."""
    output = execute(["vertexContactFoam", "-dry-run"], case.path).stdout
    found = re.search(r"Valid [^:(]*: ?\n?[^(]*\(([^)]*)\)", output)
    assert found, output
    return found.group(1).split()


@pytest.mark.parametrize("what", NAMES)
def test_names(spoilt, tmp_path, what):
    """A list has every name that the message about an unknown name has."""
    option, file, keyword = NAMES[what]
    # OpenFOAM has this condition, but it is not a condition for solids
    wrong = "calculated" if what == "conditions" else "xyzzy"
    if what in OF_PAPER:
        spoilt.set("system/controlDict", {"preset": "paper"})
    spoilt.set(file, {keyword: wrong})
    words = set(re.findall(r"[\w/]+", listed(option, tmp_path)))
    names = valid(spoilt)
    assert len(names) > 1 or what == "body forces"
    assert set(names) <= words, sorted(set(names) - words)


@pytest.mark.parametrize("what", KEYWORDS)
def test_keywords(spoilt, tmp_path, what):
    """A list has every keyword that the message about an unknown keyword has,
    with its meaning."""
    option, file, prefix, entries = KEYWORDS[what]
    if what in OF_PAPER:
        spoilt.set("system/controlDict", {"preset": "paper"})
    spoilt.set(file, {**entries, f"{prefix}xyzzy": 1})
    text = listed(option, tmp_path)
    for keyword in valid(spoilt):
        if what in ("JohnsonCook", "adiabaticHeating"):
            keyword = f"{what}/{keyword}"
        assert re.search(rf"(?m)^    {keyword} .*\S  +\S", text), keyword


def test_presets_are_what_they_say(case, tmp_path):
    """The columns of the presets equal what a run with each preset reports."""
    rows = [line.split() for line in
            listed("listPresets", tmp_path).splitlines() if line.strip()]
    names = next(row for row in rows if "balanced" in row and "fast" in row
                 and len(row) == 4)
    table = {row[0]: dict(zip(names, row[1:])) for row in rows
             if len(row) == 5}
    assert set(names) == {"fast", "balanced", "accurate", "paper"}
    for name in names:
        copy = caseTools.Case(shutil.copytree(case.path, tmp_path/name))
        copy.replace("system/controlDict", r"maxCo [^;]*;", "")
        copy.set("system/controlDict", {"preset": name})
        output = dryRun(copy).stdout
        assert f"timeIntegrator {table['timeIntegrator'][name]}, " \
            f"maxCo {table['maxCo'][name]}\n" in output
        for option in ("reconstruction", "limiter", "cells", "dissipation",
                       "correction"):
            value = table[option][name]
            if value == "-":
                assert f", {option} " not in output, option
            else:
                assert f"{option} {value}" in output, option


def test_library_of_a_user(tmp_path):
    """Models of another library are listed. The library comes from the command
    line or from the controlDict of a case."""
    library = "manufacturedSolution"
    checked(["wmake", "-s", "libso", f"tests/verification/{library}"],
            caseTools.root)
    assert library not in listed("listBodyForces", tmp_path)
    byOption = listed("listBodyForces", tmp_path, "-lib", library)

    # A folder that has only a controlDict
    (tmp_path/"system").mkdir()
    (tmp_path/"system"/"controlDict").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; "
        f"object controlDict; }}\nlibs ({library});\n")
    for output in byOption, listed("listBodyForces", tmp_path):
        assert re.search(rf"(?m)^{library}$", output), output
        assert re.search(r"(?m)^    amplitude +\[m\]", output), output


@pytest.mark.parametrize("ranks", (1, 2))
@pytest.mark.parametrize("preset", (DEFAULT, "paper"))
def test_profile(preset, ranks, tmp_path):
    """The times of the passes add up to the steps, and the results do not
    change."""
    case = bars(tmp_path/"case", cells=200//ranks**2, preset=preset)
    if ranks > 1:
        case.decompose(ranks)
    command = ["vertexContactFoam"]
    if ranks > 1:
        command = ["mpirun", "-np", str(ranks), *command, "-parallel"]
    plain = checked(command, case.path)
    assert "Passes" not in plain
    shutil.rmtree(case.path/"postProcessing")
    for folder in [case.path, *case.path.glob("processor*")]:
        for time in folder.glob("[0-9]*"):
            if float(time.name) > 0:
                shutil.rmtree(time)
    output = checked([*command, "-profile"], case.path)
    assert steps(output) == steps(plain)
    passes = {name: (float(us), float(share)) for name, us, share in re.findall(
        r"\n    ([a-z ]+): (\S+), (\S+) %", output)}
    # Ranks wait for each other: short passes may be below the shown minimum
    expected = {"gradients", "fluxes", "stress", "update", "other"} \
        if ranks == 1 else {"processors", "other"}
    assert expected <= set(passes), output
    assert abs(sum(share for _, share in passes.values()) - 100) < 1.5, passes
    us = number(r"\nSteps: .* s, (\S+) us", output)
    assert abs(sum(us for us, _ in passes.values()) - us) < 0.02*us
    assert 0 < number(r"on a core, (\S+) of the", output) < 2
