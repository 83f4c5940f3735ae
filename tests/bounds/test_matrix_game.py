import numpy as np
import pytest
from scipy.optimize import linprog

from covey.bounds.matrix_game import best_weights


def by_linear_programme(payoffs):
    rows, columns = payoffs.shape
    found = linprog(
        [0.0] * columns + [1.0],
        A_ub=np.hstack([payoffs, -np.ones((rows, 1))]),
        b_ub=np.zeros(rows),
        A_eq=[[1.0] * columns + [0.0]],
        b_eq=[1.0],
    )
    return found.fun


@pytest.mark.parametrize("seed", range(40))
def test_agrees_with_a_linear_programme(seed):
    generator = np.random.default_rng(seed)
    payoffs = generator.uniform(0.5, 2.0, generator.integers(1, 30, 2))
    if seed % 2:
        payoffs = np.round(payoffs, 1)  # ties
    weights, value = best_weights(payoffs)
    assert value == pytest.approx(by_linear_programme(payoffs), rel=1e-9)
    assert (payoffs @ weights).max() == pytest.approx(value, rel=1e-9)
    assert weights.min() >= 0.0
    assert weights.sum() == pytest.approx(1.0)


def test_matching_pennies():
    weights, value = best_weights(np.array([[2.0, 1.0], [1.0, 2.0]]))
    np.testing.assert_allclose(weights, [0.5, 0.5])
    assert value == pytest.approx(1.5)


def test_a_column_of_zeros_is_best():
    weights, value = best_weights(np.array([[2.0, 0.0], [1.0, 0.0]]))
    np.testing.assert_array_equal(weights, [0.0, 1.0])
    assert value == 0.0
