"""Cholesky factors where there are any, and a definite matrix in place of one that isn't."""

from __future__ import annotations

import numpy as np
import pytest

from kernels import kernel_calls

ROUNDING = 1e-13
"""Relative to the largest entry, for matrices of up to eight rows."""
DIAGONAL = 1e-11
"""Likewise, where the matrix is made diagonal to 1e-12 on the way."""


def random_symmetric(generator, sizes):
    """A symmetric matrix with the eigenvalues given."""
    frame, _ = np.linalg.qr(generator.normal(size=(len(sizes), len(sizes))))
    return frame @ np.diag(sizes) @ frame.T


@pytest.mark.parametrize("n", range(1, 9))
def test_factor_multiplies_to_the_matrix(n):
    generator = np.random.default_rng(n)
    for scale in (1e-9, 1.0, 1e9):
        matrix = random_symmetric(generator, scale * generator.uniform(0.01, 1.0, n))
        factor = kernel_calls.factor_of(matrix)
        assert factor @ factor.T == pytest.approx(matrix, abs=ROUNDING * scale)


@pytest.mark.parametrize("n", range(1, 9))
def test_no_factor_unless_positive_definite(n):
    generator = np.random.default_rng(n)
    sizes = generator.uniform(0.1, 1.0, n)
    for bad in (-1.0, -1e-3, 0.0):
        sizes[0] = bad
        assert kernel_calls.factor_of(random_symmetric(generator, sizes)) is None


@pytest.mark.parametrize("n", range(1, 9))
def test_made_positive_by_turning_round_what_is_negative(n):
    generator = np.random.default_rng(n)
    for scale in (1e-9, 1.0, 1e9):
        sizes = scale * generator.uniform(0.01, 1.0, n) * generator.choice([-1.0, 1.0], n)
        matrix = random_symmetric(generator, sizes)
        values, frame = np.linalg.eigh(matrix)
        wanted = frame @ np.diag(np.abs(values)) @ frame.T
        assert kernel_calls.made_positive(matrix) == pytest.approx(wanted, abs=DIAGONAL * scale)


@pytest.mark.parametrize(
    "matrix",
    [
        np.zeros((1, 1)),
        np.zeros((3, 3)),
        np.ones((3, 3)),
        -np.ones((4, 4)),
        np.diag([1.0, 0, -1.0]),
    ],
    ids=["nothing", "zeros", "ones", "minus ones", "diagonal"],
)
def test_what_is_made_positive_has_a_factor(matrix):
    """However flat the matrix was."""
    positive = kernel_calls.made_positive(matrix)
    factor = kernel_calls.factor_of(positive)
    assert factor is not None
    assert np.isfinite(factor).all()
    assert factor @ factor.T == pytest.approx(positive, abs=ROUNDING)


@pytest.mark.parametrize("flat", [0.0, 1e-12, -1e-12])
def test_no_flatter_than_the_floor(flat):
    """What leads a step further away than it can be computed."""
    generator = np.random.default_rng(1)
    matrix, floor = random_symmetric(generator, [flat, 1e-9, 0.5]), 1e-4
    assert kernel_calls.factor_of(matrix, floor) is None
    sizes = np.linalg.eigvalsh(kernel_calls.made_positive(matrix, floor))
    assert sizes == pytest.approx([10.0 * floor, 10.0 * floor, 0.5], rel=1e-9)
    assert kernel_calls.factor_of(kernel_calls.made_positive(matrix, floor), floor) is not None
