"""Contact with rigid obstacles, at rest and moving."""

import numpy as np
import pytest

from vertexContactTests.caseTools import (DEFAULT, PRESET, checkEnergies,
                                          timeFolders)
from vertexContactTests.contactScenes import rigid, spinning
from vertexContactTests.smallCases import (ELASTIC, RUBBER, Body, SmallCase,
                                           condition, coulomb, interface,
                                           largest, polar, table)

PLANE = {"type": "plane", "planeType": "pointAndNormal",
         "pointAndNormalDict": {"point": (0, 0, 0), "normal": (0, 1, 0)}}
SHAPES = {
    "plane": PLANE,
    "box": {"type": "box", "min": (-1, -1, -1), "max": (2, 0, 2)},
    "sphere": {"type": "sphere", "origin": (0.5, -1, 0.5), "radius": 1}}
DOWN = (0, -0.05, 0)


def wall(obstacle=PLANE, law="frictionless", **more):
    law = law if isinstance(law, dict) else {"type": law}
    return {"wall": {"side": ("block", "bottom"), "obstacle": obstacle,
                     "law": law, **more}}


def block(cells, velocity=DOWN, gap=0.01, material=RUBBER):
    return Body(cells=cells, name="block", start=(0, gap, 0),
                velocity=velocity, material=material,
                sides={"bottom": "contact"})


def fall(folder, body, endTime=3, ranks=1, preset=PRESET, **settings):
    case = SmallCase(folder, body, endTime, interfaces=wall(**settings),
                     functions=("contactForces",), preset=preset)
    return case.run() if ranks == 1 else case.runParallel(ranks)


def impulse(case):
    contact = case.contact("wall")
    return np.array([contact[f"block.bottom:I{c}"] for c in "xyz"]).T


def gained(case):
    p = case.momentumOf("block")
    return (p - p[0])[-len(impulse(case)):]


def test_plane_wave(tmp_path, figures):
    """A bar hits a wall: the result is exact in 1D. The contact lasts 2 L/c,
    the force is rho c v, and the bar leaves with its initial speed."""
    speed, gap = 0.01, 0.002
    body = Body(cells=(200,), name="block", start=(gap, 0, 0),
                velocity=(-speed, 0, 0), material=ELASTIC,
                sides={"left": "contact"})
    case = SmallCase(tmp_path, body, 3, functions=("contactForces",),
                     interfaces={"wall": {
                         "side": ("block", "left"), "obstacle": {
                             "type": "plane", "planeType": "pointAndNormal",
                             "pointAndNormalDict": {"point": (0, 0, 0),
                                                    "normal": (1, 0, 0)}},
                         "law": {"type": "frictionless"}}}).run()
    contact = case.contact("wall")
    t, on = contact["Time"], contact["area"] > 0
    middle = (t > 0.5) & (t < 2)
    with figures("bar hits a wall, 1D") as f:
        f.within("first contact / (gap/v)", t[on][0]/(gap/speed), 1, 0.02)
        f.within("contact lasts / (2 L/c)", t[on][-1] - t[on][0], 2, 0.02)
        f.within("force / (rho c v)",
                 contact["block.left:Fx"][middle].mean()/speed, 1, 0.01)
        f.within("momentum at the end / initial",
                 case.momentumOf("block")[-1, 0]/speed, 1, 0.02)


def test_ball_in_two_dimensions(tmp_path, figures):
    """The mid-plane of a plane mesh cuts a curved obstacle: there a ball acts
    like the cylinder through its section."""
    ends = {}
    for name, obstacle in (
            ("ball", {"type": "sphere", "origin": (0.5, -1, 0), "radius": 1}),
            ("cylinder", {"type": "cylinder", "point1": (0.5, -1, -2),
                          "point2": (0.5, -1, 2), "radius": 1})):
        body = Body(cells=(4, 4), name="block", start=(0, 0.01, -0.5),
                    velocity=(0, -0.2, 0), material=RUBBER,
                    sides={"bottom": "contact"})
        case = fall(tmp_path/name, body, obstacle=obstacle, preset=DEFAULT)
        ends[name] = case.at("pointD", region="block")
    with figures("a ball in two dimensions") as f:
        f.atLeast("displacement, largest", largest(ends["cylinder"]), 0.05)
        f.atMost("displacement less that on a cylinder, largest",
                 largest(ends["ball"] - ends["cylinder"]), 1e-12)


@pytest.mark.parametrize("cells, ranks", (
    ((2, 40), 1), ((2, 40), 2), ((2, 40, 2), 1)), ids=str)
