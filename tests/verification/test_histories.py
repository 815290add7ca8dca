"""Histories: number of rows and accuracy, filtered contact force, extremes and
averages."""

import numpy as np
import pytest

from vertexContactCases import readResults
from vertexContactTests.caseTools import DEFAULT, checked, runAgain, solver
from vertexContactTests.smallCases import (ELASTIC, FLOOR, Body, SmallCase,
                                           condition, largest)

SPEED, CUT_OFF = 0.1, 0.5


def function(name, **more):
    return {"type": name, "libs": "(vertexContact)", **more}


def falling(folder, endTime=12, n=40, sides={}, **functions):
    """A bar that hits a plane and leaves it after 2 s; c_p = 1."""
    bar = Body(cells=(n,), name="bar", material=ELASTIC, velocity=(-SPEED, 0, 0),
               start=(0.05, 0, 0), sides={"left": "contact", **sides})
    plane = {**FLOOR, "pointAndNormalDict": {
        "point": (0, 0, 0), "normal": (1, 0, 0)}}
    return SmallCase(
        folder, bar, endTime, preset=DEFAULT, interfaces={
            "ground": {"side": ("bar", "left"), "obstacle": plane}},
        control={"maxCo": 0.3, "functions": functions,
                 "writeInterval": endTime/2})


def test_rows_and_filter(tmp_path, figures):
    """A row is written each thousandth of the run. Impulses do not depend on
    the rows. The same holds for the filtered force, whose integral is the
    impulse."""
    each = {"writeControl": "timeStep", "writeInterval": 1}
    case = falling(
        tmp_path,
        seldom=function("contactForces", filterFrequency=CUT_OFF),
        always=function("contactForces", filterFrequency=CUT_OFF, **each),
        one=function("contactForces", filterFrequency=CUT_OFF, filterPoles=1,
                     **each)).run()
    tables = {name: readResults.table(case.path, name, "ground.dat")
              for name in ("seldom", "always", "one")}
    seldom, always = tables["seldom"], tables["always"]
    with figures("rows of a run") as f:
        f.atLeast("rows of each step", len(always["Time"]), 1200)
        f.within("rows without being asked", len(seldom["Time"]), 1001, 1)
        at = np.searchsorted(always["Time"], seldom["Time"]*(1 - 1e-12))
        for key in ("bar.left:Fx", "bar.left:Ix", "bar.left:filteredFx"):
            f.equal(f"{key}, seldom", np.array_equal(
                seldom[key], always[key][at]), True)
        for name, poles in ("always", 2), ("one", 1):
            file = case.path/f"postProcessing/{name}/0/ground.dat"
            f.equal(f"what the filter is, {name}",
                    file.read_text().splitlines()[0],
                    "# filteredF: behind a causal low-pass filter, cut-off "
                    f"{CUT_OFF} Hz, poles {poles}")
        impulse = always["bar.left:Ix"][-1]
        f.within("impulse / momentum", impulse/(2*SPEED), 1, 0.02)
        for name in ("always", "one"):
            t, F = (tables[name][key] for key in (
                "Time", "bar.left:filteredFx"))
            f.within(f"integral of the filtered force, {name}",
                     np.trapezoid(F, t)/impulse, 1, 2e-3)
        # A rectangle of 2 s. Two poles overshoot by 4.3 %: a cosine with a
        # decaying amplitude, at the time sqrt(2) pi/omega
        omega = 2*np.pi*CUT_OFF
        F = always["bar.left:filteredFx"]
        top = F.argmax()
        f.within("filtered force at most / pressure of the wave",
                 F[top]/SPEED, 1 + np.exp(-np.pi), 0.01)
        f.within("and when", (always["Time"][top] - 0.05/SPEED)*omega,
                 np.sqrt(2)*np.pi, 0.05)


def test_restart_of_filter(tmp_path, figures):
    """The restarted filter is equal to the last bit."""
    case = falling(tmp_path, endTime=4, forces=function(
        "contactForces", filterFrequency=CUT_OFF))
    (_, a), (_, b) = runAgain(case, look=lambda case, _: readResults.table(
        case.path, "forces", "ground.dat"))
    with figures("filtered force after a restart") as f:
        f.atLeast("its magnitude / the pressure of the wave",
                  abs(a["bar.left:filteredFx"][-1])/SPEED, 0.01)
        f.equal("last rows differ in", [
            key for key in a if a[key][-1] != b[key][-1]], [])


