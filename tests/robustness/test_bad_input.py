"""Wrong input: one clear message, an exit code, and no time step."""

import re
import shutil

import pytest

from vertexContactTests import caseTools
from vertexContactTests.caseTools import Case, Scene, execute, timeFolders
from vertexContactTests.smallCases import Body, SmallCase, interface


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    """A meshed case that has not run yet."""
    case = Scene(elements=8).prepare(tmp_path_factory.mktemp("good"))
    shutil.copytree(case/"0.orig", case/"0")
    (case/"system"/"caseParameters").write_text("nElements 8;\n")
    case.set("system/controlDict", {
        "endTime": 0.01, "writeInterval": 0.01, "writeFormat": "ascii"})
    for bar in "bar1", "bar2":
        caseTools.checked(["blockMesh", "-region", bar], case.path)
    return case


material = "constant/bar1/mechanicalProperties"
schemes = "system/bar1/fvSchemes"
contact = "constant/contactProperties"
velocity = "0/bar1/pointU"


def edit(file, entries):
    return lambda case: case.set(file, entries)


def replace(file, pattern, by):
    return lambda case: case.replace(file, pattern, by)


def remove(file):
    def action(case):
        path = case/file
        shutil.rmtree(path) if path.is_dir() else path.unlink()
    return action


def rewrite(file, contents):
    return lambda case: (case/file).write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; "
        f"object {file.split('/')[-1]}; }}\n{contents}\n")


def force(contents):
    """A body force of bar 1."""
    return rewrite("constant/bar1/bodyForces", contents)


def paper(*actions):
    """Use the paper's scheme."""
    def action(case):
        case.set("system/controlDict", {"preset": "paper"})
        for act in actions:
            act(case)
    return action


def field(name, kind, dimensions, value):
    """Give bar 1 a point field at the start."""
    return lambda case: (case/f"0/bar1/{name}").write_text(
        f"FoamFile {{ version 2.0; format ascii; class point{kind}Field; "
        f"object {name}; }}\ndimensions [{dimensions}];\n"
        f"internalField uniform {value};\nboundaryField {{ "
        "\".*\" { type empty; } "
        "\"(left|right)\" { type calculated; } }\n")


def all_of(*actions):
    def action(case):
        for act in actions:
            act(case)
    return action


def plastic(hardening):
    """Give bar 1 a plastic material."""
    return rewrite(material, f"type HenckyVonMises; rho 1; E 1; nu 0; "
                             f"{hardening}")


PLANE = ("type plane; planeType pointAndNormal; "
         "pointAndNormalDict { point (30 0 0); normal (-1 0 0); }")


def obstacle(shape, more="", side="(bar2 left)"):
    """Add an obstacle beside the interface of the bars."""
    shape = "" if shape is None else f"obstacle {{ {shape} }}"
    return replace(contact, r"interfaces\s*\{",
                   f"interfaces {{ wall {{ side {side}; {shape} {more} }}")


def invertCell(case):
    """Put the second node of bar 2 behind its first node."""
    case.replace("constant/bar2/polyMesh/points",
                 r"\(11\.26 ", "(9.9 ")


def control(contents):
    """Add entries to controlDict."""
    return replace("system/controlDict", r"functions\s*\{",
                   f"{contents}\nfunctions {{")


def history(name, contents):
    """Add a function object."""
    return replace("system/controlDict", r"functions\s*\{", (
        f"functions {{ mine {{ type {name}; libs (vertexContact); "
        f"{contents} }}"))


def held(contents):
    """Change the condition on the far side of bar 1."""
    return replace(velocity, r"left\s*\{[^}]*\}", f"left {{ {contents} }}")


