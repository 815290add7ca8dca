"""Input files of CalculiX."""

import math


def numbered(name, points):
    """A set of nodes."""
    return [f"*NSET,NSET={name}"] + [f"{p + 1}," for p in points]


def rows(start, values):
    return [f"{start + i}," + ",".join(f"{v:.10g}" for v in value)
            for i, value in enumerate(values)]


def steps(scene):
    """Number of steps such that all samples are at the end of a step, and the
    length of a step."""
    every = math.ceil(scene.end/scene.samples/scene.step)
    return every, scene.end/scene.samples/every


def plate(scene):
    """One fixed element behind the plane."""
    count = len(scene.mesh.points)
    away = [0, 0, 0]
    away[scene.axis] = 0.2*scene.mesh.points.max()
    front = [tuple(p) for p in scene.plate]
    back = [tuple(a + b for a, b in zip(p, away)) for p in front]
    nodes = range(count + 1, count + 9)
    element = len(scene.mesh.elements) + 1
    return [
        "*NODE,NSET=PLATE", *rows(count + 1, front + back),
        "*ELEMENT,TYPE=C3D8,ELSET=BEHIND",
        f"{element}," + ",".join(map(str, nodes)),
        "*SOLID SECTION,ELSET=BEHIND,MATERIAL=BODY",
        "*BOUNDARY", "PLATE,1,3",
        *numbered("TOUCHING", scene.touching),
        "*SURFACE,NAME=SLAVE,TYPE=NODE", "TOUCHING",
        "*SURFACE,NAME=MASTER,TYPE=ELEMENT", "BEHIND,S1",
        "*SURFACE INTERACTION,NAME=HARD",
        "*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR",
        f"{scene.stiffness:.6g}",
        "*CONTACT PAIR,INTERACTION=HARD,TYPE=NODE TO SURFACE",
        "SLAVE,MASTER"]


def deck(scene, end, prints):
    """Lines of an input file for a run to a time. prints: with histories."""
    mesh = scene.mesh
    every, step = steps(scene)
    held = {(p, d) for points, d in scene.fixed for p in points}
    lines = ["*NODE,NSET=ALL", *rows(1, mesh.points),
             f"*ELEMENT,TYPE={scene.element},ELSET=BODY",
             *rows(1, mesh.elements + 1),
             "*MATERIAL,NAME=BODY", *scene.material,
             "*DENSITY", f"{scene.rho:g}",
             "*SOLID SECTION,ELSET=BODY,MATERIAL=BODY"]
    if scene.plate:
        lines += plate(scene)
    for points, d in scene.fixed:
        lines += [*numbered(f"HELD{d}", points),
                  "*BOUNDARY", f"HELD{d},{d + 1},{d + 1}"]
    lines += [*numbered("PROBES", scene.probes.values()),
              "*INITIAL CONDITIONS,TYPE=VELOCITY"]
    lines += [f"{p + 1},{d + 1},{v:.10g}"
              for p, value in enumerate(scene.velocity)
              for d, v in enumerate(value) if v and (p, d) not in held]
    lines += ["*STEP,NLGEOM,INC=100000000",
              f"*DYNAMIC,EXPLICIT,ALPHA={scene.alpha:g}",
              # The last number is the largest step. The number before it would
              # scale masses
              f"{step:.10g},{end:.10g},,{step:.10g}"]
    if prints:
        lines += [f"*NODE PRINT,NSET=ALL,FREQUENCY={every}", "V",
                  f"*NODE PRINT,NSET=PROBES,FREQUENCY={every}", "U",
                  f"*EL PRINT,ELSET=BODY,FREQUENCY={every},TOTALS=ONLY",
                  "ELSE"]
        if scene.hardening:
            lines += [f"*EL PRINT,ELSET=BODY,FREQUENCY={every}", "PEEQ"]
    else:
        lines += ["*NODE PRINT,NSET=PROBES,FREQUENCY=100000000", "U"]
    return "\n".join([*lines, "*END STEP", ""])
