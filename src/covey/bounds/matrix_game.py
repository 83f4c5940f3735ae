"""The value of a matrix game: weights of the columns for which the largest row is least."""

from __future__ import annotations

import numpy as np

from covey.model.validation import Floats, Ints

_TOLERANCE = 1e-12

_MOST_PIVOTS = 10_000


def best_weights(payoffs: Floats) -> tuple[Floats, float]:
    """Return weights (m,), >= 0 and summing to one, that minimise the largest mean, and that mean.

    Parameters
    ----------
    payoffs
        (k, m), none negative; the weights mix the columns.

    Notes
    -----
    With y = weights / value the game is the linear programme: maximise the sum of y, with
    payoffs y <= 1 and y >= 0. The simplex method starts from y = 0; Bland's rule keeps it from
    cycling.
    """
    rows, columns = payoffs.shape
    largest = payoffs.max(axis=0)
    if largest.min() == 0.0:
        return np.eye(columns)[largest.argmin()], 0.0
    scale = largest.max()
    table = np.zeros((rows + 1, columns + rows + 1))
    table[:-1, :columns] = payoffs / scale
    table[:-1, columns:-1] = np.eye(rows)
    table[:-1, -1] = 1.0
    table[-1, :columns] = -1.0
    basis = np.arange(columns, columns + rows)
    for _ in range(_MOST_PIVOTS):
        improving = table[-1, :-1] < -_TOLERANCE
        if not improving.any():
            break
        _pivot(table, basis, int(improving.argmax()))
    solution = np.zeros(columns + rows)
    solution[basis] = table[:-1, -1]
    weights = solution[:columns] / solution[:columns].sum()
    return weights, float((payoffs @ weights).max())


def _pivot(table: Floats, basis: Ints, entering: int) -> None:
    """Bring a variable into the basis; both are modified in place."""
    column = table[:-1, entering]
    ratios = np.full(len(basis), np.inf)
    np.divide(table[:-1, -1], column, out=ratios, where=column > _TOLERANCE)
    ties = np.flatnonzero(ratios <= ratios.min())
    leaving = int(ties[basis[ties].argmin()])
    table[leaving] /= table[leaving, entering]
    others = np.arange(len(table)) != leaving
    table[others] -= np.outer(table[others, entering], table[leaving])
    basis[leaving] = entering