# The fault, the change that makes it, and the words that the message must have
CASES = {
    "component of a velocity": (
        held("type fixedVelocity; velocity (0 0 0); components (x w);"),
        ("pointU", "components", "'w'", "(x y z)")),
    "component that is left out": (
        held("type fixedVelocity; velocity (0 0 0); components (y);"),
        ("pointU", "left", "components", "(x)")),
    "components twice": (
        held("type fixedVelocity; velocity (0 0 0); components (x x);"),
        ("pointU", "components", "'x'", "twice")),
    "components and direction": (
        held("type fixedDisplacement; displacement 0; direction (1 0 0); "
             "components (x);"),
        ("pointU", "components", "direction", "exclude")),
    "direction without length": (
        held("type fixedDisplacement; displacement 0; direction (0 0 0);"),
        ("pointU", "direction", "(0 0 0)", "above 0")),
    "displacement that is missing": (
        held("type fixedDisplacement; velocity (0 0 0);"),
        ("pointU", "velocity", "displacement")),
    "displacement that jumps": (
        held("type fixedDisplacement; displacement (0.1 0 0);"),
        ("pointU", "left", "displacement", "(0.1 0 0)", "jump")),
    "displacement in the paper's scheme": (
        paper(held("type fixedDisplacement; displacement (0 0 0);")),
        ("pointU", "left", "fixedDisplacement", "preset paper")),
    "reactions of nothing": (
        history("reactionForces", ""),
        ("controlDict", "mine", "reactionForces", "fixedVelocity")),
    "frequency of a filter": (
        history("contactForces", "filterFrequency -3;"),
        ("controlDict", "filterFrequency", "-3", "positive")),
    "poles of a filter": (
        history("contactForces", "filterFrequency 3; filterPoles 4;"),
        ("controlDict", "filterPoles", "4", "1 or 2")),
    "field of extremes": (
        history("solidExtremes", "fields (sigmaQ);"),
        ("controlDict", "fields", "sigmaQ", "sigmaEq")),
    "component of extremes": (
        history("solidExtremes", "fields (pointD.xx);"),
        ("controlDict", "fields", "pointD.xx", "mag")),
    "region of averages": (
        history("solidAverages", "fields (pointD); region bar3;"),
        ("controlDict", "region", "bar3", "bar1")),
    "patch of averages": (
        history("solidAverages", "fields (pointD); patch rihgt;"),
        ("controlDict", "patch", "rihgt", "right")),
    "region of averages that is one of two": (
        history("solidAverages", "fields (pointD); region (bar1 bar3);"),
        ("controlDict", "region", "bar3", "bar1")),
    "no region of averages": (
        history("solidAverages", "fields (pointD); region ();"),
        ("controlDict", "'region' is ()", "(bar1 bar2)")),
    "no fields of extremes": (
        history("solidExtremes", "fields ();"),
        ("controlDict", "'fields' is ()", "sigmaEq")),
    **{f"field of {name} twice": (
        history(name, "fields (sigmaEq pointD.x sigmaEq);"),
        ("controlDict", "fields", "'sigmaEq' twice"))
       for name in ("solidExtremes", "solidAverages")},
    "a field, and one of its components": (
        history("solidAverages", "fields (sigma sigma.xx);"),
        ("controlDict", "fields", "'sigma.xx' twice")),
    **{f"broken expression of {what}": (
        history("solidAverages", f"fields (sigmaEq); region {region};"),
        ("controlDict", "'region'", "regular expression", "bar["))
       for what, region in (("a region", '"bar["'),
                            ("regions", '(bar1 "bar[")'))},
    "field of probes twice": (
        history("pointProbes",
                "region bar1; fields (pointU pointD pointU); "
                "points ((0 0 0));"),
        ("controlDict", "fields", "'pointU' twice")),
    "no fields of probes": (
        history("pointProbes", "region bar1; fields (); points ((0 0 0));"),
        ("controlDict", "'fields' is ()", "sigmaEq")),
    "no points of probes": (
        history("pointProbes", "region bar1; fields (pointU); points ();"),
        ("controlDict", "'points' is ()", "((0 0 0))")),
    "two sets": (
        history("solidAverages", "fields (pointD); patch left; cellZone a;"),
        ("controlDict", "patch", "cellZone", "one of them")),
    "poles without a filter": (
        history("contactForces", "filterPoles 2;"),
        ("controlDict", "filterPoles", "filterFrequency")),
    "keyword of a material": (
        edit(material, {"Young": 3}), ("mechanicalProperties", "Young")),
    "keyword of vertexCentred": (
        edit(schemes, {"vertexCentred/limitter": "none"}),
        ("fvSchemes", "vertexCentred", "limitter", "correction")),
    "keyword of the paper's scheme": (
        paper(edit(schemes, {"vertexCentred/limitter": "none"})),
        ("fvSchemes", "vertexCentred", "limitter", "limiter")),
    "keyword that belongs to the paper's scheme": (
        edit(schemes, {"vertexCentred/limiter": "none"}),
        ("fvSchemes", "limiter", "preset paper", "correction")),
    "keyword that does not belong to the paper's scheme": (
        paper(edit(schemes, {"vertexCentred/correction": 0})),
        ("fvSchemes", "correction", "preset paper", "limiter")),
    "keyword of an interface": (
        edit(contact, {"interfaces/bars/paring": "AMI"}),
        ("contactProperties", "paring", "pairing")),
    "keyword of a contact law": (
        edit(contact, {"interfaces/bars/law/friction": 0.3}),
        ("contactProperties", "friction")),
    **{f"{keyword} that is no dictionary": (
        plastic(f"{more} {keyword} 5;"),
        ("mechanicalProperties", f"'{keyword}' is not a dictionary", example))
       for keyword, more, example in (
        ("JohnsonCook", "", "A 9e7;"),
        ("adiabaticHeating", "tauY 1;", "cp 385;"))},
    "vertexCentred that is no dictionary": (
        rewrite(schemes, "vertexCentred 5;"),
        ("fvSchemes", "'vertexCentred' is not a dictionary", "cells")),
    "obstacle that is no dictionary": (
        obstacle(None, "obstacle plane;"),
        ("contactProperties", "'obstacle' is not a dictionary", "sphere")),
    "motion that is no dictionary": (
        obstacle(PLANE, "motion still;"),
        ("contactProperties", "'motion' is not a dictionary", "velocity")),
    "obstacle that OpenFOAM refuses": (
        obstacle(PLANE.replace("(-1 0 0)", "(0 0 0)")),
        ("contactProperties.interfaces.wall.obstacle", "plane",
         "zero length")),
    **{f"table of a {name}": (
        action, (file, f"Keyword '{name}'", "out-of-order"))
       for name, file, action in (
        ("velocity", "pointU.boundaryField.left",
         held("type fixedVelocity; "
              "velocity table ((0 (0 0 0)) (2 (0 0 0)) (1 (0 0 0)));")),
        ("displacement", "contactProperties.interfaces.wall.motion",
         obstacle(PLANE, "motion { displacement table ((1 (0 0 0)) "
                         "(0 (0 0 0))); }")),
        ("hardeningCurve", "mechanicalProperties",
         plastic("hardeningCurve table ((0 1) (2 2) (1 3));")))},
    "dimensions after a name": (
        replace(material, r"\brho\s[^;]*;", "rho rho [0 1 0 0 0 0 0] 1;"),
        ("mechanicalProperties", "'rho'", "[1 -3 0 0 0 0 0]")),
    "keyword of a boundary condition": (
        replace(velocity, r"tractionFree;", "tractionFree; preasure 3;"),
        ("pointU", "preasure")),
    "unknown material": (
        edit(material, {"type": "neoHokean"}),
        ("mechanicalProperties", "neoHokean", "neoHookean")),
    "unknown reconstruction": (
        paper(edit(schemes, {"vertexCentred/reconstruction": "quadratic"})),
        ("fvSchemes", "quadratic", "full")),
    "unknown volume": (
        edit(schemes, {"vertexCentred/volume": "smooth"}),
        ("fvSchemes", "volume", "smooth", "smoothed")),
    "correction too large": (
        edit(schemes, {"vertexCentred/correction": 0.6}),
        ("fvSchemes", "correction", "0.6", "0.5")),
    "less dissipation at fronts than elsewhere": (
        edit(schemes, {"vertexCentred/frontDissipation": 0.2}),
        ("fvSchemes", "frontDissipation", "0.2", "0.25")),
    "unknown cells": (
        edit(schemes, {"vertexCentred/cells": "simplical"}),
        ("fvSchemes", "simplical", "simplicial")),
    "interface that is there twice": (
        replace(contact, r"interfaces\s*\{", "interfaces { again { sides ("
                "(bar2 left) (bar1 right)); pairing nearestFace; }"),
        ("contactProperties", "'again' and 'bars'", "'sides'")),
    **{f"obstacle that is there twice{how}": (
        all_of(obstacle(PLANE, f"}} {first} {{ side (bar2 left); "
                               f"obstacle {{ {PLANE} }}", side=side)),
        ("contactProperties", first, "wall", "'obstacle'", "twice"))
       for how, first, side in (
        ("", "floor", "(bar2 left)"),
        (", by an expression", "floor", '("bar2" "le.*")'))},
    "unknown pairing": (
        edit(contact, {"interfaces/bars/pairing": "matchin"}),
        ("contactProperties", "matchin", "matching")),
    "unknown contact law": (
        edit(contact, {"interfaces/bars/law/type": "frictionles"}),
        ("contactProperties", "frictionles", "frictionless")),
    "unknown boundary condition": (
        replace(velocity, "tractionFree", "tractionfree"),
        ("pointU", "tractionfree", "tractionFree")),
    "unknown body force": (
        force("wind { type unifrom; acceleration (1 0 0); }"),
        ("bodyForces", "wind", "unifrom", "uniform")),
    "keyword of a body force": (
        force("wind { type uniform; accelleration (1 0 0); }"),
        ("bodyForces", "wind", "accelleration", "acceleration")),
    "body force without its value": (
        force("wind { type uniform; }"),
        ("bodyForces", "wind", "acceleration")),
    "body force that is no dictionary": (
        force("wind (1 0 0);"), ("bodyForces", "wind")),
    "missing density": (
        replace(material, r"rho .*\n", "\n"), ("mechanicalProperties", "rho")),
    "missing boundary condition": (
        replace(velocity, r"left\s*\{[^}]*\}", ""), ("pointU", "left")),
    "interface without a contact patch": (
        replace(velocity, r"contact;", "tractionFree;"),
        ("bar1", "right", "contact")),
    "unknown patch": (
        replace(contact, r"\(bar1 right\)", "(bar1 rihgt)"),
        ("contactProperties", "rihgt")),
    "unknown region of an interface": (
        replace(contact, r"\(bar1 right\)", "(bar3 right)"),
        ("contactProperties", "bar3")),
    "region without a mesh": (
        replace("constant/regionProperties", "bar2", "bar3"), ("bar3",)),
    "negative density": (
        edit(material, {"rho": -0.01}),
        ("mechanicalProperties", "rho", "-0.01")),
    "zero density": (
        edit(material, {"rho": 0}), ("mechanicalProperties", "rho")),
    "Poisson's ratio of 0.5": (
        edit(material, {"nu": 0.5}), ("mechanicalProperties", "nu", "0.5")),
    "Poisson's ratio above 0.5": (
        edit(material, {"nu": 0.7}), ("mechanicalProperties", "nu", "0.7")),
    "negative stiffness": (
        edit(material, {"E": -100}), ("mechanicalProperties", "E", "-100")),
    "dimensions of the density": (
        replace(material, r"rho  ", "rho [0 1 -1 0 0 0 0] "),
        ("mechanicalProperties", "rho")),
    "not a number": (
        replace(material, r"E( +)100", r"E\g<1>stiff"),
        ("mechanicalProperties", "E", "stiff")),
    "the same side twice": (
        replace(contact, r"\(bar2 left\)", "(bar1 right)"),
        ("contactProperties", "bar1", "right")),
    "unknown transfer": (
        edit(contact, {"interfaces/bars/transfer": "twoway"}),
        ("contactProperties", "twoway", "twoWay")),
    "keyword of another pairing": (
        edit(contact, {"interfaces/bars/updateDistance": 0.1}),
        ("contactProperties", "updateDistance")),
    "update distance too long": (
        edit(contact, {"interfaces/bars/pairing": "nearestFace",
                       "interfaces/bars/updateDistance": 3}),
        ("contactProperties", "updateDistance", "3", "0.4")),
    "unknown obstacle": (
        obstacle("type plan;"), ("contactProperties", "plan", "plane")),
    "obstacle without a shape": (
        obstacle("radius 3;"), ("contactProperties", "obstacle", "type")),
    "obstacle that is a point": (
        obstacle("type box; min (2 0 0); max (2 0 0);"),
        ("contactProperties.interfaces.wall.obstacle", "box is a point",
         "bounding box")),
    **{f"{shape.split()[0]} of radius {radius}": (
        obstacle(f"type {shape} radius {radius};"),
        ("contactProperties.interfaces.wall.obstacle",
         f"'radius' is {radius}", "positive"))
       for shape in ("sphere; centre (2 0 0);",
                     "disk; origin (2 0 0); normal (1 0 0);",
                     "cylinder; point1 (2 0 0); point2 (2 0 1);")
       for radius in (0, -1)},
    "cylinder without length": (
        obstacle("type cylinder; point1 (2 0 0); point2 (2 0 0); radius 1;"),
        ("contactProperties.interfaces.wall.obstacle", "'point1'", "'point2'",
         "(2 0 0)")),
    "plane that is normal to the mesh": (
        obstacle(PLANE.replace("(-1 0 0)", "(0 2 0)")),
        ("contactProperties.interfaces.wall.obstacle", "(0 1 0)", "bar2")),
    "keyword beside an obstacle": (
        obstacle(PLANE, "pairing AMI;"), ("contactProperties", "pairing")),
    "unknown side of an obstacle": (
        obstacle(PLANE, side="(bar1 rihgt)"), ("contactProperties", "rihgt")),
    "side without an obstacle": (
        obstacle(None), ("contactProperties", "obstacle")),
    "no yield stress": (
        plastic("Hardening 1;"), ("mechanicalProperties", "tauY",
                                  "hardeningCurve", "JohnsonCook")),
    "two yield stresses": (
        plastic("tauY 1; hardeningCurve constant 1;"),
        ("mechanicalProperties", "tauY", "exactly one")),
    "negative yield stress": (
        plastic("tauY -3;"), ("mechanicalProperties", "tauY", "-3")),
    "misspelt hardening": (
        plastic("tauY 1; hardening 0;"),
        ("mechanicalProperties", "hardening", "Hardening")),
    "Hardening beside a curve": (
        plastic("hardeningCurve table ((0 1) (1 2)); Hardening 1;"),
        ("mechanicalProperties", "Hardening", "tauY")),
    "last strain of a table": (
        plastic("hardeningCurve table ((0 1) (1 2)); maxStrain -1;"),
        ("mechanicalProperties", "maxStrain", "-1", "positive")),
    "falling hardening curve": (
        plastic("hardeningCurve table ((0 2) (1 1.5));"),
        ("mechanicalProperties", "hardeningCurve", "1.5")),
    "hardening curve that begins late": (
        plastic("hardeningCurve table ((0.1 1) (1 2));"),
        ("mechanicalProperties", "hardeningCurve", "0.1")),
    "keyword of Johnson and Cook": (
        plastic("JohnsonCook { A 1; B 1; n 1; C 0; k 1; }"),
        ("mechanicalProperties", "JohnsonCook", "k")),
    "softening without a melting point": (
        plastic("JohnsonCook { A 1; B 1; n 1; C 0; m 1; }"),
        ("mechanicalProperties", "JohnsonCook", "Tmelt")),
    "softening without heat": (
        plastic("JohnsonCook { A 1; B 1; n 1; C 0; m 1; Tmelt 1300; }"),
        ("mechanicalProperties", "'m' 1", "adiabaticHeating")),
    "melting point without softening": (
        plastic("JohnsonCook { A 1; B 1; n 1; C 0; Tmelt 1300; }"),
        ("mechanicalProperties", "Tmelt", "'m'")),
    "heat without a specific heat": (
        plastic("tauY 1; adiabaticHeating { beta 0.9; }"),
        ("mechanicalProperties", "adiabaticHeating", "cp")),
    "more heat than work": (
        plastic("tauY 1; adiabaticHeating { beta 1.1; cp 400; }"),
        ("mechanicalProperties", "beta", "1.1", "from 0 to 1")),
    **{f"{name} of {kind}": (
        all_of(rewrite(material, f"type {kind}; rho 1; {law}"),
               field(name, "Scalar", dimensions, value)),
        (f"bar1/{name}", kind, "bar1", meant))
       for name, dimensions, value, meant in (
        ("epsilonPEq", "0 0 0 0 0 0 0", 0.1, "only HenckyVonMises"),
        ("pointT", "0 0 0 1 0 0 0", 300, "only with adiabaticHeating"))
       for kind, law in (("neoHookean", "E 1; nu 0;"), ("rigid", ""),
                         ("HenckyVonMises", "E 1; nu 0; tauY 1;"))
       if (name, kind) != ("epsilonPEq", "HenckyVonMises")},
    "below absolute zero": (
        all_of(plastic("tauY 1; adiabaticHeating { cp 400; }"),
               field("pointT", "Scalar", "0 0 0 1 0 0 0", -20)),
        ("pointT", "internalField", "-20", "positive")),
    "melting point below the room": (
        plastic("JohnsonCook { A 1; B 1; n 1; C 0; m 1; Tmelt 200; } "
                "adiabaticHeating { cp 400; }"),
        ("mechanicalProperties", "Tmelt", "200", "above Troom")),
    "melted at first": (
        plastic("JohnsonCook { A 1; B 1; n 1; C 0; m 1; Tmelt 200; Troom 20; } "
                "adiabaticHeating { cp 400; }"),
        ("mechanicalProperties", "Tmelt", "200", "above T0")),
    "Johnson and Cook without A": (
        plastic("JohnsonCook { B 1; n 1; C 0; }"),
        ("mechanicalProperties", "JohnsonCook", "A")),
    "dimensions of the velocity": (
        replace(velocity, r"\[0 1 -1 0 0 0 0\]", "[0 1 0 0 0 0 0]"),
        ("pointU", "dimensions")),
    "contact patch without an interface": (
        replace(contact, r"(?s)interfaces.*", "interfaces {}\n"),
        ("bar1", "right", "contact")),
    "missing velocity": (remove(velocity), ("pointU", "bar1")),
    "missing material": (remove(material), ("mechanicalProperties",)),
    "missing contactProperties": (remove(contact), ("contactProperties",)),
    "inverted cell": (invertCell, ("bar2",)),
    "steps of their own with the paper's scheme": (
        edit("system/controlDict", {"preset": "paper", "subCycling": "yes"}),
        ("controlDict", "subCycling", "yes", "paper", "(leapfrog)")),
    "no steps in a common one": (
        edit("system/controlDict", {"subCycling": "yes", "maxSubCycles": 0}),
        ("controlDict", "maxSubCycles", "0", "positive")),
    "subCycling that is no switch": (
        edit("system/controlDict", {"subCycling": "often"}),
        ("controlDict", "subCycling", "often")),
    "unknown preset": (
        edit("system/controlDict", {"preset": "quick"}),
        ("controlDict", "preset", "quick", "fast", "accurate")),
    "unknown time integrator": (
        edit("system/controlDict", {"timeIntegrator": "TVDRK4"}),
        ("controlDict", "timeIntegrator", "TVDRK4", "TVDRK3")),
    "one stage with full reconstruction": (
        paper(edit("system/controlDict",
                   {"timeIntegrator": "symplecticEuler"})),
        ("controlDict", "timeIntegrator", "symplecticEuler", "full")),
    "time integrator of the paper": (
        edit("system/controlDict", {"timeIntegrator": "TVDRK2"}),
        ("controlDict", "timeIntegrator", "TVDRK2", "leapfrog")),
    "leapfrog with the paper's scheme": (
        paper(edit("system/controlDict", {"timeIntegrator": "leapfrog"})),
        ("controlDict", "timeIntegrator", "leapfrog", "TVDRK2")),
    "transfer of the paper": (
        edit(contact, {"interfaces/bars/pairing": "AMI",
                       "interfaces/bars/transfer": "twoWay"}),
        ("contactProperties", "transfer", "twoWay", "paper")),
    "no dissipation": (
        edit(schemes, {"vertexCentred/dissipation": 0}),
        ("fvSchemes", "dissipation", "0", "at most 1")),
    "unknown wave speed": (
        paper(edit(schemes, {"vertexCentred/waveSpeed": "nonlinear"})),
        ("fvSchemes", "waveSpeed", "nonlinear", "stretched")),
    "keyword of controlDict": (
        edit("system/controlDict", {"masScalling": 1e-7}),
        ("controlDict", "masScalling", "massScaling")),
    "keyword of controlDict, another case": (
        edit("system/controlDict", {"maxCO": 0.3}),
        ("controlDict", "maxCO", "maxCo")),
    **{f"{keyword}, which is ours in no release": (
        edit("system/controlDict", {keyword: value}),
        ("controlDict", f"'{keyword}'", f"Did you mean '{meant}'?",
         "contactIterations"))
       for keyword, value, meant in (
        ("massScale", 1e-7, "massScaling"),
        ("massScalingFactor", 10, "massScaling"),
        ("dampingFactor", 0.1, "damping"),
        ("kineticRelaxation", "yes", "relaxation"),
        ("subCycles", 10, "subCycling"),
        ("maxCourant", 0.5, "maxCo"),
        ("energyRise", 0.01, "maxEnergyRise"),
        ("writeIntervals", 0.01, "writeInterval"))},
    "keyword of controlDict like none": (
        edit("system/controlDict", {"hourglass": 0.1}),
        ("controlDict", "'hourglass'", "massScaling", "$hourglass")),
    "keyword of another program": (
        edit("system/controlDict", {"maxAlphaCo": 0.1}),
        ("controlDict", "'maxAlphaCo'", "maxCo")),
    "variable of a file whose include is a comment": (
        all_of(control('hourglass 0.1; // #include "shared"\n'),
               rewrite("system/shared", "maxEnergyRise $hourglass;")),
        ("controlDict", "'hourglass'")),
    "variable that is part of another one": (
        control("hour 0.1; hourglass 1; logInterval $hourglass;"),
        ("controlDict", "'hour'")),
    "misspelt keyword of an included file": (
        all_of(control('#include "shared"'),
               rewrite("system/shared", "maxCoo 0.1; radius 3;")),
        ("controlDict", "'maxCoo'", "maxCo")),
    "interval of no length": (
        edit("system/controlDict", {"writeControl": "runTime",
                                    "writeInterval": -1}),
        ("controlDict", "writeInterval", "-1", "positive")),
    "longest step of no length": (
        edit("system/controlDict", {"maxDeltaT": 0}),
        ("controlDict", "maxDeltaT", "0", "positive")),
    **{f"fixed step of {step} s": (
        edit("system/controlDict", {"adjustTimeStep": False, "deltaT": step}),
        ("controlDict", "deltaT", str(step), "positive"))
       for step in (0, -0.1)},
    "mass scaling that is a number": (
        edit("system/controlDict", {"massScaling": 1e-7}),
        ("controlDict", "massScaling", "dictionary")),
    "relaxation that is a word": (
        edit("system/controlDict", {"relaxation": "kinetic"}),
        ("controlDict", "relaxation", "dictionary")),
    "interval that is a word": (
        edit("system/controlDict", {"logInterval": "often"}),
        ("controlDict", "logInterval", "often", "number")),
    "no iterations of contact": (
        edit("system/controlDict", {"contactIterations": 0}),
        ("controlDict", "contactIterations", "0", "positive")),
    "preset that is a dictionary": (
        control("preset { balanced; }"), ("controlDict", "preset")),
    "region of mass scaling": (
        control("massScaling { bar3 { factor 2; } }"),
        ("controlDict", "massScaling", "bar3", "bar1")),
    "expression that matches no region": (
        control('damping { "pad.*" { coefficient 2; } }'),
        ("controlDict", "damping", "pad.*", "bar1")),
    "settings that are no dictionary": (
        control("massScaling { bar1 4; }"),
        ("controlDict", "massScaling", "bar1", "dictionary", "factor")),
    "keyword of mass scaling": (
        control("massScaling { bar1 { factr 2; } }"),
        ("controlDict", "massScaling", "bar1", "factr", "factor")),
    "factor and step": (
        control("massScaling { bar1 { factor 2; step 1; } }"),
        ("controlDict", "bar1", "(factor step)")),
    "neither factor nor step": (
        control("massScaling { bar1 { force yes; } }"),
        ("controlDict", "bar1", "(factor step)")),
    "less mass": (
        control("massScaling { bar1 { factor 0.5; } }"),
        ("controlDict", "bar1", "factor", "0.5", "at least 1")),
    "force that is a word": (
        control("massScaling { bar1 { factor 2; limit 1; force maybe; } }"),
        ("controlDict", "bar1", "force", "maybe")),
    "more mass than is allowed": (
        control("massScaling { bar1 { factor 2; } }"),
        ("controlDict", "bar1", "kg", "% of the mass", "limit", "force yes")),
    "step of no length": (
        control("massScaling { bar1 { step 0; } }"),
        ("controlDict", "bar1", "step", "positive")),
    "step with the paper's scheme": (
        paper(control("massScaling { bar1 { step 1e-3; } }")),
        ("controlDict", "bar1", "step", "paper", "factor")),
    "negative damping": (
        control("damping { bar1 { coefficient -3; } }"),
        ("controlDict", "bar1", "coefficient", "-3", "at least 0")),
    "damping without its value": (
        control("damping { bar1 { } }"),
        ("controlDict", "bar1", "coefficient")),
    "keyword of damping": (
        control("damping { bar1 { coeficient 3; } }"),
        ("controlDict", "bar1", "coeficient", "coefficient")),
    "damping with the paper's scheme": (
        paper(control("damping { bar1 { coefficient 3; } }")),
        ("controlDict", "damping", "paper", "(leapfrog)")),
    "relaxation with the paper's scheme": (
        paper(control("relaxation { type kinetic; }")),
        ("controlDict", "relaxation", "paper", "(leapfrog)")),
    "relaxation with steps of their own": (
        control("relaxation { type kinetic; } subCycling yes;"),
        ("controlDict", "relaxation", "subCycling", "must be no")),
    "unknown relaxation": (
        control("relaxation { type viscous; }"),
        ("controlDict", "relaxation", "viscous", "kinetic")),
    "keyword of relaxation": (
        control("relaxation { type kinetic; tolerence 1e-3; }"),
        ("controlDict", "relaxation", "tolerence", "tolerance")),
    "tolerance of zero": (
        control("relaxation { type kinetic; tolerance 0; }"),
        ("controlDict", "relaxation", "tolerance", "positive")),
    "misspelt dictionary of the scheme": (
        replace(schemes, "vertexCentred", "vertexCentered"),
        ("fvSchemes", "'vertexCentered'", "'vertexCentred'")),
    "condition of no patch": (
        replace(velocity, r"boundaryField\s*\{", "boundaryField { lefft "
                "{ type fixedVelocity; velocity (0 0 0); }"),
        ("pointU", "boundaryField", "'lefft'", "bar1", "'left'")),
    "no interfaces": (
        replace(contact, r"(?s)interfaces\s*\{.*", ""),
        ("contactProperties", "'interfaces'", "missing")),
    "interfaces that are a number": (
        edit(contact, {"interfaces": 5}),
        ("contactProperties", "'interfaces'", "not a dictionary")),
    "broken expression of a side": (
        replace(contact, r"\(bar1 right\)", '("bar[" right)'),
        ("contactProperties", "'sides'", "regular expression", "bar[")),
    **{f"broken expression as a keyword of {file.split('/')[-1]}": (
        action, (file, "regular expression '['"))
       for file, action in (
        ("constant/solidProperties", all_of(
            remove(material), rewrite("constant/solidProperties",
                                      '"[" { type rigid; rho 1; }'))),
        (contact, replace(contact, r"interfaces\s*\{",
                          'interfaces { "[" { surfaces all; }')),
        (velocity, replace(velocity, r"boundaryField\s*\{",
                           'boundaryField { "[" { type calculated; }')))},
    "surfaces that are a word": (
        replace(contact, r"interfaces\s*\{", "interfaces { many { surfaces "
                "al; }"),
        ("contactProperties", "'surfaces'", "all", "list")),
    "no surfaces": (
        replace(contact, r"interfaces\s*\{", "interfaces { many { surfaces "
                "(); }"),
        ("contactProperties", "'surfaces'", "all", "list")),
    "law that is a word": (
        replace(contact, r"interfaces\s*\{", "interfaces { many { surfaces "
                "all; law frictionless; }"),
        ("contactProperties", "many", "'law'", "dictionary", "type")),
    "interval without its control": (
        history("solidEnergies", "writeInterval 5;"),
        ("mine", "'writeInterval'", "'writeControl'")),
    "region of what is of all": (
        history("contactForces", "region bar1;"), ("mine", "'region'")),
    "no list of regions": (
        remove("constant/regionProperties"),
        ("regionProperties", "constant/polyMesh")),
    "maxCo of zero": (
        edit("system/controlDict", {"maxCo": 0}), ("controlDict", "maxCo")),
}


