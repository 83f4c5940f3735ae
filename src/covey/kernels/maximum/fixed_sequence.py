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
from covey.kernels.arrays import Floats, Ints, Pursuit, Table
from covey.kernels.capture.interception import earliest_capture
from covey.kernels.capture.path import EVADER, PATH, TURN_RATE, position, set_paths

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
def first_captures(paths: Table, pursuit: Pursuit, i: int, latest: Floats) -> None:
    """Write when evader i, on each of its paths, is captured first of all."""
    nodes = len(latest)
    for j in range(nodes):
        latest[j] = earliest_capture(
            paths,
            i * nodes + j,
            pursuit.center_x,
            pursuit.center_y,
            pursuit.first_radius,
            0.0,
            pursuit.speed,
        )


@compiled
def next_captures(
    paths: Table,
    pursuit: Pursuit,
    previous: int,
    i: int,
    earlier: Floats,
    latest: Floats,
    before: Ints,
) -> None:
    """Write when evader i, on each of its paths, is captured `latest`.

    The pursuer comes from evader `previous`, captured at `earlier` on each of *its* paths; the one
    that delays i most goes to `before`.
    """
    nodes = len(latest)
    for j in range(nodes):
        latest[j] = -math.inf
    for b in range(nodes):
        time = earlier[b]
        x, y = position(paths, previous * nodes + b, time)
        for j in range(nodes):
            capture = earliest_capture(
                paths, i * nodes + j, x, y, pursuit.later_radius, time, pursuit.speed
            )
            if capture > latest[j]:
                latest[j], before[j] = capture, b


@compiled
def best_on_grid(grid: Grid, pursuit: Pursuit, sequence: Ints, turns: Floats) -> bool:
    """Write the `turns`, by evader, with the latest last capture.

    Returns whether one of them lies on the grid's border.
    """
    last, nodes = len(sequence) - 1, grid.latest.shape[1]
    first_captures(grid.paths, pursuit, sequence[0], grid.latest[0])
    for k in range(1, last + 1):
        next_captures(
            grid.paths,
            pursuit,
            sequence[k - 1],
            sequence[k],
            grid.latest[k - 1],
            grid.latest[k],
            grid.before[k],
        )
    best = 0
    for j in range(nodes):
        if grid.latest[last, j] > grid.latest[last, best]:
            best = j
    on_border = False
    for k in range(last, -1, -1):
        turns[sequence[k]] = grid.turns[sequence[k] * nodes + best]
        on_border = on_border or best >= nodes - 2
        if k > 0:
            best = grid.before[k, best]
    return on_border


@allocating
def latest_in_sequence(
    evaders: Table, pursuit: Pursuit, sequence: Ints, tolerance: float
) -> tuple[Floats, bool]:
    """The turns with the latest last capture in `sequence`, and whether they are settled.

    Settled: known to `tolerance`, radians. The grid narrows only where its border doesn't attract.
    """
    n = len(sequence)
    turns, grid = np.zeros(n), make_grid(evaders, COARSE)
    lay_grid(grid, turns, math.pi, pursuit.speed)
    best_on_grid(grid, pursuit, sequence, turns)
    grid, width = make_grid(evaders, FINE), 2.0 * math.pi / (COARSE // 2)
    for _ in range(_MOST_ROUNDS):
        lay_grid(grid, turns, width, pursuit.speed)
        if not best_on_grid(grid, pursuit, sequence, turns):
            width *= 0.5
        if width < tolerance:
            return turns, True
    return turns, False
