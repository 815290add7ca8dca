"""One entry for many surfaces gives the same as named interfaces, for any
order of the bodies, number of ranks, and restart. Laws by pair, and refused
input."""

import shutil

import numpy as np
import pytest

from vertexContactTests.caseTools import checked, differingFiles, runAgain
from vertexContactTests.contactScenes import (END, PLACES, difference, solve,
                                              solveOn, squares)
from vertexContactTests.smallCases import (OnePatch, SmallCase, coulomb,
                                           interface, largest, turned)

NAMED = {
    "bottom": interface(("square00", "right"), ("square10", "left"),
                        pairing="nearestFace"),
    "top": interface(("square01", "right"), ("square11", "left"),
                     pairing="nearestFace"),
    "left": interface(("square00", "top"), ("square01", "bottom"),
                      pairing="nearestFace"),
    "right": interface(("square10", "top"), ("square11", "bottom"),
                       pairing="nearestFace")}
ALL = {"all": {"surfaces": "all"}}
RUBBING = {"all": {"surfaces": "all", "law": coulomb(0.3)}}


def case(folder, interfaces, bodies=None, **control):
    return SmallCase(
        folder, bodies or squares(), END, interfaces,
        functions=("contactForces",), preset="balanced",
        control={"maxCo": 0.9, **control})


# Blocks across the middle, of which only the corners meet
ACROSS = ('((square00 ".*") (square11 ".*")) '
          '((square10 ".*") (square01 ".*"))')


def test_as_named(tmp_path, figures):
    """Pairs that are found automatically give the results of named interfaces.
    All pairs update their surfaces at the same instants: when the state is
    written."""
    often = {"writeInterval": END/10}
    named = case(tmp_path/"named", NAMED, **often)
    general = case(tmp_path/"all", {"all": {
        "surfaces": "all", "exclude": f"({ACROSS})"}}, **often)
    sets = case(tmp_path/"sets", {"sets": {
        "sides": '(("square0." ".*") ("square1." "left|right"))',
        "exclude": f"({ACROSS})"},
        "others": {"surfaces": '(("square.*" "top") ("square.*" bottom))',
                   "exclude": f"({ACROSS})"}}, **often)
    for c in (named, general, sets):
        solve(c)
    lost = 1 - named.totalEnergy[-1]/named.totalEnergy[0]
    with figures("General contact against named interfaces") as f:
        f.atLeast("all: energy that contact takes / initial energy", lost,
                  0.01)
        for name, other in ("all", general), ("sets", sets):
            f.atMost(f"{name}: difference of energies / initial energy",
                     difference(named, other), 1e-9)


@pytest.mark.parametrize("places", ("metis", *PLACES))
def test_ranks(tmp_path, figures, places):
    """With friction, so that the slip is exchanged, too."""
    bodies = squares()
    bodies[0].velocity = (2, 4, 0)
    serial, parallel = (case(tmp_path/n, RUBBING, bodies)
                        for n in ("serial", "parallel"))
    solve(serial)
    if places == "metis":
        solve(parallel, 2)
    else:
        solveOn(parallel, *PLACES[places])
    friction = serial.energies["total:frictionDissipation"]
    with figures(f"General contact on ranks: {places}") as f:
        f.atLeast("friction / initial energy",
                  friction[-1]/serial.totalEnergy[0], 0.001)
        f.atMost("difference of friction / initial energy",
                 abs(parallel.energies["total:frictionDissipation"][-1]
                     - friction[-1])/serial.totalEnergy[0], 1e-9)
        f.atMost("difference of energies / initial energy",
                 difference(serial, parallel), 1e-9)


# One law for a row of the squares, written as dictionaries or as a list. In a
# list, a name alone is a region
ROW = {
    "named": {"row": {"sides": '(("square.0" ".*") ("square.0" ".*"))',
                      "law": coulomb(0.5)}},
    "listed": '(("square.0" "square.0") '
              '{ law { type Coulomb; frictionCoeff 0.5; } })'}


@pytest.mark.parametrize("form", ROW)
def test_pairs_by_law(tmp_path, form):
    """Each pair has the law of the entry that contains it."""
    c = case(tmp_path/"c", {"all": {
        "surfaces": "all", "law": {"type": "frictionless"},
        "pairs": ROW[form]}})
    assert "other laws for pairs: 1" in solve(c)
    lines = (c.path/"postProcessing/contactForces/0/all.dat").read_text()
    head, *rows = [line.split() for line in lines.splitlines()]
    stick = head.index("stick") - 1
    stuck = {tuple(r[1:3]) for r in rows if int(r[stick]) > 0}
    touching = {tuple(r[1:3]) for r in rows}
    assert ("square00.right", "square10.left") in stuck
    assert ("square01.right", "square11.left") in touching
    assert all(a.startswith(("square00", "square10")) and
               b.startswith(("square00", "square10")) for a, b in stuck)