@pytest.fixture
def case(good, tmp_path):
    return Case(shutil.copytree(good.path, tmp_path/"case"))


def test_good_input(case):
    """The valid input that the faults below are made from runs without
    error."""
    done = execute(["vertexContactFoam"], case.path)
    assert done.returncode == 0, done.stdout
    assert "0.01" in timeFolders(case.path)


# More of controlDict, and of the file "shared" beside it
VARIABLES = {
    "like one of our keywords": ("maxC 5; logInterval $maxC;", ""),
    "like none": ("hourglass 5; logInterval ${hourglass};", ""),
    "of the whole file": ("hourglass 5; none { some $:hourglass; } "
                          "_more { $none; }", ""),
    "calculated with": (
        "hourglass 5; maxEnergyRise #eval{ 2*$hourglass };", ""),
    "of a condition": ("hourglass on;\n#ifeq $hourglass off\nmaxCo 3;\n"
                       "#endif\n", ""),
    "used in an included file": ('hourglass 5;\n#include "shared"\n',
                                 "logInterval $hourglass;"),
    "of an included file": ('#include "shared"\nlogInterval $hourglass;',
                            "hourglass 5; radius 3; // of other files"),
    "of a file that is found by a variable": (
        'name "shared"; hourglass 5;\n#include "$name"\n',
        "logInterval $hourglass;"),
    "of what is a comment for the moment": (
        "hourglass 5; // logInterval $hourglass;\n", ""),
    "marked": ("_hourglass 5;", ""),
    "dictionary of code": (
        "hourglass { size 3; }\nfunctions { seen { type coded; libs "
        "(utilityFunctionObjects); name seen; codeExecute #{ "
        'mesh().time().controlDict().subDict("hourglass"); #}; '
        "enabled no; } }", ""),
}


