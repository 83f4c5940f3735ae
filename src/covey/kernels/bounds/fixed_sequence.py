"""The latest last capture in one known sequence: a dynamic programme over each evader's turn.

A later capture on the same path delays every later capture, for the pursuer is the faster. So the
problem has optimal substructure: for each path of the k-th evader keep only its latest capture over
all turns of the evaders before it. The maximum over N turns becomes N maxima over one. On a grid of
turns it is exact; finer and finer grids around the best turns then close in on the maximum.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels._jit import compiled, entry
from covey.kernels.arrays import Floats, IntMatrix, Ints, IntVector, Matrix, Vector
from covey.kernels.capture.interception import earliest_capture
from covey.kernels.capture.path import PATH, TURN_RATE, set_paths
from covey.kernels.capture.pursuit import Pursuit, disk_after, initial_disk

COARSE = 65
"""Turns of each evader on the first grid, which covers all of [-π, π]."""

FINE = 9
"""Turns of each evader on the grids that close in."""

_MAX_ROUNDS = 200


class Grid(NamedTuple):
    """A grid of `nodes` turns for each of n evaders; evader i has rows i * nodes onward."""

    evaders: Matrix  # (n * nodes, EVADER)
    turns: Vector  # (n * nodes,)
    paths: Matrix  # (n * nodes, PATH)
    latest: Matrix  # (n, nodes) latest capture by slot in the sequence
    predecessor: IntMatrix  # (n, nodes) the node of the evader before, with which it is attained


def new_grid(evaders: Floats, nodes: int) -> Grid:
    """Allocate a grid for these evaders."""
    n = len(evaders)
    return Grid(
        np.repeat(evaders, nodes, axis=0),
        np.empty(n * nodes),
        np.empty((n * nodes, PATH)),
        np.empty((n, nodes)),
        np.empty((n, nodes), np.int64),
    )


@entry
def lay_grid(grid: Grid, centers: Vector, width: float, pursuer_speed: float) -> None:
    """Spread every evader's turns over `width` to both sides of its centre.

    `centers` (n,) and `width` are radians; the grid's turns and paths are modified in place. The
    nearest come first, so that among equals the smallest change of the turn wins. Turns at a
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


@entry
def first_captures(paths: Matrix, pursuit: Pursuit, i: int, latest: Vector) -> None:
    """Write when evader i, on each of its paths, is captured first of all.

    `paths` (N * nodes, PATH) are those of a `Grid`, `latest` (nodes,) is modified in place.
    """
    nodes = len(latest)
    for j in range(nodes):
        latest[j] = earliest_capture(paths, i * nodes + j, initial_disk(pursuit))


@entry
def next_captures(
    paths: Matrix,
    pursuit: Pursuit,
    previous: int,
    i: int,
    earlier: Vector,
    latest: Vector,
    predecessor: IntVector,
) -> None:
    """Write when evader i, on each of its paths, is captured `latest`, and by which predecessor.

    The pursuer comes from evader `previous`, captured at `earlier` on each of that evader's paths.

    Parameters
    ----------
    paths
        (N * nodes, PATH), see `Grid`.
    pursuit
        The pursuer.
    previous, i
        Numbers of two evaders that are captured one after the other.
    earlier
        (nodes,) capture times of `previous`, by its path.
    latest
        (nodes,) capture times of i, by its path; modified in place.
    predecessor
        (nodes,) the path of `previous` that delays i most; modified in place.
    """
    nodes = len(latest)
    for j in range(nodes):
        latest[j] = -math.inf
    for b in range(nodes):
        disk = disk_after(paths, previous * nodes + b, earlier[b], pursuit)
        for j in range(nodes):
            capture = earliest_capture(paths, i * nodes + j, disk)
            if capture > latest[j]:
                latest[j], predecessor[j] = capture, b


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
            grid.predecessor[k],
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
            best = grid.predecessor[k, best]
    return on_border


class Grids(NamedTuple):
    """The grids of a search."""

    coarse: Grid
    fine: Grid


def new_grids(evaders: Floats) -> Grids:
    """Allocate the grids of `latest_in_sequence`."""
    return Grids(new_grid(evaders, COARSE), new_grid(evaders, FINE))


@entry
def latest_in_sequence(
    pursuit: Pursuit, sequence: IntVector, tolerance: float, grids: Grids, turns: Vector
) -> bool:
    """Write the turns with the latest last capture; return whether they are settled.

    1. The best turns of the coarse grid.
    2. Fine grids around the best turns. The grid narrows only where the best turns are not on its
       border.

    Parameters
    ----------
    pursuit
        The pursuer.
    sequence
        (n,) the order of capture.
    tolerance
        Radians; settled turns are known to it.
    grids
        Of the evaders; modified in place.
    turns
        (n,) zeros; modified in place.
    """
    lay_grid(grids.coarse, turns, math.pi, pursuit.speed)
    best_on_grid(grids.coarse, pursuit, sequence, turns)
    width = 2.0 * math.pi / (COARSE // 2)
    for _ in range(_MAX_ROUNDS):
        lay_grid(grids.fine, turns, width, pursuit.speed)
        if not best_on_grid(grids.fine, pursuit, sequence, turns):
            width *= 0.5
        if width < tolerance:
            return True
    return False
