"""The kernels, called with teams and disks: the one place where tests know their arguments.

As in covey itself, the origin is the disk's centre.
"""

from __future__ import annotations

import math

import numpy as np

from covey.kernels.capture.derivatives import (
    CAPTURE_ROW,
    Captures,
    add_curvature,
    differentiate,
)
from covey.kernels.capture.path import position, velocity
from covey.kernels.capture.sequence import capture_times
from covey.kernels.linalg import quadratic_program as qp
from covey.kernels.linalg.active_set import QuadraticScratch
from covey.kernels.linalg.symmetric import cholesky, make_positive
from covey.kernels.maximum.values import minimum_over_sequences
from covey.kernels.minimum.greedy_sequence import greedy_sequence, nearest_first
from covey.model import PursuerDisk
from covey.planning import border
from covey.planning.border import about_center, pursuit_of
from covey.planning.workspace import workspace


def paths_of(team, turns, pursuer_speed=1.0):
    """The paths (eq. 5) as the kernels read them."""
    return border.paths_of(team, PursuerDisk(speed=pursuer_speed), turns)


def place(team, turns, i, time):
    """Position of evader i, (2,)."""
    return np.array(position(paths_of(team, turns), i, float(time)))


def motion(team, turns, i, time):
    """Velocity of evader i, (2,)."""
    return np.array(velocity(paths_of(team, turns), i, float(time)))


def least(team, disk, turns, bound=math.inf, sequence=None, total=False):
    """The least time below `bound`, else `bound`; the `sequence` that needs it, else as given."""
    team, disk = about_center(team, disk)
    n = len(team)
    found = np.zeros(n, np.int64) if sequence is None else np.array(sequence, np.int64)
    checked, scratch = np.array(turns, float), workspace(n, total)
    value = minimum_over_sequences(
        team.as_rows(), checked, pursuit_of(disk), total, bound, found, scratch
    )
    return value, found


def least_sum(team, disk, turns, bound=math.inf, sequence=None):
    """As `least`, of the sum of all capture times."""
    return least(team, disk, turns, bound, sequence, total=True)


def greedy(team, disk, turns):
    """A sequence that is short at first sight, and its capture times."""
    team, disk = about_center(team, disk)
    order, times = np.empty(len(team), np.int64), np.empty(len(team))
    last = greedy_sequence(paths_of(team, turns, disk.speed), pursuit_of(disk), order, times)
    assert last == times[-1]
    return order, times


def nearest(team, disk, turns):
    """The last capture where whoever can be captured soonest is next."""
    team, disk = about_center(team, disk)
    order, times = np.empty(len(team), np.int64), np.empty(len(team))
    return nearest_first(paths_of(team, turns, disk.speed), pursuit_of(disk), -1, order, times)


def times_of_sequences(team, disk, sequences):
    """A function of the turns, (M,) times of the last capture for M given sequences: quick f_s."""
    team, disk = about_center(team, disk)
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
    gradient, lower = np.empty(n), np.zeros((n, n))
    captures = Captures(np.empty(n), np.empty((n, CAPTURE_ROW)), np.empty((3, n)))
    capture_times(paths, pursuit, order, captures.times)
    differentiate(paths, pursuit, order, total, captures, gradient)
    add_curvature(paths, pursuit, order, captures, 1.0, lower)
    return gradient, np.tril(lower) + np.tril(lower, -1).T


def factor_of(matrix, floor=0.0):
    """The Cholesky factor (N, N) of a symmetric matrix, or None if it isn't positive definite."""
    factor = np.zeros_like(matrix)
    found = cholesky(np.tril(matrix), len(matrix), floor, factor)
    return with_diagonal_inverted(factor) if found else None


def with_diagonal_inverted(factor):
    """The Cholesky factor as the kernels keep it, or the one that they keep."""
    return np.tril(factor, -1) + np.diag(1.0 / np.diag(factor))


def made_positive(matrix, floor=0.0):
    """The positive definite matrix (N, N) that takes the place of a symmetric one."""
    n, lower = len(matrix), np.tril(matrix)
    make_positive(lower, n, floor, np.empty((n, n)), np.empty(n))
    return np.tril(lower) + np.tril(lower, -1).T


def best_step(values, gradients, factor, linear, lower, upper):
    """What `solve_quadratic` finds: z, the step (N,) and the multipliers (M,)."""
    m, n = gradients.shape
    program = qp.QuadraticProgram(
        np.asarray(values, dtype=float),
        np.ascontiguousarray(gradients),
        with_diagonal_inverted(factor),
        np.asarray(linear, dtype=float),
        np.asarray(lower, dtype=float),
        np.asarray(upper, dtype=float),
    )
    solution = qp.Solution(np.empty(n), np.empty(m))
    scratch = QuadraticScratch(
        whitened=np.empty((m + 2 * n, n)),
        active=np.empty(n + 2, np.int64),
        multipliers=np.empty(n + 2),
        gram=np.empty((n + 2, n + 2)),
        ones=np.empty(n + 2),
        direction=np.empty(n + 2),
        combined=np.empty(n),
    )
    z = qp.solve_quadratic(program, solution, scratch)
    return z, solution.step, solution.multipliers
