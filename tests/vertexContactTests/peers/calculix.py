"""A case with CalculiX: histories as those of plainFEM, and what they cost.

    python3 -m vertexContactTests.peers.calculix CASE ELEMENTS [-out FILE]
        [-limit SECONDS]
"""

import argparse
import math
import os
import re
import resource
import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from vertexContactTests.peers.deck import deck
from vertexContactTests.peers.scenes import SCENES

# Part of the run; its time is subtracted, to leave out the start-up
SHORT = 0.05
LIMIT = 1800


class Failed(RuntimeError):
    """CalculiX did not end, or ended with an error."""


def ccx(folder, text, limit):
    """Run an input file; returns processor seconds."""
    if not shutil.which("ccx"):
        raise Failed("no ccx; tests/benchmark/peers/install says how to get it")
    (folder/"run.inp").write_text(text)
    one = {k: "1" for k in ("OMP_NUM_THREADS", "CCX_NPROC_STIFFNESS",
                            "CCX_NPROC_RESULTS", "OPENBLAS_NUM_THREADS")}

    def used():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    before = used()
    with open(folder/"log", "w") as log:
        try:
            done = subprocess.run(["ccx", "run"], cwd=folder, stdout=log,
                                  stderr=log, env={**os.environ, **one},
                                  timeout=limit)
        except subprocess.TimeoutExpired:
            raise Failed(f"more than {limit:.0f} s") from None
    said = (folder/"log").read_text(errors="replace")
    wrong = re.search(r"\*ERROR[^*]*", said)
    if done.returncode or wrong or "Job finished" not in said:
        raise Failed(" ".join(wrong[0].split()) if wrong
                     else f"code {done.returncode}")
    return used() - before


def blocks(file):
    """The printed blocks: (title, time, numbers)."""
    title, rows = None, []
    with open(file) as lines:
        for line in lines:
            if " time " in line:
                if rows:
                    yield *title, np.array(rows)
                what, time = line.split(" and time ")
                title, rows = (what.strip(), float(time)), []
            elif line.strip():
                rows.append([float(v) for v in line.split()])
    if rows:
        yield *title, np.array(rows)


def histories(scene, file):
    """Histories from the printed states. Energies and momentum use the lumped
    masses, since CalculiX prints those of a mass matrix that it does not
    use."""
    nodes, volumes = scene.mesh.volumes()
    mass = scene.rho*nodes

    def kinetic(velocity):
        return 0.5*mass @ (velocity**2).sum(1)

    a = scene.axis
    E0, start = kinetic(scene.velocity), mass @ scene.velocity[:, a]
    found = {}
    for title, time, rows in blocks(file):
        now = found.setdefault(time, {"Time": time, "plasticWork": 0.})
        if "velocities" in title:
            v = rows[:, 1:]
            now["velocity"] = v[scene.probes["probe"], a]
            now["impulse"] = (mass @ v[:, a] - start)/scene.thickness
            now["kinetic"] = kinetic(v)/E0
        elif "displacements" in title:
            of = {int(row[0]) - 1: row[1:] for row in rows}
            for name, point in scene.probes.items():
                # The displacement of the rim is outwards
                now[name] = of[point][0 if name == "rim" else a]
        elif "internal energy" in title:
            now["internal"] = rows[0, 0]/E0
        elif "plastic" in title:
            yields, modulus = scene.hardening
            e = rows[:, 2]
            work = yields*e + modulus/2*e**2
            now["plasticWork"] = volumes @ work.reshape(
                len(volumes), -1).mean(1)/E0
    keys = list(next(iter(found.values())))
    table = {k: np.array([row[k] for row in found.values()]) for k in keys}
    table["energy"] = table["kinetic"] + table["internal"] \
        - table["plasticWork"]
    if not np.all(np.isfinite(table["energy"])) \
            or abs(table["energy"]).max() > 10:
        raise Failed("not stable")
    # Contact may change the steps, and therefore the times
    times = scene.end*np.arange(1, scene.samples + 1)/scene.samples
    start = {"velocity": scene.velocity[scene.probes["probe"], a], "energy": 1}
    at = np.append(0, table["Time"])
    return {"Time": times, **{
        k: np.interp(times, at, np.append(start.get(k, 0), table[k]))
        for k in ("velocity", "impulse", "energy", "plasticWork",
                  *scene.probes)}}


def stepsTaken(log, end):
    """Number of steps from the step that CalculiX takes, which may be smaller
    than the given largest step."""
    step = float(re.search(r"SELECTED time increment:\s*(\S+)", log)[1])
    # CalculiX prints seven digits
    return math.ceil(end/step - 1e-3)


def run(name, mesh, limit=LIMIT):
    """Histories and costs of a case."""
    scene = SCENES[name](mesh)
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        ccx(folder, deck(scene, scene.end, True), limit)
        table = histories(scene, folder/"run.dat")
        short = ccx(folder, deck(scene, SHORT*scene.end, False), limit)
        long = ccx(folder, deck(scene, scene.end, False), limit)
        steps = stepsTaken((folder/"log").read_text(errors="replace"),
                           scene.end)
    energy = np.append(1, table["energy"])
    return table, {
        "bodies": scene.bodies, "nodes": len(scene.mesh.points),
        "steps": steps, "seconds": (long - short)/(1 - SHORT),
        "rise": np.max(energy - np.minimum.accumulate(energy))}


def write(table, said, what, file):
    """Write the histories as plainFEM does."""
    with open(file, "w") as out:
        out.write(f"# CalculiX {what}; " + ", ".join(
            f"{k} {v:.5g}" for k, v in said.items()) + "\n"
            + ",".join(table) + "\n")
        for row in zip(*table.values()):
            out.write(",".join(f"{v:.7g}" for v in row) + "\n")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("case", choices=SCENES)
    parser.add_argument("elements", type=int)
    parser.add_argument("-out", default="/dev/stdout")
    parser.add_argument("-limit", type=float, default=LIMIT)
    given = parser.parse_args()
    try:
        table, said = run(given.case, given.elements, given.limit)
    except Failed as stop:
        raise SystemExit(f"calculix: {stop}") from None
    write(table, said, f"{given.case}, {given.elements} elements", given.out)


if __name__ == "__main__":
    main()
