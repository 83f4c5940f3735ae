"""Symmetric matrices: Cholesky's factor, Jacobi's eigenvectors, a positive definite replacement.

Matrices are given and returned in their lower triangles.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled
from covey.kernels.arrays import Floats

_TINY = 1e-8
_FIRST_SHIFT = 1e-3  # of the largest diagonal entry
_MAX_SWEEPS = 30


@compiled
def cholesky(matrix: Floats, n: int, floor: float, factor: Floats) -> bool:
    """Write the Cholesky factor; return whether `matrix` is positive definite beyond rounding.

    Pivots must be above the `floor`. The factor's diagonal is inverted, so that solving with the
    factor multiplies where it would divide.
    """
    least = floor
    for i in range(n):
        least = max(least, _TINY * abs(matrix[i, i]))
    for j in range(n):
        pivot = matrix[j, j]
        for k in range(j):
            pivot -= factor[j, k] * factor[j, k]
        if not pivot > least:
            return False
        inverse = 1.0 / math.sqrt(pivot)
        factor[j, j] = inverse
        for i in range(j + 1, n):
            entry = matrix[i, j]
            for k in range(j):
                entry -= factor[i, k] * factor[j, k]
            factor[i, j] = entry * inverse
    return True


@compiled
def shifted_cholesky(matrix: Floats, n: int, floor: float, factor: Floats) -> bool:
    """Write the Cholesky factor; where `matrix` isn't positive definite, of a shifted matrix.

    The shift is added to the diagonal of `matrix`, and is made four times as large until a factor
    exists; each trial costs a factor, far less than the eigenvalues of a large matrix. Returns
    whether there is a shift.
    """
    if cholesky(matrix, n, floor, factor):
        return False
    size = floor
    for i in range(n):
        size = max(size, abs(matrix[i, i]))
    shift = _FIRST_SHIFT * size if size > 0.0 else 1.0
    added = 0.0
    while True:
        for i in range(n):
            matrix[i, i] += shift - added
        if cholesky(matrix, n, floor, factor):
            return True
        added, shift = shift, 4.0 * shift


@compiled
def make_positive(
    matrix: Floats, n: int, floor: float, eigenvectors: Floats, eigenvalues: Floats
) -> None:
    """Replace each eigenvalue by its absolute value, so that the matrix is positive definite.

    Eigenvalues below 1e-7 of the largest, or below ten times the `floor`, are raised to these
    bounds. Where all eigenvalues and the floor are zero, they are raised to one. A Newton step then
    climbs away from a saddle as fast as it approaches a maximum. `eigenvectors` (n, n) and
    `eigenvalues` (n,) are scratch.
    """
    jacobi_eigen(matrix, n, eigenvectors)
    least = 10.0 * floor
    for i in range(n):
        eigenvalues[i] = abs(matrix[i, i])
        least = max(least, 10.0 * _TINY * eigenvalues[i])
    for i in range(n):
        eigenvalues[i] = max(eigenvalues[i], least) if least > 0.0 else 1.0
    for i in range(n):
        for j in range(i + 1):
            total = 0.0
            for k in range(n):
                total += eigenvalues[k] * eigenvectors[i, k] * eigenvectors[j, k]
            matrix[i, j] = total


@compiled
def jacobi_eigen(matrix: Floats, n: int, eigenvectors: Floats) -> None:
    """Jacobi's method: rotate until the matrix is diagonal; write the eigenvectors."""
    for i in range(n):
        for j in range(n):
            eigenvectors[i, j] = 1.0 if i == j else 0.0
    for _ in range(_MAX_SWEEPS):
        off = diagonal = 0.0
        for i in range(n):
            diagonal += matrix[i, i] * matrix[i, i]
            for j in range(i):
                off += matrix[i, j] * matrix[i, j]
        if off <= 1e-24 * diagonal:
            return
        for p in range(n):
            for q in range(p):
                if matrix[p, q] != 0.0:
                    _rotate(matrix, n, eigenvectors, p, q)


@compiled
def _rotate(matrix: Floats, n: int, eigenvectors: Floats, p: int, q: int) -> None:
    """Make entry (p, q), q < p, zero by a rotation in the plane of p and q."""
    entry = matrix[p, q]
    slope = 0.5 * (matrix[q, q] - matrix[p, p]) / entry
    tangent = math.copysign(1.0, slope) / (abs(slope) + math.sqrt(slope * slope + 1.0))
    cosine = 1.0 / math.sqrt(tangent * tangent + 1.0)
    sine = tangent * cosine
    matrix[p, p] -= tangent * entry
    matrix[q, q] += tangent * entry
    matrix[p, q] = 0.0
    for k in range(q):
        at_p, at_q = matrix[p, k], matrix[q, k]
        matrix[p, k], matrix[q, k] = cosine * at_p - sine * at_q, cosine * at_q + sine * at_p
    for k in range(q + 1, p):
        at_p, at_q = matrix[p, k], matrix[k, q]
        matrix[p, k], matrix[k, q] = cosine * at_p - sine * at_q, cosine * at_q + sine * at_p
    for k in range(p + 1, n):
        at_p, at_q = matrix[k, p], matrix[k, q]
        matrix[k, p], matrix[k, q] = cosine * at_p - sine * at_q, cosine * at_q + sine * at_p
    for k in range(n):
        vector_p, vector_q = eigenvectors[k, p], eigenvectors[k, q]
        eigenvectors[k, p] = cosine * vector_p - sine * vector_q
        eigenvectors[k, q] = cosine * vector_q + sine * vector_p
