"""Meshes of hexahedra, those of the tutorials, and their masses."""

from dataclasses import dataclass

import numpy as np

# Numbered as finite elements are
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
           (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))


@dataclass
class Mesh:
    points: np.ndarray
    elements: np.ndarray    # rows of eight points each, from 0

    def nearest(self, place):
        return int(np.argmin(np.linalg.norm(self.points - place, axis=1)))

    def where(self, axis, value):
        """Indices of the points in a plane."""
        return np.flatnonzero(abs(self.points[:, axis] - value) < 1e-9)

    def volumes(self):
        """Volumes of the nodes and of the elements: integrals of the shape
        functions and of one."""
        signs = 2*np.array(CORNERS) - 1
        corners = self.points[self.elements]
        shares = np.zeros((len(self.elements), 8))
        for point in signs/np.sqrt(3):
            terms = 1 + signs*point
            slopes = np.stack([
                signs[:, d]*np.prod(np.delete(terms, d, 1), 1)/8
                for d in range(3)], 1)
            J = np.linalg.det(np.einsum("eni,nj->eij", corners, slopes))
            if J.min() <= 0:
                raise ValueError("an element is inside out")
            shares += J[:, None]*np.prod(terms, 1)/8
        nodes = np.zeros(len(self.points))
        np.add.at(nodes, self.elements, shares)
        return nodes, shares.sum(1)


def block(counts, place):
    """A block. counts: elements along each coordinate; place: map from the
    unit cube."""
    size = [n + 1 for n in counts]
    number = np.arange(np.prod(size)).reshape(size)
    unit = np.stack(np.meshgrid(
        *(np.linspace(0, 1, s) for s in size), indexing="ij"), -1)
    elements = [number[tuple(slice(a, a + n) for a, n in zip(c, counts))]
                for c in CORNERS]
    return Mesh(np.array([place(*p) for p in unit.reshape(-1, 3)]),
                np.stack(elements, -1).reshape(-1, 8))


def joined(*blocks):
    """One mesh of several blocks: points at the same place become one."""
    points = np.concatenate([b.points for b in blocks])
    starts = np.cumsum([0] + [len(b.points) for b in blocks])
    elements = np.concatenate(
        [b.elements + s for b, s in zip(blocks, starts)])
    size = abs(points).max()
    _, first, number = np.unique(
        np.round(points/size, 9) + 0., axis=0, return_index=True,
        return_inverse=True)
    return Mesh(points[first], number.reshape(-1)[elements])
