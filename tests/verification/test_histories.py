"""Histories: how many rows there are, what they lose, the filtered force of
contact, largest values and averages."""

import shutil

import numpy as np

import readResults
from caseTools import DEFAULT, Case, checked, timeFolders
from smallCases import ELASTIC, FLOOR, Body, SmallCase

SPEED, CUT_OFF = 0.1, 0.5


def function(name, **more):
    return {"type": name, "libs": "(vertexContact)", **more}


def falling(folder, endTime=12, n=40, **functions):
    """A bar that hits a plane, and leaves it after 2 s. c_p = 1."""
    bar = Body(cells=(n,), name="bar", material=ELASTIC, velocity=(-SPEED, 0, 0),
               start=(0.05, 0, 0), sides={"left": "contact"})
    plane = {**FLOOR, "pointAndNormalDict": {
        "point": (0, 0, 0), "normal": (1, 0, 0)}}
    return SmallCase(
        folder, bar, endTime, preset=DEFAULT, interfaces={
            "ground": {"side": ("bar", "left"), "obstacle": plane}},
        control={"maxCo": 0.3, "functions": functions,
                 "writeInterval": endTime/2})


def test_rows_and_filter(tmp_path, figures):
    """A row each thousandth of the run; impulses do not depend on the rows,
    nor does the filtered force, whose integral is the impulse."""
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
        impulse = always["bar.left:Ix"][-1]
        f.within("impulse / momentum", impulse/(2*SPEED), 1, 0.02)
        for name in ("always", "one"):
            t, F = (tables[name][key] for key in (
                "Time", "bar.left:filteredFx"))
            f.within(f"integral of the filtered force, {name}",
                     np.trapezoid(F, t)/impulse, 1, 2e-3)
        # A rectangle of 2 s: two poles swing over by 4.3 %, a cosine of a
        # decaying amplitude, at the time sqrt(2) pi/omega
        omega = 2*np.pi*CUT_OFF
        F = always["bar.left:filteredFx"]
        top = F.argmax()
        f.within("filtered force at most / pressure of the wave",
                 F[top]/SPEED, 1 + np.exp(-np.pi), 0.01)
        f.within("and when", (always["Time"][top] - 0.05/SPEED)*omega,
                 np.sqrt(2)*np.pi, 0.05)


def test_restart_of_filter(tmp_path, figures):
    """To the last bit."""
    straight = falling(
        tmp_path/"straight", endTime=4,
        forces=function("contactForces", filterFrequency=CUT_OFF)).run()
    case = Case(shutil.copytree(straight.path, tmp_path/"case"))
    shutil.rmtree(case/"postProcessing")
    times = timeFolders(case.path)
    shutil.rmtree(case/times[-1])
    checked(["vertexContactFoam"], case.path)
    a, b = (readResults.table(c.path, "forces", "ground.dat")
            for c in (straight, case))
    with figures("filtered force after a restart") as f:
        f.atLeast("its magnitude / the pressure of the wave",
                  abs(a["bar.left:filteredFx"][-1])/SPEED, 0.01)
        f.equal("last rows differ in", [
            key for key in a if a[key][-1] != b[key][-1]], [])