def test_spins_on_an_axle(tmp_path, figures, cells, ranks):
    """A ring with a slit is pressed on a cylinder without friction and spins
    on it, for a quarter of a turn. It keeps its angular momentum, and contact
    takes no energy."""
    ring = Body(cells, name="block", start=(1, 0, 0),
                size=(0.1, 1.9*np.pi, 0.1), moved=polar,
                velocity=spinning((0, 0, 0), (0, 0, 0.05)), sides={
                    "left": "contact",
                    "right": condition("pressure", pressure=table(
                        (0, 0), (2, 0.01), (1e9, 0.01)))})
    case = SmallCase(tmp_path, ring, 30, preset=DEFAULT, interfaces={"axle": {
        "side": ("block", "left"), "obstacle": {
            "type": "cylinder", "point1": (0, 0, -1), "point2": (0, 0, 2),
            "radius": 1}}}, control={"maxCo": 0.9})
    case = case.run() if ranks == 1 else case.runParallel(ranks)
    L, E = case.angularMomentumOf()[:, 2], case.totalEnergy
    with figures(f"a ring of {cells} on an axle, {ranks} ranks") as f:
        f.atMost("change of the angular momentum / initial",
                 largest(L/L[0] - 1), 1e-4)
        f.atMost("work of contact / energy",
                 largest(case.energies["total:contactWork"])/E[0], 1e-4)


def plane(normal):
    return {**PLANE, "pointAndNormalDict": {"point": (0, 0, 0),
                                            "normal": normal}}


@pytest.mark.parametrize("law", ("frictionless", "tied"))
@pytest.mark.parametrize("name, oblique, straight, motions, within", (
    ("plane", plane((0, 1, 1)), PLANE, ((0, 0, 0), (0, 0, 0)), 1e-12),
    ("plane that moves", plane((0, 1, 1)), PLANE,
     ((0, 0, 0.05), (0, 0.05, 0)), 1e-12),
    ("ball", {"type": "sphere", "origin": (0.5, -1, 0.75), "radius": 1.25},
     {"type": "sphere", "origin": (0.5, -1, 0), "radius": 1},
     ((0, 0, 0), (0, 0, 0)), 1e-2)))
def test_oblique_in_two_dimensions(tmp_path, figures, law, name, oblique,
                                   straight, motions, within):
    """An obstacle that is oblique to the plane of the mesh acts like the line
    in which the plane cuts it."""
    ends = []
    for obstacle, velocity in zip((oblique, straight), motions):
        body = Body(cells=(4, 4), name="block", start=(0, 0.01, -0.5),
                    velocity=(0, -0.2, 0), material=RUBBER,
                    sides={"bottom": "contact"})
        case = fall(tmp_path/str(len(ends)), body, obstacle=obstacle, law=law,
                    motion={"velocity": velocity}, preset=DEFAULT, endTime=1)
        ends.append(case.at("pointD", region="block"))
    with figures(f"{name} that is oblique in two dimensions, {law}") as f:
        f.atMost("displacement less that on the line / largest",
                 largest(ends[0] - ends[1])/largest(ends[1]), within)


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("ranks", (1, 2))
def test_impulse_of_any_shape(tmp_path, figures, shape, ranks):
    """A block falls on obstacles: its change of momentum equals the impulse,
    and it bounces."""
    case = fall(tmp_path, block((6, 6, 6)), ranks=ranks, preset=DEFAULT,
                obstacle=SHAPES[shape])
    with figures(f"block falls on a {shape}, {ranks} ranks") as f:
        f.atMost("change of momentum - impulse / momentum",
                 largest(gained(case) - impulse(case))/0.05, 1e-12)
        f.atLeast("impulse / momentum", impulse(case)[-1, 1]/0.05, 1.4)
        f.atMost("impulse along the surface / across", largest(
            impulse(case)[-1, (0, 2)])/impulse(case)[-1, 1], 1e-9)
        checkEnergies(f, case, "wall", balance=2e-3, own=1e-3,
                      penetration=0.05)


