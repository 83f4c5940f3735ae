"""The value of a matrix game: weights of the columns for which the largest row is least."""

from __future__ import annotations

import numpy as np

from covey.model.validation import Floats

_TOLERANCE = 1e-12


def best_weights(payoffs: Floats) -> tuple[Floats, float]:
    """Return weights (m,), >= 0 and summing to one, that minimise the largest mean, and that mean.

    Parameters
    ----------
    payoffs
        (k, m) positive; the weights mix the columns.

    Notes
    -----
    With y = weights / value the game is the linear programme: maximise the sum of y, with
    payoffs y <= 1 and y >= 0. The simplex method starts from y = 0; Bland's rule keeps it from
    cycling.
    """
    rows, columns = payoffs.shape
    scale = payoffs.max()
    table = np.zeros((rows + 1, columns + rows + 1))
    table[:-1, :columns] = payoffs / scale
    table[:-1, columns:-1] = np.eye(rows)
    table[:-1, -1] = 1.0
    table[-1, :columns] = -1.0
    basis = np.arange(columns, columns + rows)
    while (table[-1, :-1] < -_TOLERANCE).any():
        entering = int(np.argmax(table[-1, :-1] < -_TOLERANCE))
        column = table[:-1, entering]
        ratios = np.full(rows, np.inf)
        np.divide(table[:-1, -1], column, out=ratios, where=column > _TOLERANCE)
        ties = np.flatnonzero(ratios <= ratios.min())
        leaving = int(ties[basis[ties].argmin()])
        table[leaving] /= table[leaving, entering]
        others = np.arange(rows + 1) != leaving
        table[others] -= np.outer(table[others, entering], table[leaving])
        basis[leaving] = entering
    solution = np.zeros(columns + rows)
    solution[basis] = table[:-1, -1]
    total = solution[:columns].sum()
    return solution[:columns] / total, float(scale / total)