@pytest.mark.parametrize("when", (
    {"executeInterval": 5},
    {"executeControl": "adjustableRunTime", "executeInterval": 0.01}),
    ids=("steps", "time"))
def test_filter_that_sees_some_steps(tmp_path, figures, when):
    """A filter that sees only some steps takes their whole time into
    account."""
    each = {"filterFrequency": CUT_OFF, "writeControl": "timeStep",
            "writeInterval": 20}
    case = falling(
        tmp_path, some=function("contactForces", **each, **when),
        every=function("contactForces", **each)).run()
    some, every = (readResults.table(case.path, name, "ground.dat")
                   for name in ("some", "every"))
    key = "bar.left:filteredFx"
    with figures(f"filter with {when}") as f:
        f.equal("rows", len(some["Time"]), len(every["Time"]))
        f.atMost("difference / largest", largest(some[key] - every[key])
                 / largest(every[key]), 0.02)


def test_restart_of_extremes(tmp_path, figures):
    """The row after a restart (here at 2.3, between rows at 1.2 and 2.4)
    includes the earlier steps."""
    most = []
    for stages in (2.4,), (1.1, 2.4):
        case = SmallCase(tmp_path/str(len(stages)), Body(
            (6, 6), sides={"bottom": condition(
                "fixedVelocity", velocity=(0, 0, 0))},
            velocity=lambda X: X*np.array((0, -0.2, 0))), 2.4,
            preset=DEFAULT, control={"writeInterval": 0.1, "functions": {
                "peaks": function("solidExtremes", everyStep="yes",
                                  fields="(sigmaEq pressure)",
                                  writeControl="adjustableRunTime",
                                  writeInterval=1.2)}})
        for end in stages:
            case.set("system/controlDict", {"endTime": end})
            case.run()
        t = readResults.table(case.path, "peaks", "extremes.dat")
        row = t["body:pressure:max"].argmax()
        most.append([t[f"body:pressure:max{c}"][row].item()
                     for c in ("", ":time", ":X", ":Y", ":x", ":y")])
    with figures("extremes after a restart") as f:
        f.atMost("time of the largest pressure", most[0][1], 1)
        f.equal("the same", most[1], most[0])


@pytest.mark.parametrize("ranks", (1, 2))
def test_rows_of_extremes_after_a_restart(tmp_path, figures, ranks):
    """Each row covers the steps since the previous row, as without the
    restart. The first row includes the steps of the earlier run, the next rows
    do not."""
    tables = []
    for stages in (2,), (1, 2):
        case = SmallCase(tmp_path/str(len(stages)), Body(
            (6, 6), sides={"bottom": condition(
                "fixedVelocity", velocity=(0, 0, 0))},
            velocity=lambda X: X*np.array((0, -0.2, 0))), 2,
            preset=DEFAULT, control={"writeInterval": 0.5, "functions": {
                "peaks": function("solidExtremes", everyStep="yes",
                                  fields="(sigmaEq pressure)",
                                  writeControl="writeTime")}})
        for end in stages:
            case.set("system/controlDict", {"endTime": end})
            if end == stages[0]:
                assert case.attempt(ranks)[0] == 0
            else:
                checked(solver(ranks), case.path)
        tables.append(readResults.table(case.path, "peaks", "extremes.dat"))
    a, b = tables
    with figures(f"rows of extremes after a restart, {ranks} ranks") as f:
        f.equal("times of rows", b["Time"].tolist(), a["Time"].tolist())
        f.equal("columns that differ", sum(
            not np.array_equal(a[key], b[key]) for key in a), 0)