@pytest.mark.parametrize("what", VARIABLES)
def test_variable_of_the_user(case, what):
    """Entries that the file uses by $, or that begin with _, may have any
    name."""
    entries, shared = VARIABLES[what]
    if shared:
        rewrite("system/shared", shared)(case)
    control(entries)(case)
    done = execute(["vertexContactFoam", "-dry-run"], case.path)
    assert done.returncode == 0, done.stdout


def test_start_fields_are_those_of_the_list(case):
    """Each field of -listStartFields is read, with its type and dimensions."""
    output = execute(["vertexContactFoam", "-listStartFields"],
                     case.path).stdout
    rows = re.findall(r"(?m)^    (\w+) +\[(\S+)\] +(\w+)  ", output)
    units = {"m/s": "0 1 -1 0 0 0 0", "m": "0 1 0 0 0 0 0",
             "-": "0 0 0 0 0 0 0", "K": "0 0 0 1 0 0 0"}
    values = {"scalar": "300", "vector": "(0 0 0)",
              "tensor": "(1 0 0 0 1 0 0 0 1)", "symmTensor": "(1 0 0 1 0 1)"}
    assert len(rows) == 9
    elastic = (case/material).read_text()
    edit(contact, {"interfaces/bars/law/type": "Coulomb",
                   "interfaces/bars/law/frictionCoeff": 0.3})(case)
    for name, unit, kind in rows:
        if name == "pointU":
            continue
        if name in ("CpInv", "elasticStrain", "epsilonPEq", "pointT",
                    "hourglassShare"):
            plastic("tauY 1; adiabaticHeating { cp 400; }")(case)
        else:
            (case/material).write_text(elastic)
        kind = kind[0].upper() + kind[1:]
        for dimensions, code in ((units[unit], 0), ("0 0 0 0 0 1 0", 1)):
            field(name, kind, dimensions, values[kind[0].lower() + kind[1:]])(
                case)
            done = execute(["vertexContactFoam", "-dry-run"], case.path)
            assert done.returncode == code, done.stdout
        assert name in done.stdout and "dimensions" in done.stdout
        (case/f"0/bar1/{name}").unlink()


