"""The quadratic programme of a step: its optimality conditions, and another solver."""

from __future__ import annotations

import daqp
import numpy as np
import pytest

from kernels import kernel_calls

OPTIMAL = 1e-9
"""Residual of the optimality conditions, in problems whose numbers are of the order of 1."""
KNOWN_FROM_DAQP = 1e-6
"""DAQP needs a little curvature in z as well, which moves its answer."""


def random_problem(generator, n, m, *, curvature=1.0, box=0.5):
    """Values, gradients, B, pull, low, high."""
    root = generator.normal(size=(n, n))
    matrix = curvature * (root @ root.T + 0.1 * np.eye(n))
    return (
        generator.normal(size=m),
        generator.normal(size=(m, n)),
        matrix,
        0.3 * generator.normal(size=n),
        -box * generator.uniform(0.0, 1.0, n),
        box * generator.uniform(0.0, 1.0, n),
    )


def solve(problem):
    values, gradients, matrix, pull, low, high = problem
    return kernel_calls.best_step(
        values, gradients, kernel_calls.factor_of(matrix), pull, low, high
    )


def gain(problem, step):
    """What is maximised, z at its best for the step."""
    values, gradients, matrix, pull, _, _ = problem
    return (values + gradients @ step).min() + pull @ step - 0.5 * step @ matrix @ step


def assert_optimal(problem, accuracy=OPTIMAL):
    values, gradients, matrix, pull, low, high = problem
    least, step, weights = solve(problem)
    models = values + gradients @ step
    assert (step >= low).all()
    assert (step <= high).all()
    assert least == pytest.approx(models.min(), abs=accuracy)
    assert weights.sum() == pytest.approx(1.0, abs=accuracy)
    assert (weights >= -accuracy).all()
    assert weights @ (models - least) == pytest.approx(0.0, abs=accuracy)
    slope = gradients.T @ weights + pull - matrix @ step
    inside = (step > low + accuracy) & (step < high - accuracy)
    assert np.abs(slope[inside]).max(initial=0.0) <= accuracy
    assert (slope[(step <= low + accuracy) & (low < high)] <= accuracy).all()
    assert (slope[(step >= high - accuracy) & (low < high)] >= -accuracy).all()


@pytest.mark.parametrize("n", [1, 2, 3, 5, 8])
@pytest.mark.parametrize("box", [1e-3, 0.5, 100.0])
def test_optimality_conditions(n, box):
    generator = np.random.default_rng([n, round(1000 * box)])
    for m in (1, 2, n + 1, 2 * n + 4):
        for _ in range(10):
            assert_optimal(random_problem(generator, n, m, box=box))


@pytest.mark.parametrize("n", [1, 2, 4])
def test_little_curvature(n):
    """Close to a linear programme: the step ends in a corner.

    The method starts where one model alone is best, far outside the box, and counts back.
    """
    generator = np.random.default_rng(n)
    for m in (1, n + 1, 2 * n + 4):
        for _ in range(20):
            problem = random_problem(generator, n, m, curvature=1e-6)
            _, gradients, matrix, pull, _, _ = problem
            slopes = gradients + pull
            highest = np.einsum("si,si->s", slopes, np.linalg.solve(matrix, slopes.T).T).max()
            assert_optimal(problem, OPTIMAL + 1e-15 * highest)


@pytest.mark.parametrize("n", [1, 2, 3, 6])
def test_models_twice_or_parallel(n):
    generator = np.random.default_rng(n)
    for _ in range(30):
        values, gradients, *rest = random_problem(generator, n, n + 2)
        twice = np.vstack([gradients, gradients[:2], gradients[:2]])
        level = np.concatenate([values, values[:2], values[:2] + 0.01])
        assert_optimal((level, twice, *rest))


@pytest.mark.parametrize("n", [1, 2, 3, 6])
def test_models_that_all_meet_in_a_point(n):
    """More of them are active than there are variables: which ones carry the weight is open."""
    generator = np.random.default_rng(n)
    for _ in range(30):
        _, gradients, matrix, _, low, high = random_problem(generator, n, 2 * n + 4)
        gradients -= gradients.mean(axis=0)
        assert_optimal((np.ones(2 * n + 4), gradients, matrix, np.zeros(n), low, high))


