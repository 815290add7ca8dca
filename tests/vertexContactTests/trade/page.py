"""Writes the page trade.md and its pictures from the rows of the tables."""

import csv
from math import log

from vertexContactTests.trade import peers
from vertexContactTests.trade.cases import CASES, FOLDER
from vertexContactTests.trade.front import (LARGEST_RISE, atEqualError,
                                            cheapest, front, numbers)
from vertexContactTests.trade.picture import draw
from vertexContactTests.trade.variants import (OPTIONS, PRESETS, isPreset,
                                               label, named)

LIMITS = (0.4, 0.2, 0.1, 0.05, 0.025, 0.0125, 0.00625)

HEAD = f"""# Speed against accuracy

Written by `tests/benchmark/trade/trade.py`; all runs are in [`trade.csv`](trade/trade.csv). `trade.py -h` explains how to run a part of them again.

*Error* is the mean of three errors: the relative L1 differences in time of the velocity of a probe and of the contact force, and the difference of the
energy that is left at the end (kinetic, strain, plastic work), relative to the initial energy. The reference of the two bars is the exact solution. For the
other cases the reference is the run with `accurate` on the finest mesh, whose own error is estimated below. *Force* and its *peak* use means over hundredths
of the run. *Impulse* is the error of the impulse at the end. *Rise* is the largest rise of kinetic and strain energy above an earlier value. *Penetration*
is the largest penetration, relative to the width of a face.

*Cost* is the time of all steps, divided by the time of a small fixed case that runs right before and after, since a machine is not equally fast at all
times. The tables give the cost relative to that of `balanced` on the base mesh. All runs use one core. `paper` evaluates the fluxes twice per step. Runs
whose energy rises by more than {LARGEST_RISE:g} of the initial energy are not on the front, however small their error is.
"""


def percent(value, digits=2):
    return f"{100*value:.{digits}g} %" if value != "" else ""


def table(head, lines):
    rows = ["| " + " | ".join(head) + " |", "|" + "---|"*len(head)]
    return "\n".join(rows + ["| " + " | ".join(line) + " |"
                             for line in lines]) + "\n"


def find(rows, chosen):
    """The row of the run with these options; None if no such run ended well."""
    for row in rows:
        if all(str(row["options"][k]) == v for k, v in chosen.items()):
            return row
    return None


def presets(tables):
    """Error and relative cost of each preset on the base meshes."""
    lines = []
    for name, rows in tables.items():
        case = CASES[name]
        found = {p: find(rows, named(case, p, case.base)) for p in PRESETS}
        if not found["balanced"]:
            continue
        unit = found["balanced"]["cost"]
        cells = [case.title]
        for p in PRESETS:
            row = found[p]
            cells += [percent(row["error"], 3), f"{row['cost']/unit:.2f}"] \
                if row else ["", ""]
        lines.append(cells)
    head = ["on the base mesh"] + [text for p in PRESETS
                                   for text in (f"`{p}`: error", "cost")]
    return table(head, lines)


def decisions(tables, compared, error, what):
    """The cheapest run that reaches each limit, its cost, and the cost of plain
    finite elements, computed one after the other and eight at once."""
    lines = []
    for name, rows in tables.items():
        last, calibration = None, rows[0]["calibration"]
        for limit in LIMITS:
            row = cheapest(rows, limit, error)
            if row:
                calibration = row["calibration"]
            others = [cheapest(compared[kind][name], limit, error)
                      for kind in KINDS]
            other = [f"{others[0]['mesh']:.0f}" if others[0] else "none"] + [
                f"{peer['cost']*calibration:.2g}" if peer else ""
                for peer in others]
            if row is None:
                lines.append([CASES[name].title, percent(limit),
                              "none of the runs", "", "", "", *other])
                break
            more = f"{row['cost']/last['cost']:.1f}" if last else ""
            line = [CASES[name].title, percent(limit), row["label"],
                    percent(row[error]), f"{row['seconds']:.2g}", more, *other]
            if row is last:
                # The same run also reaches the next limit
                lines[-1][1] = percent(limit)
                lines[-1][-3:] = other
            else:
                lines.append(line)
            last = row
    return table(["case", f"{what} at most", "cheapest run", "its error",
                  "seconds", "cost / line above",
                  f"{peers.TITLE}: elements", "seconds",
                  "eight at once: seconds"], lines)