def test_longest_step(case):
    """maxDeltaT limits the step, unless the step is fixed."""
    def step(**entries):
        case.set("system/controlDict", entries)
        done = execute(["vertexContactFoam", "-dry-run"], case.path)
        return float(re.search(r"Step: (\S+) s at the start", done.stdout)[1])

    bound = step()
    assert 2e-4 < bound < 0.01
    assert step(maxDeltaT=1e-4) == pytest.approx(1e-4, rel=1e-6)
    assert step(maxDeltaT=1) == bound
    assert step(maxDeltaT=1e-4, subCycling="yes") == pytest.approx(
        1e-4, rel=1e-6)
    assert step(maxDeltaT=1e-4, subCycling="no", adjustTimeStep="no",
                deltaT=2e-4) == pytest.approx(2e-4, rel=1e-6)


@pytest.mark.parametrize("what", CASES)
def test_bad_input(case, what):
    action, named = CASES[what]
    action(case)
    done = execute(["vertexContactFoam"], case.path)
    output = done.stdout

    assert done.returncode != 0, output
    messages = re.findall(r"--> FOAM FATAL(?: IO)? ERROR", output)
    assert len(messages) == 1, output

    # OpenFOAM has its own message if a file does not exist
    if what not in ("missing velocity", "missing material"):
        assert messages[0] == "--> FOAM FATAL IO ERROR", output
    message = output[output.index("--> FOAM FATAL"):]
    for name in named:
        assert name in message, f"no '{name}' in\n{message}"
    for trace in "sigSegv", "sigFpe":
        assert trace not in output, output

    # Before the first step
    assert timeFolders(case.path) == ["0"]
    for table in (case/"postProcessing").rglob("*.dat"):
        rows = [line for line in table.read_text().splitlines()
                if not line.startswith("#")]
        assert all(float(row.split()[0]) == 0 for row in rows), table


class BothEnds(Body):
    """A block whose left and right sides are one patch."""

    def boundary(self, faces):
        both = faces["left"][:-1] + faces["right"][1:]
        return super().boundary({**faces, "left": both, "right": "()"})


@pytest.mark.parametrize("pairing", ("matching", "AMI"))
def test_closed_surface(tmp_path, pairing):
    """Its area vector is round-off, which must not be the direction of the
    gap."""
    bodies = [BothEnds((3, 3), "inner", sides={"left": "contact"}),
              Body((3, 3), "outer", (1, 0, 0), sides={"left": "contact"})]
    code, log = SmallCase(
        tmp_path, bodies, 1, interfaces={"hub": interface(
            ("inner", "left"), ("outer", "left"), pairing=pairing)}).attempt()
    assert code != 0
    for words in ("FOAM FATAL IO ERROR", "contactProperties", "'direction'",
                  "inner left", "pairing nearestFace"):
        assert words in log, log
