"""The kernels, called with teams and disks: the one place where tests know their arguments."""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from covey.kernels.capture.path import PATH, position, set_paths, velocity
from covey.kernels.capture.sequence import CAPTURE, add_curvature, capture_times, differentiate
from covey.kernels.linalg.quadratic_program import quadratic_scratch, solve_quadratic
from covey.kernels.linalg.symmetric import factorise, make_positive
from covey.kernels.minimum.greedy_sequence import nearest_first, short_sequence
from covey.kernels.minimum.last_capture import least_time, subset_scratch
from covey.kernels.minimum.total_time import least_total, total_scratch
from covey.planning.guarantee import pursuit_of


def paths_of(team, turns, pursuer_speed=1.0):
    """The paths (eq. 5) as the kernels read them."""
    paths = np.empty((len(team), PATH))
    set_paths(team.as_rows(), np.asarray(turns, dtype=float), pursuer_speed, paths)
    return paths


def place(team, turns, i, time):
    """Position of evader i, (2,)."""
    return np.array(position(paths_of(team, turns), i, float(time)))


def motion(team, turns, i, time):
    """Velocity of evader i, (2,)."""
    return np.array(velocity(paths_of(team, turns), i, float(time)))


_scratch = cache(subset_scratch)  # used again and again, as in a search
_total_scratch = cache(total_scratch)


def least(team, disk, turns, bound=math.inf, sequence=None):
    """The least time below `bound`, else `bound`; the `sequence` that needs it, else as given."""
    n = len(team)
    found = np.zeros(n, np.int64) if sequence is None else np.array(sequence, np.int64)
    paths = paths_of(team, turns, disk.speed)
    time, _ = least_time(paths, n, pursuit_of(disk), bound, found, _scratch(n))
    return time, found


def short(team, disk, turns):
    """A sequence that is short at first sight, and its capture times."""
    order, times = np.empty(len(team), np.int64), np.empty(len(team))
    paths = paths_of(team, turns, disk.speed)
    last = short_sequence(paths, len(team), pursuit_of(disk), order, times)
    assert last == times[-1]
    return order, times


def nearest(team, disk, turns):
    """The last capture where whoever can be captured soonest is next."""
    order, times = np.empty(len(team), np.int64), np.empty(len(team))
    paths = paths_of(team, turns, disk.speed)
    return nearest_first(paths, len(team), pursuit_of(disk), -1, order, times)


def least_sum(team, disk, turns, bound=math.inf, sequence=None):
    """As `least`, of the sum of all capture times."""
    n = len(team)
    found = np.zeros(n, np.int64) if sequence is None else np.array(sequence, np.int64)
    paths = paths_of(team, turns, disk.speed)
    value, _ = least_total(paths, n, pursuit_of(disk), bound, found, _total_scratch(n))
    return value, found


def times_of_sequences(team, disk, sequences):
    """A function of the turns, (M,) times of the last capture for M given sequences: quick f_s."""
    orders = [np.array(sequence, np.int64) for sequence in sequences]
    pursuit, times = pursuit_of(disk), np.empty(len(team))

    def values(turns):
        paths = paths_of(team, turns, disk.speed)
        return np.array([capture_times(paths, pursuit, order, times) for order in orders])

    return values


def derivatives(team, disk, turns, sequence, total=False):
    """Gradient (N,) and Hessian (N, N) of the last capture time, or the sum, by the turns."""
    n = len(team)
    paths, pursuit = paths_of(team, turns, disk.speed), pursuit_of(disk)
    order = np.array(sequence, np.int64)
    times, captures, gradient = np.empty(n), np.empty((n, CAPTURE)), np.empty(n)
    lower = np.zeros((n, n))
    capture_times(paths, pursuit, order, times)
    differentiate(paths, pursuit, order, total, times, captures, gradient)
    add_curvature(paths, pursuit, order, times, captures, 1.0, np.empty((3, n)), lower)
    return gradient, np.tril(lower) + np.tril(lower, -1).T


def factor_of(matrix, floor=0.0):
    """The Cholesky factor (N, N) of a symmetric matrix, or None if it isn't positive definite."""
    factor = np.zeros_like(matrix)
    found = factorise(np.tril(matrix), len(matrix), floor, factor)
    return with_diagonal_inverted(factor) if found else None


def with_diagonal_inverted(factor):
    """The Cholesky factor as the kernels keep it, or the one that they keep."""
    return np.tril(factor, -1) + np.diag(1.0 / np.diag(factor))


def made_positive(matrix, floor=0.0):
    """The positive definite matrix (N, N) that takes the place of a symmetric one."""
    n, lower = len(matrix), np.tril(matrix)
    make_positive(lower, n, floor, np.empty((n, n)), np.empty(n))
    return np.tril(lower) + np.tril(lower, -1).T


def best_step(values, gradients, factor, pull, low, high):
    """What `solve_quadratic` finds: z, the step (N,) and the weights (M,)."""
    m, n = gradients.shape
    step, weights = np.empty(n), np.empty(m)
    least = solve_quadratic(
        n,
        m,
        np.asarray(values, dtype=float),
        np.ascontiguousarray(gradients),
        with_diagonal_inverted(factor),
        np.asarray(pull, dtype=float),
        np.asarray(low, dtype=float),
        np.asarray(high, dtype=float),
        step,
        weights,
        quadratic_scratch(n, m),
    )
    return least, step, weights