def test_listed_pairs(tmp_path):
    """A list of several entries, for regions and surfaces, equals dictionaries
    to the last bit."""
    laws = [f"{{ law {{ type Coulomb; frictionCoeff {k}; }} }}"
            for k in (0.2, 0.4)]
    listed, named = (case(tmp_path/form, {"all": {
        "surfaces": "all", "pairs": pairs}}) for form, pairs in (
            ("listed", f'((square00 "square10") {laws[0]} (((square00 top) '
                       f'(square11 bottom)) ("square01" ".*")) {laws[1]})'),
            ("named", {
                "a": {"sides": '((square00 ".*") (square10 ".*"))',
                      "law": coulomb(0.2)},
                "b": {"sides": '(((square00 top) (square11 bottom)) '
                               '(square01 ".*"))', "law": coulomb(0.4)}})))
    for c in (listed, named):
        solve(c)
    friction = [c.energies["total:frictionDissipation"][-1]
                for c in (listed, named)]
    assert friction[0] == friction[1] > 0
    a, b = ((c.path/c.last/"square00/pointD").read_bytes()
            for c in (listed, named))
    assert a == b


def test_exclude(tmp_path):
    """Excluded pairs fly through each other."""
    c = case(tmp_path/"c", {"all": {
        "surfaces": "all",
        "exclude": '((("square0." right) ("square1." left)))'}})
    log = solve(c)
    assert "8 surfaces" in log
    lines = (c.path/"postProcessing/contactForces/0/all.dat").read_text()
    pairs = {tuple(line.split()[1:3]) for line in lines.splitlines()[1:]}
    assert pairs and not any("right" in a + b for a, b in pairs)


def test_restart(tmp_path):
    """A restarted run is equal to the last bit."""
    whole = case(tmp_path/"whole", ALL, writeInterval=END/2)
    solve(whole)
    half = tmp_path/"half"
    shutil.copytree(whole.path, half)
    times = sorted((p for p in half.iterdir()
                    if p.name.replace(".", "").isdigit()),
                   key=lambda p: float(p.name))
    shutil.rmtree(times[-1])
    shutil.rmtree(half/"postProcessing")
    checked(["vertexContactFoam"], half)
    for body in squares():
        a, b = ((p/times[-1].name/body.name/"pointD").read_bytes()
                for p in (whole.path, half))
        assert a == b
    a, b = ((p/times[-1].name/"uniform/solidSystem").read_text()
            for p in (whole.path, half))
    assert a == b and "square00.right-square10.left" in a


@pytest.mark.parametrize("ranks", (1, 2))
def test_restart_with_friction(tmp_path, figures, ranks):
    """Sticking and slip on several ranks: all files of the last time are equal
    bit by bit, and the impulses of each pair continue."""
    bodies = squares()
    bodies[0].velocity = (2, 4, 0)
    c = case(tmp_path/"c", RUBBING, bodies, writeInterval=END/4)
    (expected, whole), (found, again) = runAgain(
        c, ranks, lambda c, _: (c.contact("all"), c.energies))
    (pairs, energies), (pairsAgain, energiesAgain) = whole, again
    friction = energies["total:frictionDissipation"]
    middle = np.abs(energies["Time"] - END/2).argmin()
    at = pairs["Time"] == pairs["Time"].max()
    with figures(f"General contact with friction, restart, {ranks} ranks") as f:
        f.atLeast("friction before, and after / initial energy",
                  min(friction[middle], friction[-1] - friction[middle])
                  / energies["total:kinetic"][0], 1e-4)
        f.equal("files that differ", differingFiles(expected, found), [])
        f.atLeast("pairs that touch at the end", np.count_nonzero(at), 2)
        f.atMost("largest difference of their last impulses / largest", max(
            largest(pairs[key][at] - pairsAgain[key][
                pairsAgain["Time"] == pairs["Time"].max()])
            for key in pairs if ":I" in key)/largest(pairs["minus:Ix"]),
            0 if ranks == 1 else 1e-14)
        f.atMost("largest difference of the last energies / initial", max(
            abs(energies[key][-1] - energiesAgain[key][-1])
            for key in energies)/energies["total:kinetic"][0],
            0 if ranks == 1 else 1e-14)


@pytest.mark.parametrize("ranks", (1, 2))
def test_dry_run(tmp_path, figures, ranks):
    """-dry-run says how many pairs may touch and how many are near, and runs
    nothing."""
    c = case(tmp_path/"c", ALL)
    command = ["vertexContactFoam", "-dry-run"]
    if ranks > 1:
        c.decompose(ranks)
        command = ["mpirun", "-np", str(ranks), *command, "-parallel"]
    log = checked(command, c.path)
    with figures(f"General contact, -dry-run, {ranks} ranks") as f:
        f.equal("says what may meet", "Interface all: 8 surfaces, "
                "36 pairs may touch and 36 are near" in log, True)
        f.equal("says the steps it would take", "\nSteps: " in log, True)
        f.equal("writes results", (c.path/"postProcessing").exists(), False)