@pytest.mark.parametrize("ranks", (2, 3))
def test_places_on_ranks(tmp_path, figures, ranks):
    """Of places that are equally near, or have the same value, the first by x,
    y, z is chosen, on any number of ranks."""
    points = ((9/16, 7/16, 0.5), (9/16, 0, 0), (1, 9/16, 0), (7/16, 0.5, 0))
    cases = []
    for n in 1, ranks:
        case = SmallCase(
            tmp_path/str(n), Body((8, 8), velocity=lambda X: 0.1*np.stack(
                (np.sin(3*X[:, 0] + X[:, 1]), np.cos(5*X[:, 0]), 0*X[:, 0]),
                1)), 0.5, preset=DEFAULT, probes={
                    f"p{i}": ("body", p) for i, p in enumerate(points)})
        case.set("system/controlDict", {"functions/least": {
            "type": "solidExtremes", "libs": ["vertexContact"],
            "fields": ["pointD"]}})
        assert case.attempt(n)[0] == 0
        cases.append(case)
    with figures(f"places on {ranks} ranks") as f:
        for i, p in enumerate(points):
            a, b = (np.array(c.probe(f"p{i}", "pointU")[1])[0] for c in cases)
            f.equal(f"velocity of {p} at the start", a.tolist(), b.tolist())
        first = [(c/"postProcessing/least/0/extremes.dat").read_text()
                 .splitlines()[1] for c in cases]
        f.equal("extremes of what is zero everywhere", *first)


def bending(folder, **functions):
    """A block whose displacement and velocity are linear in space."""
    def linear(X):
        return 1e-3*np.stack((X[:, 0] + 2*X[:, 1], 0*X[:, 0], X[:, 1]), axis=1)
    block = Body(cells=(5, 4, 3), name="block", material=ELASTIC,
                 size=(1, 2, 3), velocity=linear, displacement=linear,
                 sides={"top": "contact"})
    other = Body(cells=(2, 2, 2), name="other", material=ELASTIC,
                 start=(5, 5, 5))
    floor = {**FLOOR, "pointAndNormalDict": {
        "point": (0, 9, 0), "normal": (0, -1, 0)}}
    case = SmallCase(
        folder, (block, other), 0.3, preset=DEFAULT, interfaces={
            "roof": {"side": ("block", "top"), "obstacle": floor}},
        control={"functions": {
            name: function(kind, **more)
            for name, (kind, more) in functions.items()}})
    def made(name, kind, source, how):
        return (f"{{ name {name}; type {kind}; action new; source {source}; "
                f"{how}; }}")
    middle = "box (-9 0.99 -9) (9 1.01 9)"
    case.dictionary("system/block/topoSetDict", {"actions": (
        made("half", "cellSet", "boxToCell", "box (-9 -9 -9) (9 1 9)"),
        made("half", "cellZoneSet", "setToCellZone", "set half"),
        made("some", "pointSet", "boxToPoint", "box (-9 1.9 -9) (0.1 9 9)"),
        made("roof", "faceSet", "patchToFace", "patch top"),
        made("roof", "faceZoneSet", "setToFaceZone", "faceSet roof"),
        made("roof", "pointSet", "boxToPoint", "box (-9 1.9 -9) (9 9 9)"),
        made("inside", "faceSet", "boxToFace", middle),
        made("inside", "faceZoneSet", "setToFaceZone", "faceSet inside"),
        made("inside", "pointSet", "boxToPoint", middle))})
    checked(["topoSet", "-region", "block"], case.path)
    return case