def test_like_a_mirror_image(tmp_path, figures):
    """An impact on a wall equals an impact on the mirror image of the body."""
    one = fall(tmp_path/"wall", block((8, 8)))
    two = SmallCase(
        tmp_path/"image",
        [block((8, 8)), Body(
            cells=(8, 8), name="image", start=(0, -1.01, 0),
            velocity=(0, 0.05, 0), material=RUBBER,
            sides={"top": "contact"})], 3,
        interfaces={"contact": interface(("block", "bottom"),
                                         ("image", "top"))}).run()
    with figures("wall against mirror image, 2D") as f:
        for name in "pointU", "sigma", "pointD":
            a, b = (case.at(name, region="block") for case in (one, two))
            f.atMost(f"{name}: difference / scale", largest(a - b)/largest(b),
                     1e-9)


MOTIONS = {
    "linearMotion": {"velocity": (0, 0.05, 0)},
    "oscillatingLinearMotion": {"amplitude": (0, 0.05, 0), "omega": 2}}


@pytest.mark.parametrize("motion", MOTIONS)
def test_moving(tmp_path, figures, motion):
    """A wall moves towards a block at rest. At constant speed this equals a
    falling block, seen from the wall. Otherwise the balance includes the work
    of the wall."""
    case = fall(tmp_path/"moving", block((8, 8), velocity=(0, 0, 0)), motion={
        "solidBodyMotionFunction": motion, f"{motion}Coeffs":
        MOTIONS[motion]})
    E = case.totalEnergy
    with figures(f"block is hit by a wall, {motion}") as f:
        f.atMost("change of momentum - impulse / impulse", largest(
            gained(case) - impulse(case))/impulse(case)[-1, 1], 1e-12)
        f.atMost("balance residual / energy at the end",
                 largest(case.energies["total:balance"])/E[-1], 5e-3)
        f.atLeast("work of contact", case.energies["total:contactWork"][-1],
                  1e-4)
        if motion == "linearMotion":
            still = fall(tmp_path/"still", block((8, 8)))
            f.atMost("difference to the falling block / speed", largest(
                case.at("pointU") - still.at("pointU") - (0, 0.05, 0))/0.05,
                1e-6)


def test_rotating(tmp_path, figures):
    """A turntable with friction carries a block round its axis."""
    omega = 0.2
    body = Body(cells=(6, 2, 6), name="block", size=(1, 0.4, 1),
                start=(-0.5, 0, -0.5), material=RUBBER,
                sides={"bottom": "contact"})
    case = SmallCase(
        tmp_path, body, 6, gravity=(0, -0.05, 0),
        functions=("contactForces",), interfaces=wall(
            law=coulomb(1), motion={
                "solidBodyMotionFunction": "rotatingMotion",
                "rotatingMotionCoeffs": {"origin": (0, 0, 0),
                                         "axis": (0, 1, 0),
                                         "omega": omega}})).run()
    L = case.momentum["block:Ly"]
    inertia = 0.4*(1/12 + 1/12)
    with figures("block on a turntable") as f:
        f.within("angular velocity at the end / that of the table",
                 L[-1]/inertia/omega, 1, 0.1)
        f.atMost("momentum aside / (mass omega r)", largest(
            case.momentumOf("block")[:, (0, 2)])/(0.4*omega*0.5), 1e-2)


@pytest.mark.parametrize("law, kind, ranks", (
    (coulomb(0.5), "rigid", 1), (coulomb(0.5), "rigid", 2),
    ("tied", "rigid", 1), ("tied", "elastic", 2)),
    ids=("sticks", "sticks, two ranks", "tied", "elastic tied"))
def test_stays_on_a_turntable(tmp_path, figures, law, kind, ranks):
    """Sticking or tied bodies go round with a turntable and do not drift off
    along tangents. Coulomb's law holds three times the necessary force."""
    g, friction = 0.02, 0.5
    omega = np.sqrt(0.3*friction*g)
    size = (0.5, g, 0.6)
    elastic = kind == "elastic"
    body = Body(
        cells=(4, 2, 4), name="block", start=(0.75, 0, -0.3), size=size,
        sides={"bottom": "contact"},
        velocity=lambda X: np.cross((0, omega, 0), X),
        material={**RUBBER, "E": 5} if elastic else {
            "type": "rigid", "rho": 1, "force": (0, -g*np.prod(size), 0)})
    case = SmallCase(
        tmp_path, body, 2*np.pi/omega, preset=DEFAULT,
        interfaces=wall(law=law, motion=rotating((0, 0, 0), (0, 1, 0), omega)),
        control={"maxCo": 0.9} if elastic else {"adjustTimeStep": "no",
                                                "deltaT": 0.02},
        gravity=(0, -g, 0) if elastic else None)
    case = case.run() if ranks == 1 else case.runParallel(ranks)
    p = case.momentumOf("block")[:, (0, 2)]
    speed = np.linalg.norm(p, axis=1)/(omega*np.prod(size))
    with figures(f"{kind} block, {law}, {ranks} ranks, one turn") as f:
        f.within("speed after one turn / at first", speed[-1]/speed[0], 1,
                 2e-5)
        f.atMost("angle it lags", abs(np.arctan2(p[-1, 0], -p[-1, 1])), 1e-3)
        if law == "tied":
            f.equal("friction, of what is tied",
                    largest(case.energies["total:frictionDissipation"]), 0)