def test_obstacle_of_many(tmp_path):
    """One entry gives each body its own contact with the plane."""
    floor = {"side": '("square.0" ".*")', "obstacle": {
        "type": "plane", "planeType": "pointAndNormal",
        "pointAndNormalDict": {"point": "(0 -0.02 0)", "normal": "(0 1 0)"}}}
    bodies = squares()
    for body in bodies:
        body.velocity = (0, -2, 0)
        body.sides["bottom"] = "contact"
    c = case(tmp_path/"c", {"floor": floor, **ALL}, bodies)
    solve(c)
    for body in "square00", "square10":
        force = c.contact(f"floor.{body}.bottom")
        assert force[f"{body}.bottom:Fy"].max() > 0
    assert len(list(c.path.glob(
        "postProcessing/contactForces/0/floor.*"))) == 6


def test_two_of_many(tmp_path):
    """A pair belongs to one interface of many surfaces. If it has an interface
    of its own, it belongs to that one."""
    c = case(tmp_path/"two", {**ALL, "more": {
        "surfaces": '(("square0." ".*"))'}})
    with pytest.raises(RuntimeError, match="in 'all' and in 'more'"):
        solve(c)
    c = case(tmp_path/"own", {**ALL, "bottom": NAMED["bottom"]})
    solve(c)
    assert c.contact("bottom")["area"].max() > 0
    lines = (c.path/"postProcessing/contactForces/0/all.dat").read_text()
    pairs = {tuple(line.split()[1:3]) for line in lines.splitlines()[1:]}
    assert ("square00.right", "square10.left") not in pairs
    assert ("square01.right", "square11.left") in pairs


def test_check_contact(tmp_path):
    """checkContact reports the pairs that have opposite faces."""
    c = case(tmp_path/"c", ALL, squares(gap=0.01))
    log = checked(["checkContact"], c.path)
    assert "8 surfaces" in log and "Contact OK" in log
    assert "Interface all.square00.right-square10.left" in log
    assert log.count("Interface all.") == 4
    assert "32 more pairs of surfaces are near" in log
    assert len(list(c.path.glob("postProcessing/checkContact/0/*.vtk"))) == 4


EVERY = ("(square00 right)", "(square00 top)", "(square01 right)",
         "(square11 bottom)")
LAW = "{ law { type frictionless; } }"
# The fault, and the words that the error must have
WRONG = {
    "nothing": ({"surfaces": '(("disc.*" surface))'},
                ("surfaces", "matches no surface", *EVERY)),
    "region": ({"surfaces": "((square22 right))"},
               ("surfaces", "no region 'square22'", "square00", "square11")),
    "patch": ({"surfaces": "((square00 inside))"}, ("no patch 'inside'",)),
    "three sets": ({"sides": '((square00 ".*") (square10 ".*") '
                             '(square11 ".*"))'},
                   ("sides", "needs two sets")),
    "tied": ({"law": {"type": "tied"}}, ("tied", "of their own")),
    "excluded": ({"exclude": '((square00 ".*") (".*" ".*"))'},
                 ("no surface is left", "square00.right", *EVERY)),
    "exclude, region": ({"exclude": '((square22 right) (".*" ".*"))'},
                        ("exclude", "no region 'square22'", "square11")),
    "exclude, nothing": ({"exclude": '(("disc.*" ".*") (".*" ".*"))'},
                         ("exclude", '"disc.*"', "matches no", *EVERY)),
    "exclude, one": ({"exclude": "((square00 right))"},
                     ("exclude", "needs two sets")),
    "exclude, a name": ({"exclude": "square00"},
                        ("exclude", "needs two sets")),
    "two laws": ({"pairs": {
        "a": {"sides": '((square00 right) (".*" left))',
              "law": coulomb(0.1)},
        "b": {"sides": '((".*" right) (square10 left))',
              "law": coulomb(0.2)}}},
        ("pairs", "two laws", "square10.left", "in 'a' and in 'b'")),
    "two laws, listed": ({"pairs": f'((square00 ".*") {LAW} '
                                   f'(".*" square10) {LAW})'},
                         ("pairs", "two laws", "in '1' and in '2'")),
    "pairs, region": ({"pairs": {"a": {
        "sides": '((square22 right) (".*" left))', "law": coulomb(0.1)}}},
        ("sides", "no region 'square22'", "square11")),
    "pairs, listed, region": ({"pairs": f"((square00 square22) {LAW})"},
                              ("pairs", "square22", "matches no", *EVERY)),
    "pairs, two for a law": (
        {"pairs": f"((square00 square10) (square00 square01) {LAW})"},
        ("pairs", "more than one list")),
    "pairs, listed, free": ({"pairs": f"((square00 (square11 top)) {LAW})"},
                            ("'pairs'", "tractionFree", "must be 'contact'")),
    "pairs, nothing": ({"pairs": f'((square00 "disc.*") {LAW})'},
                       ("pairs", '"disc.*"', "matches no", *EVERY)),
    "pairs, elsewhere": ({
        "surfaces": '(("square0." ".*"))',
        "pairs": f"((square10 square11) {LAW})"},
        ("pairs", "'1' has no pair", "(square00 right)")),
    "pairs, no law": ({"pairs": {"a": {
        "sides": '((square00 right) (".*" left))'}}}, ("law", "pairs", "a")),
    "pairs, listed without a law": ({"pairs": "((square00 square10))"},
                                    ("pairs", "neither a dictionary nor")),
    "pairs, a name": ({"pairs": "square00"},
                      ("pairs", "neither a dictionary nor")),
    "pairs, keyword": ({"pairs": {"a": {
        "sides": '((square00 right) (".*" left))', "law": coulomb(0.1),
        "friction": 1}}}, ("friction", "sides", "law")),
    "pairing": ({"pairing": "AMI"}, ("nearestFace",))}