@pytest.mark.parametrize("ranks", (1, 2))
def test_extremes_and_averages(tmp_path, figures, ranks):
    """For a linear field the extremes are those at corners, and the averages
    those in the middle, also for sets."""
    every = {"fields": "(pointD.x sigmaEq contactGap)", "region": "block"}
    case = bending(
        tmp_path,
        largest=("solidExtremes", {"fields": "(pointD pointU.x)",
                                   "region": '"b.*"'}),
        peaks=("solidExtremes", {**every, "everyStep": "yes"}),
        steps=("solidExtremes", {**every, "writeControl": "timeStep",
                                 "writeInterval": 1}),
        ends=("solidExtremes", {**every, "writeControl": "onEnd",
                                "everyStep": "yes"}),
        whole=("solidAverages", {"fields": "(pointD sigmaEq)"}),
        half=("solidAverages", {"fields": "(pointD.x)", "cellZone": "half"}),
        top=("solidAverages", {"fields": "(pointD)", "region": "block",
                               "patch": "top"}),
        some=("solidExtremes", {"fields": "(pointD.x)", "pointSet": "some"}))
    if ranks == 1:
        case.run()
    else:
        assert case.attempt(ranks)[0] == 0
    tables = {name: readResults.table(
        case.path, name, "averages.dat" if name in ("whole", "half", "top")
        else "extremes.dat")
        for name in ("largest", "steps", "peaks", "ends", "whole", "half",
                     "top", "some")}
    with figures(f"extremes and averages, {ranks} ranks") as f:
        first = {name: {key: values[0] for key, values in t.items()}
                 for name, t in tables.items()}
        f.within("largest |u|", first["largest"]["block:pointD.mag:max"],
                 1e-3*np.sqrt(29), 1e-15)
        f.equal("where", [first["largest"][f"block:pointD.mag:max:{c}"].item()
                          for c in "XYZ"][:2], [1, 2])
        f.within("and now", first["largest"]["block:pointD.mag:max:x"],
                 1.005, 1e-15)
        f.within("smallest velocity", first["largest"][
            "block:pointU.x:min"], 0, 1e-15)
        f.within("average", first["whole"]["block:pointD.x"], 2.5e-3, 1e-15)
        f.within("of half of it", first["half"]["block.half:pointD.x"],
                 1.5e-3, 1e-15)
        f.within("of a side", first["top"]["block.top:pointD.z"], 2e-3, 1e-15)
        f.within("smallest of a set", first["some"][
            "block.some:pointD.x:min"], 4e-3, 1e-15)
        f.equal("others", max(tables["whole"]["other:sigmaEq"]), 0)
        key = "block:sigmaEq:max"
        f.equal("largest of all steps", tables["ends"][key][-1],
                max(tables["steps"][key][1:]))
        f.equal("and when", tables["ends"][f"{key}:time"][-1],
                tables["steps"]["Time"][1:][
                    tables["steps"][key][1:].argmax()])
        f.equal("rows hold steps in between", max(tables["peaks"][key]),
                max(tables["steps"][key]))


@pytest.mark.parametrize("ranks", (1, 2))
def test_face_zones(tmp_path, figures, ranks):
    """A faceZone gives the same as the patch with its faces and the set of its
    points. One zone is on the surface and one inside the block, at the start
    and later."""
    fields = {"fields": "(pointD sigmaEq pointU.y)", "region": "block",
              "writeControl": "timeStep"}
    places = {"zone": ("faceZone", "roof"), "patch": ("patch", "top"),
              "points": ("pointSet", "roof"), "zoneInside": (
                  "faceZone", "inside"), "pointsInside": ("pointSet", "inside")}
    case = bending(tmp_path, **{
        f"{what}{name}": (f"solid{what}", {**fields, kind: of})
        for what in ("Extremes", "Averages")
        for name, (kind, of) in places.items()})
    if ranks == 1:
        case.run()
    else:
        assert case.attempt(ranks)[0] == 0

    def columns(what, name):
        """Columns of the table as one array, without the names of the sets."""
        t = readResults.table(case.path, f"{what}{name}",
                              f"{what.lower()}.dat")
        return t, np.array(list(t.values()))
    with figures(f"extremes and averages of faceZones, {ranks} ranks") as f:
        first, _ = columns("Averages", "zoneInside")
        f.within("average inside", first["block.inside:pointD.x"][0], 2.5e-3,
                 1e-15)
        f.within("average on the surface", columns("Averages", "zone")[0][
            "block.roof:pointD.x"][0], 4.5e-3, 1e-15)
        f.atLeast("rows", len(first["Time"]), 5)
        for what in "Extremes", "Averages":
            for zone, others in (("zone", ("patch", "points")),
                                 ("zoneInside", ("pointsInside",))):
                _, a = columns(what, zone)
                for other in others:
                    _, b = columns(what, other)
                    # Points are weighted by volumes, which are in proportion
                    # to areas
                    f.atMost(f"{what} of {zone} - of {other}", largest(a - b),
                             0 if what == "Extremes" else 1e-15)