def test_models_that_are_flat():
    """As for a team that is caught while it turns: nothing to gain, and no step is made."""
    problem = (
        np.array([1.0, 2.0]),
        np.zeros((2, 3)),
        np.eye(3),
        np.zeros(3),
        -np.ones(3),
        np.ones(3),
    )
    least, step, weights = solve(problem)
    assert least == 1.0
    assert not step.any()
    assert weights.tolist() == [1.0, 0.0]


@pytest.mark.parametrize("n", [1, 3])
def test_no_curvature_at_all(n):
    """A flat model and a steep one, and a matrix in which there was nothing to make positive."""
    gradients = np.zeros((2, n))
    gradients[1, 0] = -0.02
    matrix = kernel_calls.made_positive(np.zeros((n, n)))
    for values in ([0.667, 0.666], [0.666, 0.667]):
        assert_optimal((np.array(values), gradients, matrix, np.zeros(n), -np.ones(n), np.ones(n)))


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_no_room_to_one_side(side):
    """At a half turn a bound coincides with the start, and the step may only lead back."""
    low, high = np.array([-1.0, 0.0]), np.array([0.0, 1.0])
    gradients = np.array([[side, side]])
    problem = (np.zeros(1), gradients, np.eye(2), np.zeros(2), low, high)
    assert_optimal(problem)
    assert solve(problem)[1] == pytest.approx(np.clip([side, side], low, high), abs=OPTIMAL)


def test_two_models_in_one_variable_by_hand():
    """1 + d and 2 - d, no curvature to speak of: they cross at d = 1/2, where z = 3/2."""
    problem = (np.array([1.0, 2.0]), np.array([[1.0], [-1.0]]), np.array([[1e-3]]), np.zeros(1),
               np.array([-1.0]), np.array([1.0]))  # fmt: skip
    least, step, weights = solve(problem)
    assert least == pytest.approx(1.5, abs=OPTIMAL)
    assert step[0] == pytest.approx(0.5, abs=OPTIMAL)
    assert weights == pytest.approx([0.50025, 0.49975], abs=OPTIMAL)


@pytest.mark.parametrize("n", [1, 2, 3, 5, 8])
def test_an_indefinite_matrix_made_positive(n):
    generator = np.random.default_rng(n)
    for _ in range(20):
        values, gradients, _, *rest = random_problem(generator, n, n + 3)
        root = generator.normal(size=(n, n))
        matrix = kernel_calls.made_positive(root + root.T)
        least = np.linalg.eigvalsh(matrix)[0]
        assert_optimal((values, gradients, matrix, *rest), OPTIMAL / min(1.0, least))


@pytest.mark.parametrize("n", [1, 2, 3, 5, 8])
def test_agrees_with_daqp(n):
    generator = np.random.default_rng(n)
    for m in (1, 2, n + 1, 2 * n + 4):
        for _ in range(5):
            problem = random_problem(generator, n, m)
            found = gain(problem, solve(problem)[1])
            assert found == pytest.approx(gain(problem, by_daqp(problem)), abs=KNOWN_FROM_DAQP)


def by_daqp(problem):
    """The same step as a minimum over (d, z), z with a curvature too small to matter."""
    values, gradients, matrix, pull, low, high = problem
    n, m = len(pull), len(values)
    curvature = np.zeros((n + 1, n + 1))
    curvature[:n, :n] = matrix
    curvature[n, n] = 1e-8
    slopes = np.append(-pull, -1.0)
    models = np.column_stack([-gradients, np.ones(m)])
    answer, _, ended, _ = daqp.solve(
        curvature,
        slopes,
        models,
        np.concatenate([high, [1e30], values]),
        np.concatenate([low, [-1e30], np.full(m, -1e30)]),
        np.zeros(n + 1 + m, dtype=np.int32),
    )
    assert ended == 1
    return np.clip(answer[:n], low, high)


@pytest.mark.parametrize("flat", [1e-8, 1e-6])
def test_a_flat_direction_with_a_distant_maximum(flat):
    """The first model alone has its maximum far outside the box; the second bounds the gain."""
    values, gradients = [0.62, 0.62 + 5e-8], np.array([[9e-5, 0.0], [0.0, 0.0]])
    factor = np.diag(np.sqrt([flat, 0.08]))
    least, step, _ = kernel_calls.best_step(
        values, gradients, factor, [0.0] * 2, [-1.0] * 2, [1.0] * 2
    )
    assert least - 0.62 == pytest.approx(5e-8, abs=1e-12)
    assert step == pytest.approx([5e-8 / 9e-5, 0.0], abs=1e-8)