def equalErrors(tables, compared):
    """Ratios of the costs of balanced and fast, on all meshes, to the costs of
    plain finite elements at the same error, with each of the references."""
    lines = []
    for name, rows in tables.items():
        case = CASES[name]
        mine = [row for preset in ("balanced", "fast")
                for row in onMeshes(case, rows, preset)]
        if case.conforming:
            mine += onMeshes(case, rows, "balanced", case.conforming)
        for row in mine:
            line = [case.title, row["options"]["preset"],
                    row["options"]["mesh"], f"{row['seconds']:.2g}"]
            for ours, theirs in ("error", "error"), ("peer", "own"):
                line += equalError(
                    row, ours, [compared[kind][name] for kind in KINDS],
                    theirs)
            lines.append(line)
    head = [f"{peers.TITLE}: seconds", "ratio", "eight at once: ratio"]
    return table(["case", "preset", "mesh", "seconds", "error", *head,
                  f"error, reference of {peers.TITLE}", *head], lines)


def equalError(row, ours, compared, theirs):
    """The error, the seconds of the first of the compared programs, and the
    ratio of our cost to the cost of each."""
    if row.get(ours, "") == "":
        return [""]*(len(compared) + 2)
    seconds, ratios = "", []
    for peer in compared:
        cost, bound = atEqualError(peer, row[ours], theirs)
        if cost is None:
            ratios.append("")
            continue
        # If the program needs less than a bound, the ratio is more
        other = {"<": "> ", ">": "< ", "": ""}[bound]
        ratios.append(f"{other}{row['cost']/cost:.2g}")
        seconds = seconds or f"{bound} {cost*row['calibration']:.2g}".strip()
    return [percent(row[ours], 3), seconds, *ratios]


# Plain finite elements, computed one after the other and eight at once
KINDS = peers.ONE, peers.NAME


def agreements(compared):
    """The difference between the references of both programs, and between the
    reference of the compared program and its next coarser mesh."""
    lines = []
    for name, case in CASES.items():
        found = peers.agreement(name)
        if found:
            lines.append(
                [case.title, case.finest, str(peers.FINEST[name])]
                + [percent(found[k]) for k in
                   ("error", "velocity", "force", "peak", "impulse",
                    "energy")]
                + [f"{percent(r['own'])} ({r['mesh']:.0f})"
                   for r in compared[name][-1:] if r["own"] != ""])
    return table(["case", "ours: mesh", f"{peers.TITLE}: elements", "error",
                  "velocity", "force", "peak", "impulse", "energy",
                  f"{peers.TITLE}, coarser (elements): error"], lines)


def programs(tables, packaged):
    """Runs of programs from packages, and the cost of balanced at the same
    error, interpolated between its meshes by powers of the error."""
    lines = []
    for name, rows in tables.items():
        ours = onMeshes(CASES[name], rows, "balanced")
        for row in packaged[name]:
            line = [CASES[name].title, peers.PACKAGED[row["program"]],
                    f"{row['mesh']:.0f}", f"{row['seconds']:.2g}",
                    f"{row['us']:.2g}", percent(row["error"], 3)]
            cost, bound = atEqualError(ours, row["error"])
            if cost is not None:
                other = {"<": "> ", ">": "< ", "": ""}[bound]
                line += [f"{bound} {cost*row['calibration']:.2g}".strip(),
                         f"{other}{row['cost']/cost:.2g}"]
            lines.append(line + [""]*(8 - len(line)))
    return table(["case", "program", "mesh", "seconds",
                  "µs per node and step", "error",
                  "`balanced` at this error: seconds", "ratio"], lines)


def before(tables):
    """The cheapest run of balanced, on any mesh of the case, that is as good as
    the default scheme until November 2026 was on the base mesh."""
    lines = []
    with open(FOLDER/"before.csv") as file:
        for old in csv.DictReader(file):
            case, rows = CASES[old["case"]], tables.get(old["case"], [])
            now = find(rows, named(case, "balanced", case.base))
            if not now:
                continue
            error, cost = float(old["error"]), float(old["cost"])
            good = [r for r in onMeshes(case, rows, "balanced")
                    if r["error"] <= 1.02*error]
            best = min(good, key=lambda r: r["cost"], default=None)
            lines.append([
                f"{case.title}, {case.base}", percent(error, 3),
                percent(now["error"], 3), f"{now['cost']/cost:.2f}",
                f"{now['steps']/float(old['evaluations']):.2f}",
                *([best["options"]["mesh"], percent(best["error"], 3),
                   f"{best['cost']/cost:.3f}"] if best
                  else ["none", "", ""])])
    return table(["case, mesh", "error then", "error now", "cost now / then",
                  "evaluations now / then", "as good: mesh", "error",
                  "cost / then"], lines)


