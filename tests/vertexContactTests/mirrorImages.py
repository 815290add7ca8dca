"""Cases of two bodies that are mirror images of each other."""

import numpy as np

# Signs of vectors and symmetric tensors (xx xy xz yy yz zz) in a mirror in x
VECTOR = np.array((-1, 1, 1))
SYMM = np.array((1, -1, -1, 1, 1, 1))


def partners(case, left, right, plane, tolerance=1e-9):
    """For each point of the left body, the index of its mirror image in the
    right body."""
    def rows(X):
        keys = np.round(X/tolerance).astype(np.int64)
        return np.lexsort(keys.T[::-1])

    A, B = case.points(left), case.points(right)
    image = A*VECTOR + np.array((2*plane, 0, 0))
    a, b = rows(image), rows(B)
    if np.abs(image[a] - B[b]).max() > 10*tolerance:
        raise ValueError(f"{left} and {right} are not mirror images of each other")
    index = np.empty(len(A), dtype=int)
    index[a] = b
    return index


def asymmetry(case, left, right, plane):
    """Largest difference of velocity, displacement and stress from the mirror
    image at any written time, relative to the largest value of the field."""
    index = partners(case, left, right, plane)
    worst = 0.0
    for name, signs in (("pointU", VECTOR), ("pointD", VECTOR),
                        ("sigma", SYMM)):
        difference = largest = 0.0
        for time in case.times:
            a, b = case.field(time, left, name), case.field(time, right, name)
            difference = max(difference, np.abs(a - signs*b[index]).max())
            largest = max(largest, np.abs(a).max())
        worst = max(worst, difference/largest)
    return worst