@pytest.mark.parametrize("what", WRONG)
def test_refused(tmp_path, what):
    """One error, with the file, the keyword, and the existing names."""
    change, words = WRONG[what]
    if "sides" not in change:
        change = {"surfaces": "all", **change}
    code, log = case(tmp_path/"c", {"all": change}).attempt()
    assert code == 1
    assert log.count("FOAM FATAL IO ERROR") == 1
    for word in ("contactProperties", *words):
        assert word in log


@pytest.mark.parametrize("entry", (ALL, RUBBING), ids=("none", "friction"))
def test_superposed_velocity(tmp_path, figures, entry):
    """A common velocity changes nothing, although pairings follow the
    bodies."""
    rest, flying = squares(), squares()
    for body in flying:
        body.velocity = tuple(np.add(body.velocity, (1000, 300, 0)))
    a, b = (case(tmp_path/name, entry, bodies=bodies)
            for name, bodies in (("rest", rest), ("flying", flying)))
    for c in (a, b):
        solve(c)
    strain = [c.energies["total:strain"][-1] for c in (a, b)]
    stress = [np.concatenate([c.at("sigma", region=body.name)
                              for body in rest]) for c in (a, b)]
    with figures("General contact, with 1000 m/s on top") as f:
        f.atMost("difference of the stress / largest",
                 largest(stress[1] - stress[0])/largest(stress[0]), 1e-9)
        f.atMost("difference of strain energies, relative",
                 abs(strain[1]/strain[0] - 1), 1e-9)


def test_turned(tmp_path, figures):
    """A cube falls on its corner. Turned by right angles and moved elsewhere,
    the scene is the same: round-off does not decide which faces of a body may
    meet, although equal cells have distances of just two face widths."""
    def tilted(X):
        X = turned(turned(X - 0.02, (0, 0, 1), 0.2), (1, -1, 0), 0.8)
        return X + (0, 0, 5e-4 - X[:, 2].min())

    soft = {"type": "neoHookean", "rho": 1100, "E": 2e6, "nu": 0.4}
    stiff = {"type": "neoHookean", "rho": 1500, "E": 5e6, "nu": 0.3}
    found = []
    for turns, shift in (0, (0, 0, 0)), (2, (0, 0, 0)), (1, (1.3, -0.7, 0.9)):
        def turn(X, turns=turns):
            return turned(X, (1, 1, 1), turns*2*np.pi/3)

        def place(X, turn=turn, shift=shift):
            return turn(X) + shift

        bodies = [
            OnePatch((6, 6, 6), name="cube", size=(0.04, 0.04, 0.04),
                     material=soft, velocity=tuple(turn(np.array((0, 0, -2)))),
                     moved=lambda X, place=place: place(tilted(X))),
            OnePatch((10, 10, 3), name="slab", start=(-0.05, -0.05, -0.02),
                     size=(0.1, 0.1, 0.02), material=stiff, moved=place)]
        c = SmallCase(tmp_path/f"{turns}", bodies, 0.012, RUBBING,
                      preset="balanced",
                      control={"maxCo": 0.9, "writeInterval": 0.004}).run()
        D = [c.at("pointD", region=b.name) for b in bodies]
        found.append(turned(np.concatenate(D), (1, 1, 1),
                            -turns*2*np.pi/3))
    with figures("General contact, turned by right angles, and moved") as f:
        for what, D in zip(("turned", "turned and moved"), found[1:]):
            f.atMost(f"{what}: difference of the displacements / largest",
                     largest(D - found[0])/largest(found[0]), 1e-9)