def onMeshes(case, rows, preset, meshes=None):
    """Runs of a preset on the meshes of the case, or on the given meshes, from
    coarse to fine."""
    meshes = meshes or (case.base, *case.meshes)
    mine = [r for r in rows if r["options"]["mesh"] in meshes
            and r["options"] == named(case, preset, r["options"]["mesh"])]
    return sorted(mine, key=lambda r: r["nodes"])


def meshes(case, rows, unit):
    """Table of the presets on all meshes, and of balanced on matching ones."""
    mine = [r for preset in PRESETS for r in onMeshes(case, rows, preset)]
    if case.conforming:
        mine += onMeshes(case, rows, "balanced", case.conforming)
    return table(RUN_HEAD, [runLine(r, unit) for r in mine])


def halvings(tables):
    """The cost of half of the error by a finer mesh. The error is taken as a
    power of the cost between the coarsest and the finest mesh of a preset."""
    lines = []
    for name, rows in tables.items():
        cells = [CASES[name].title]
        for preset in PRESETS:
            found = onMeshes(CASES[name], rows, preset)
            first, last = found[0], found[-1]
            power = log(first["error"]/last["error"])/log(
                last["cost"]/first["cost"])
            cells += [f"{percent(first['error'], 3)} to "
                      f"{percent(last['error'], 3)}",
                      f"{2**(1/power):.1f}"]
        lines.append(cells)
    head = ["refined"] + [text for p in PRESETS
                          for text in (f"`{p}`: error", "half of it costs")]
    return table(head, lines)


RUN_HEAD = ("run", "error", "velocity", "stress", "force", "peak", "impulse",
            "energy", "rise", "penetration", "steps", "µs per node and step",
            "cost")


def runLine(row, unit):
    return [row["label"], percent(row["error"], 3)] + [
        percent(row[k]) for k in RUN_HEAD[2:10]] + [
        f"{row['steps']:.0f}", f"{row['us']:.3f}", f"{row['cost']/unit:.2f}"]


def section(case, rows, peer, packaged, stopped):
    balanced = find(rows, named(case, "balanced", case.base))
    if not balanced:
        return f"## {case.title.capitalize()}\n\nNot run.\n"
    unit = balanced["cost"]
    draw(case, rows, peer, packaged, unit)
    base = [r for r in rows if r["options"]["mesh"] == case.base]
    text = [f"## {case.title.capitalize()}\n",
            f"[`{case.tutorial}`](../../tutorials/{case.tutorial}/README.md), "
            f"base mesh {case.base}: `balanced` takes "
            f"{balanced['seconds']:.2g} s. " + reference(case, rows) + "\n",
            f"![error by cost](trade/{case.name}.png)\n",
            "The front (error and cost): " + "; ".join(
                f"{n} *{r['label']}* ({percent(r['error'])} at "
                f"{r['cost']/unit:.2g})"
                for n, r in enumerate(front(rows), 1)) + ".\n",
            "Presets on all meshes:\n", meshes(case, rows, unit),
            "Other options, base mesh:\n",
            table(RUN_HEAD, [runLine(r, unit) for r in base
                             if not isPreset(case, r["options"])])]
    if case.name == "taylor":
        text += ["Length, radius and plastic work at the end:\n", table(
            ("run", "length", "radius", "plastic work / initial energy"),
            [[r["label"]] + [percent(r[k]) for k in
                             ("length", "radius", "plasticWork")]
             for preset in PRESETS for r in onMeshes(case, rows, preset)])]
    if stopped:
        text += ["Runs that the solver ended: " + "; ".join(
            f"*{r['label']}* ({r['status']})" for r in stopped) + ".\n"]
    return "\n".join(text)


