"""The latest last capture in one known sequence: a dynamic programme over each evader's turn.

A capture that comes later on the same path delays every later one, for the pursuer is the faster.
So of all turns of the evaders before it, an evader on a given path needs only those that have
*itself* captured latest, and the maximum over N turns falls into N maxima over one. On a grid of
turns it is exact; finer and finer grids around the best turns then close in on the maximum.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import allocating, compiled
from covey.kernels.interception import earliest_capture
from covey.kernels.path import EVADER, PATH, TURN_RATE, position, set_paths
from covey.kernels.types import Floats, Ints, Pursuit, Table

COARSE = 65
"""Turns of each evader on the first grid, which covers all of [-π, π]."""

FINE = 9
"""Turns of each evader on the grids that close in."""

_MOST_ROUNDS = 200


class Grid(NamedTuple):
    """A grid of `nodes` turns for each of n evaders; evader i has rows i * nodes onward."""

    evaders: Table  # (n * nodes, EVADER)
    turns: Floats  # (n * nodes,)
    paths: Table  # (n * nodes, PATH)
    latest: Floats  # (n, nodes) latest capture by place in the sequence
    before: Ints  # (n, nodes) the node of the evader before, with which it is attained


@allocating
def make_grid(evaders: Table, nodes: int) -> Grid:
    """Allocate a grid for these evaders."""
    n = len(evaders)
    repeated = np.empty((n * nodes, EVADER))
    for row in range(n * nodes):
        repeated[row] = evaders[row // nodes]
    return Grid(
        repeated,
        np.empty(n * nodes),
        np.empty((n * nodes, PATH)),
        np.empty((n, nodes)),
        np.empty((n, nodes), np.int64),
    )


@compiled
def lay_grid(grid: Grid, centers: Floats, width: float, pursuer_speed: float) -> None:
    """Spread every evader's turns over `width` to both sides of its centre.

    The nearest come first, so that among equals the smallest change of the turn wins. Turns at a
    limited rate stay within [-π, π]; others go round.
    """
    nodes = grid.latest.shape[1]
    spacing = width / (nodes // 2)
    for row in range(len(grid.turns)):
        i, j = row // nodes, row % nodes
        turn = centers[i] + spacing * ((j + 1) // 2) * (1.0 if j % 2 else -1.0)
        rate = grid.evaders[row, TURN_RATE]
        if not math.isinf(rate):
            turn = min(max(turn, -math.pi), math.pi)
        grid.turns[row] = turn if rate > 0.0 else 0.0
    set_paths(grid.evaders, grid.turns, pursuer_speed, grid.paths)


@compiled
def first_captures(grid: Grid, pursuit: Pursuit, i: int) -> None:
    """Write when evader i, on each of its paths, is captured first of all."""
    nodes = grid.latest.shape[1]
    for j in range(nodes):
        grid.latest[0, j] = earliest_capture(
            grid.paths,
            i * nodes + j,
            pursuit.center_x,
            pursuit.center_y,
            pursuit.first_radius,
            0.0,
            pursuit.speed,
        )


@compiled
def next_captures(grid: Grid, pursuit: Pursuit, k: int, previous: int, i: int) -> None:
    """Write the latest k-th capture of evader i on each of its paths, after that of `previous`."""
    nodes = grid.latest.shape[1]
    for j in range(nodes):
        grid.latest[k, j] = -math.inf
    for b in range(nodes):
        time = grid.latest[k - 1, b]
        x, y = position(grid.paths, previous * nodes + b, time)
        for j in range(nodes):
            capture = earliest_capture(
                grid.paths, i * nodes + j, x, y, pursuit.later_radius, time, pursuit.speed
            )
            if capture > grid.latest[k, j]:
                grid.latest[k, j], grid.before[k, j] = capture, b


@compiled
def best_on_grid(grid: Grid, pursuit: Pursuit, sequence: Ints, turns: Floats) -> tuple[float, bool]:
    """Latest last capture on the grid; write the `turns`, by evader, that attain it.

    Returns also whether one of them lies on the grid's border.
    """
    last, nodes = len(sequence) - 1, grid.latest.shape[1]
    first_captures(grid, pursuit, sequence[0])
    for k in range(1, last + 1):
        next_captures(grid, pursuit, k, sequence[k - 1], sequence[k])
    best = 0
    for j in range(nodes):
        if grid.latest[last, j] > grid.latest[last, best]:
            best = j
    value, on_border = grid.latest[last, best], False
    for k in range(last, -1, -1):
        turns[sequence[k]] = grid.turns[sequence[k] * nodes + best]
        on_border = on_border or best >= nodes - 2
        if k > 0:
            best = grid.before[k, best]
    return value, on_border


@allocating
def latest_in_sequence(
    evaders: Table, pursuit: Pursuit, sequence: Ints, tolerance: float
) -> tuple[Floats, bool]:
    """The turns with the latest last capture in `sequence`, and whether they are settled.

    Settled: known to `tolerance`, radians. A border that attracts is moved before the grid narrows.
    """
    n = len(sequence)
    turns, grid = np.zeros(n), make_grid(evaders, COARSE)
    lay_grid(grid, turns, math.pi, pursuit.speed)
    best_on_grid(grid, pursuit, sequence, turns)
    grid, width = make_grid(evaders, FINE), 2.0 * math.pi / (COARSE // 2)
    for _ in range(_MOST_ROUNDS):
        lay_grid(grid, turns, width, pursuit.speed)
        _, on_border = best_on_grid(grid, pursuit, sequence, turns)
        if not on_border:
            width *= 0.5
        if width < tolerance:
            return turns, True
    return turns, False
