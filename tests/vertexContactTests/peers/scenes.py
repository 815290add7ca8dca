"""The cases, with the geometry, constants and velocities of the tutorials."""

from dataclasses import dataclass

import numpy as np

from vertexContactTests.peers.meshes import Mesh, block, joined


@dataclass
class Scene:
    """A body, its obstacle, and the observed points."""

    mesh: Mesh
    material: tuple         # lines of the deck
    rho: float
    velocity: np.ndarray
    fixed: tuple            # (points, direction)
    end: float
    step: float             # of time, at most
    axis: int               # direction of the impact
    probes: dict            # points
    bodies: int = 1         # number of bodies in the case; this is one of them
    thickness: float = 1    # histories are per metre
    # A fixed plate instead of the plane: the corners of its face, towards the
    # body; and the points of the body that may touch it
    plate: tuple = ()
    touching: tuple = ()
    stiffness: float = 0    # of contact [Pa/m]
    hardening: tuple = ()   # yield stress, modulus
    element: str = "C3D8"
    alpha: float = 0        # of the time integration; 0: no damping
    samples: int = 400


def neoHooke(E, nu):
    """W = mu/2 (J^(-2/3) F:F - 3) + kappa/2 (J - 1)^2, as in our law."""
    return ("*HYPERELASTIC,NEO HOOKE",
            f"{E/4/(1 + nu):.12g},{6*(1 - 2*nu)/E:.12g}")


def waves(E, nu, rho):
    """Speed of pressure waves."""
    return np.sqrt(E*(1 - nu)/(1 + nu)/(1 - 2*nu)/rho)


def column(n):
    """tutorials/twistingColumn"""
    E, nu, rho = 17e6, 0.3, 1100
    mesh = block((n, 6*n, n), lambda x, y, z: (x - 0.5, 6*y, z - 0.5))
    X, Y, Z = mesh.points.T
    omega = 105*np.sin(np.pi*Y/12)
    base = mesh.where(1, 0)
    return Scene(
        mesh, neoHooke(E, nu), rho,
        np.stack([omega*Z, 0*Y, -omega*X], 1),
        tuple((base, d) for d in range(3)), 0.1,
        0.5/n/waves(E, nu, rho), 0, {"probe": mesh.nearest((0.5, 6, 0.5))},
        # A larger value would need more steps
        samples=20)


def rings(n):
    """tutorials/ringCollision: ring 1 against the plane of symmetry. One layer
    of elements, as thick as they are wide."""
    E, nu, rho = 1e6, 0.4, 1000
    quarter = {10: 31, 20: 63, 40: 127, 80: 255}.get(n, n*63//20)
    layer = 0.01/n

    def place(r, a, z):
        radius, angle = 0.03 + 0.01*r, 2*np.pi*a
        return (radius*np.cos(angle), radius*np.sin(angle), layer*z)

    mesh = joined(block((n, 4*quarter, 1), place))
    velocity = np.zeros_like(mesh.points)
    velocity[:, 0] = 0.59
    outer = np.hypot(*mesh.points.T[:2]) > 0.04 - 1e-9
    wall = 0.044
    return Scene(
        mesh, neoHooke(E, nu), rho, velocity,
        ((np.arange(len(mesh.points)), 2),), 0.04,
        0.8*layer/waves(E, nu, rho), 0,
        {"probe": mesh.nearest((0.04, 0, 0))}, 2, layer,
        tuple((wall, 0.06*s, layer*t) for s, t in
              ((-1, -1), (1, -1), (1, 2), (-1, 2))),
        tuple(np.flatnonzero(outer & (mesh.points[:, 0] > 0))),
        # Half of the stiffness of the elements: ten times as much gains energy
        0.5*E/layer, alpha=-0.3)


def quarterRod(n):
    """The mesh of tutorials/taylorBar: a core, two blocks around it."""
    R, core, corner, length = 3.2e-3, 1.6e-3, 1.376e-3, 32.4e-3
    half, along = n//2, 9*n

    def across(a, b):
        return a*(core + b*(corner - core))

    def ring(out, turn):
        angle = turn*np.pi/4
        return ((1 - out)*(core + turn*(corner - core))
                + out*R*np.cos(angle),
                (1 - out)*turn*corner + out*R*np.sin(angle))

    def right(x, y, z):
        far, near = ring(x, z)
        return far, length*y, near

    def left(x, y, z):
        # In the other order the elements would be inside out
        far, near = ring(x, 1 - z)
        return near, length*y, far

    def middle(x, y, z):
        return across(x, z), length*y, across(z, x)

    return joined(*(block((half, along, half), place)
                    for place in (middle, right, left)))


def taylor(n):
    """tutorials/taylorBar: the foot stays on the wall."""
    E, nu, rho, yields, modulus = 117e9, 0.35, 8930, 0.4e9, 0.1e9
    mesh = quarterRod(n)
    velocity = np.zeros_like(mesh.points)
    velocity[:, 1] = -227
    return Scene(
        mesh, ("*ELASTIC", f"{E:g},{nu:g}", "*PLASTIC",
               f"{yields:g},0", f"{yields + 10*modulus:g},10"), rho, velocity,
        tuple((mesh.where(d, 0), d) for d in range(3)), 80e-6,
        # The height of the foot becomes a tenth
        0.1*3.2e-3/n/waves(E, nu, rho), 1,
        {"probe": mesh.nearest((0, 32.4e-3, 0)),
         "rim": mesh.nearest((3.2e-3, 0, 0))}, hardening=(yields, modulus),
        # Full integration locks
        element="C3D8R")


SCENES = {"column": column, "rings": rings, "taylor": taylor}