@pytest.mark.parametrize("cells, step", (
    ((1, 1, 1), 0.02), ((4, 2, 4), 0.005), ((4, 2), 0.02)))
def test_tied_to_a_wall_stays(tmp_path, figures, cells, step):
    """A tied body gives way under a force along the wall as under a force
    normal to it, and stays there."""
    size = (0.5, 0.3, 0.6)
    g = 0.02
    body = Body(cells=cells, name="block", size=size,
                sides={"bottom": "contact"},
                material={"type": "rigid", "rho": 1})
    case = SmallCase(
        tmp_path, body, 100, preset=DEFAULT, gravity=(g, -g, 0),
        interfaces=wall(law="tied"), control={
            "adjustTimeStep": "no", "deltaT": step, "writeInterval": 50}).run()
    bottom = case.X()[:, 1] < 1e-9
    half, end = (case.at("pointD", time)[bottom].mean(axis=0)
                 for time in timeFolders(case.path)[-2:])
    with figures(f"rigid block tied to a wall, {cells}, {step} s a step") as f:
        f.within("way along it / across it", -end[0]/end[1], 1, 1e-2)
        f.atMost("way / height", largest(end)/size[1], 1e-3)
        f.atMost("way in the second half / way", largest(end - half)
                 / largest(end), 1e-9)


def rotating(origin, axis, omega):
    return {"solidBodyMotionFunction": "rotatingMotion",
            "rotatingMotionCoeffs": {"origin": origin, "axis": axis,
                                     "omega": omega}}


# A box that rotates below a block: its corners, faces and points pass the
# block. The numbers are the distance of the highest point from the axis over
# half of the height
WAYS = {
    "corner": ((-0.5, 1.5), (-5, 6), (0, 0, 1), np.sqrt(2)),
    "edge in 3D": ((-0.5, 1.5), (0.2, 0.8), (0, 0, 1), np.sqrt(2)),
    "narrow edge": ((0.3, 0.7), (-0.5, 1.5), (1, 0, 0), np.sqrt(2)),
    "face": ((-1.5, 2.5), (0.2, 0.8), (0, 1, 0), 1)}


@pytest.mark.parametrize("preset", (DEFAULT, PRESET))
@pytest.mark.parametrize("way", WAYS)
def test_turns_past_a_block(tmp_path, figures, way, preset):
    """A box that rotates below a block without touching it moves nothing: the
    planes of its faces end at its edges."""
    (x0, x1), (z0, z1), axis, highest = WAYS[way]
    gap, omega = 0.05, 0.2
    y = -highest - gap
    cells = (8, 8) if way == "corner" else (6, 6, 6)
    case = SmallCase(
        tmp_path, Body(cells=cells, name="block", sides={"bottom": "contact"}),
        np.pi/omega, preset=preset, functions=("contactForces",),
        interfaces=wall({"type": "box", "min": (x0, y - 1, z0),
                         "max": (x1, y + 1, z1)},
                        motion=rotating((0.5, y, 0.5), axis, omega))).run()
    gaps = case.at("contactGap")
    with figures(f"box turns below a block, {way}, {preset}") as f:
        f.equal("largest displacement", largest(case.at("pointD")), 0)
        f.equal("largest force", largest(case.contact("wall")["area"]), 0)
        if way == "face":
            f.within("least gap / that of the face",
                     gaps[gaps > 0].min()/gap, 1, 1e-12)


def wedge(folder, tip, half, depth):
    """Write a file with a triangular prism whose tip points up, from 0.1 to
    0.9 in z."""
    x, y = tip
    corners = np.array([(px, py, z) for z in (0.1, 0.9) for px, py in (
        (x - half, y - depth), (x + half, y - depth), (x, y))])
    faces = ((0, 2, 1), (3, 4, 5), (0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4),
             (2, 0, 3), (2, 3, 5))
    lines = ["solid wedge"]
    for face in faces:
        a, b, c = corners[list(face)]
        n = np.cross(b - a, c - a)
        lines += ["facet normal %g %g %g" % tuple(n/np.linalg.norm(n)),
                  "outer loop"]
        lines += ["vertex %.12g %.12g %.12g" % tuple(p) for p in (a, b, c)]
        lines += ["endloop", "endfacet"]
    folder.mkdir(parents=True)
    (folder/"wedge.stl").write_text("\n".join([*lines, "endsolid wedge", ""]))