def reference(case, rows):
    """A sentence about the reference and its error."""
    if not case.finest:
        return "The reference is the exact solution."
    next_ = max(case.meshes, key=float)
    row = find(rows, named(case, "accurate", next_))
    text = f"The reference is mesh {case.finest} with `accurate`"
    if not row:
        return text + "."
    return (f"{text}; mesh {next_} with `accurate` is {percent(row['error'])} "
            f"from it (velocity {percent(row['velocity'])}, force "
            f"{percent(row['force'])}, energy {percent(row['energy'])}).")


# On which the rows of trade.csv and peers.csv, except CalculiX, were measured
MACHINE = "an AMD EPYC with AVX-512"

PEERS = f"""## Against plain finite elements

[`plainFEM`](peers/plainFEM/README.md) is a textbook program: hexahedra and quadrangles with full integration and mean dilatation, central differences, and
kinematic contact with the plane of symmetry. It has no contact search. It computes only one of two equal bodies, and its time then counts twice. *Plain
FEM* computes one element after the other, as such programs do. *Eight at once* is the same program with eight elements in the lanes of a vector. Only blocks
of equal elements allow this; it is as fast as we could make it. Its bars have matching meshes; `conforming` are our runs with the same meshes. All runs used
one core of {MACHINE}; other machines give other ratios.

The next table has the differences between the references of both programs: `plainFEM` relative to ours, and a coarser mesh of `plainFEM` relative to its own
reference.
"""

EQUAL = """The next table compares costs at equal error. It has the time that plain FEM needs for the error of our run, interpolated between its meshes by powers of
the error, and the ratio of our cost to this cost. `<`: plain FEM needs less than its coarsest mesh, so the ratio is larger. `>`: it needs more than its
finest mesh here, so the ratio is smaller. Seconds are at the speed that the machine had when our run was measured. For both programs, errors are first
relative to our reference, and then relative to that of plain FEM.
"""


PACKAGED = """The last table has programs from packages; [`peers`](peers/README.md) has their settings and what they cannot do. *Ratio* is their cost over the cost of
`balanced` at the same error, interpolated between its meshes. `<`: `balanced` needs less than its coarsest mesh, so the ratio is larger. `>`: it needs more
than its finest mesh, so the ratio is smaller.
"""


def writePage(rows, compared):
    rows = list(rows)
    everyone = numbers(compared)
    compared = {kind: {name: [r for r in everyone if r["case"] == name
                              and r["program"] == kind] for name in CASES}
                for kind in KINDS}
    packaged = {name: [r for r in everyone if r["case"] == name
                       and r["program"] in peers.PACKAGED] for name in CASES}
    done = numbers(rows)
    texts = [r for r in rows if r["status"] == "done"]
    for row, text in zip(done, texts):
        case = CASES[text["case"]]
        row["options"] = {k: text[k] for k in OPTIONS}
        row["label"] = label(case, row["options"])
    tables = {name: [r for r in done if r["case"] == name] for name in CASES}
    tables = {name: found for name, found in tables.items() if found}
    page = [HEAD, "## Presets\n", presets(tables),
            "## Against the previous scheme\n",
            "Until November 2026 `balanced` was the paper's scheme with "
            "corrections that no longer exist (commit f6e7214). It was "
            "measured once, against the present references, but on another "
            "machine. So costs, in the same unit, compare only roughly. *As "
            "good* means an error that is at most 2 % larger.\n",
            before(tables),
            "## What an error costs\n",
            "The cheapest of all runs, on any mesh, with at most this error:"
            "\n", decisions(tables, compared, "error", "error"),
            "The next table shows how many times more half of the error costs "
            "by a finer mesh alone. Where a wave front passes, every scheme is "
            "at most of first order in this norm. Half of the error then costs "
            "4 times as much in one dimension, 8 times in two, and 16 times in "
            "three.\n", halvings(tables),
            "For the peak of the contact force alone, which may be right by "
            "chance on a coarse mesh:\n",
            decisions(tables, compared, "peak", "error of the peak force"),
            PEERS, agreements(compared[peers.NAME]), EQUAL, equalErrors(tables, compared),
            PACKAGED, programs(tables, packaged)]
    page += [section(CASES[name], found, {
        kind: compared[kind][name] for kind in KINDS}, packaged[name], [
        r for r in rows if r["case"] == name and r["status"] != "done"])
        for name, found in tables.items()]
    (FOLDER.parent/"trade.md").write_text("\n".join(page))