def test_rows_of_every_function_object(tmp_path, figures):
    """Each function object writes a row at each thousandth of the run, or as
    its writeControl says, and one at the start (for contact, a row of the
    first step); none before timeStart."""
    endTime, interval = 14.0, 0.7
    controls = {
        "default": {}, "each": {"writeControl": "timeStep"},
        "late": {"writeControl": "timeStep", "timeStart": endTime/2},
        "seventh": {"writeControl": "timeStep", "writeInterval": 7},
        "interval": {"writeControl": "runTime", "writeInterval": interval},
        "fields": {"writeControl": "writeTime"},
        "end": {"writeControl": "onEnd"}}
    kinds = {
        "solidEnergies": ({}, ("energies.dat", "momentum.dat")),
        "pointProbes": ({"points": ((0.05, 0, 0),), "fields": "(pointU J)"},
                        ("pointU", "J")),
        "reactionForces": ({}, ("reactions.dat",)),
        "solidAverages": ({"fields": "(pointD)"}, ("averages.dat",)),
        "solidExtremes": ({"fields": "(pointD)"}, ("extremes.dat",)),
        "contactForces": ({}, ("ground.dat",))}
    case = falling(
        tmp_path, endTime, sides={"right": condition(
            "fixedVelocity", velocity=(-SPEED/10, 0, 0))},
        **{f"{kind}-{control}": function(kind, **more, **when)
           for kind, (more, _) in kinds.items()
           for control, when in controls.items()}).run()

    def times(kind, control, file):
        if kind == "pointProbes":
            return case.probe(f"{kind}-{control}", file)[0]
        return readResults.table(case.path, f"{kind}-{control}", file)["Time"]
    t = times("solidEnergies", "each", "energies.dat")
    step = np.diff(t, prepend=0)
    part = np.floor(1000*t/endTime + 1e-6)
    # Within half a step of the wanted instants, as in OpenFOAM
    passed = np.floor((t + 0.5*step)/interval)
    rows = {"default": t[np.diff(part, prepend=-1) > 0], "each": t,
            "seventh": t[::7], "interval": t[np.diff(passed, prepend=-1) > 0],
            "late": t[t + 0.5*step > endTime/2],
            "fields": endTime*np.array((0, 0.5, 1)),
            "end": endTime*np.array((0, 1))}
    with figures("rows of every function object") as f:
        f.atLeast("steps", len(t), 2000)
        for control, expected in rows.items():
            f.equal(f"rows, {control}", {
                "default": 1001, "interval": 21}.get(control, len(expected)),
                len(expected))
            other = []
            for kind, (_, files) in kinds.items():
                wanted = expected
                if kind == "contactForces":
                    first = t[1:2] if control == "default" else []
                    wanted = expected if control == "late" else (
                        np.concatenate((first, expected[1:])))
                for file in files:
                    found = times(kind, control, file)
                    if (len(found) != len(wanted)
                            or largest(found - wanted) > 1e-9):
                        other.append(f"{kind}: {file}")
            f.equal(f"tables with other rows, {control}", other, [])


def test_other_columns_after_a_restart(tmp_path, figures):
    """A run goes on with damping: its table of energies gets new columns."""
    body = Body((4, 4), velocity=lambda X: 0.01*X)
    case = SmallCase(tmp_path, body, 2, preset="balanced").run()
    before = readResults.table(tmp_path, "solidEnergies", "energies.dat")
    case.set("system/controlDict", {
        "endTime": 4, "damping": {"body": {"coefficient": 0.1}}})
    case.run()
    joined = readResults.table(tmp_path, "solidEnergies", "energies.dat")
    t = joined["Time"]
    new = [key for key in joined if key not in before]
    kinetic = before["total:kinetic"]
    with figures("energies of a run that goes on with damping") as f:
        f.equal("names of damping", all("amping" in key for key in new), True)
        f.atLeast("new columns", len(new), 1)
        f.equal("values before the restart, whose own row counts",
                bool((joined["total:kinetic"][:len(kinetic) - 1]
                      == kinetic[:-1]).all()), True)
        for key in new:
            known = np.isfinite(joined[key])
            f.equal(f"{key} is known after the restart",
                    bool((known == (t >= before["Time"][-1])).all()), True)