def test_wedge_goes_past_a_block(tmp_path, figures):
    """The edge of a thin wedge moves nothing either. It is in front of neither
    of the planes of its faces."""
    gap = 0.05
    wedge(tmp_path/"constant"/"triSurface", (-1, -gap), 0.2, 1)
    case = SmallCase(
        tmp_path, Body(cells=(6, 6, 6), name="block",
                       sides={"bottom": "contact"}), 15, preset=DEFAULT,
        functions=("contactForces",), interfaces=wall(
            {"type": "triSurfaceMesh", "file": "wedge.stl"},
            motion={"velocity": (0.2, 0, 0)})).run()
    with figures("wedge goes past below a block") as f:
        f.equal("largest displacement", largest(case.at("pointD")), 0)


def test_turning_box_as_a_rigid_region(tmp_path, figures):
    """A box that rotates like a door hits a block with its face. Momenta and
    energy agree with those of the same box as a rigid region, and the
    difference falls with the cell size of the block."""
    lo, hi, deep = np.array(((-4, -0.8, 0), (2, -0.2, 1), (0, 0, 1)))
    motion = rotating((-4, -0.2, 0), (0, 0, 1), 0.02)
    apart = []
    for n in 8, 16:
        found = []
        for kind in "obstacle", "region":
            bodies = [Body(cells=(n, n), name="block",
                           sides={"bottom": "contact"})]
            contact = wall({"type": "box", "min": lo - deep, "max": hi + deep},
                           motion=motion)
            if kind == "region":
                bodies += [Body(cells=(6*n, n), name="box", start=lo,
                                size=hi - lo, material=rigid(motion=motion),
                                sides={"top": "contact"})]
                contact = {"wall": interface(
                    ("block", "bottom"), ("box", "top"),
                    pairing="nearestFace")}
            case = SmallCase(tmp_path/f"{n}{kind}", bodies, 4,
                             interfaces=contact, preset=DEFAULT,
                             functions=("contactForces",)).run()
            found.append((*case.momentumOf("block")[-1, :2],
                          case.angularMomentumOf("block")[-1, 2]))
        apart.append(largest(np.subtract(*found))/largest(found))
    with figures("turning box hits a block, obstacle against region") as f:
        f.falling("difference of the momenta / largest", apart)
        f.atMost("on the finer mesh", apart[-1], 1e-3)
        f.atLeast("momentum / mass times speed of the box", found[0][1]/0.09,
                  1.4)


def test_far_away(tmp_path, figures):
    """An obstacle out of reach causes no pairings and no forces."""
    far = {**PLANE, "pointAndNormalDict": {"point": (0, -50, 0),
                                           "normal": (0, 1, 0)}}
    case = SmallCase(tmp_path, block((8, 8)), 3, interfaces=wall(far),
                     functions=("contactForces",))
    code, log = case.attempt()
    with figures("obstacle far away") as f:
        f.equal("exit code", code, 0)
        f.atMost("change of velocity", largest(
            case.at("pointU") - np.array(DOWN)), 1e-14)
        line = next(x for x in log.splitlines() if x.startswith("Contact:"))
        f.equal("pairings of 3 seconds, but that of the write",
                int(line.split(" in ")[1].split()[0]), 0)


def test_beside_an_open_obstacle(tmp_path, figures):
    """A block lies on a floor, four metres beside a higher plate. The run does
    not take it for a body that went through the plate."""
    case = SmallCase(
        tmp_path, Body((4, 4), name="block", start=(0, 0.001, 0),
                       sides={"bottom": "contact"}), 3,
        {**wall(), "shelf": {
            "side": ("block", "bottom"), "obstacle": {
                "type": "searchablePlate", "origin": (5, 2, -1),
                "span": (1, 0, 3)}}}, gravity=(0, -0.01, 0), preset=DEFAULT,
        control={"maxCo": 0.9, "writeInterval": 0.5})
    code, log = case.attempt()
    assert code == 0, log[-3000:]
    with figures("beside a plate") as f:
        f.atMost("displacement / height", largest(case.at("pointD")), 0.02)
