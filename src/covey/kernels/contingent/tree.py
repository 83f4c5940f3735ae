"""The tree of a contingent plan: turns for each set of captures so far, in their order.

A node belongs to the captures so far and holds a turn for each evader that is left, in ascending
order of the evaders' numbers. The turns of a node come first, then those of the subtrees after each
first capture. So a subtree is a slice, and is itself the tree of a smaller team.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from covey.kernels._jit import inlined
from covey.kernels.arrays import Floats, Ints, IntVector, Vector


class Tree(NamedTuple):
    """The turns of a team of n evaders that answers its first captures, up to `depth` of them."""

    turns: Vector  # (sizes[0],) signed turns, radians in [-π, π]
    depth: int  # 0: the turns of an open-loop plan; at most n - 1
    sizes: IntVector  # (n + 1,) turns in a subtree after k captures


def tree_sizes(n: int, depth: int) -> Ints:
    """Return how many turns a subtree has after 0 to n captures, (n + 1,); 0 beyond the depth."""
    sizes = np.zeros(n + 1, np.int64)
    for level in range(depth, -1, -1):
        below = sizes[level + 1] if level < depth else 0
        sizes[level] = (n - level) * (1 + below)
    return sizes


def new_tree(n: int, depth: int) -> Tree:
    """Allocate a tree in which nobody turns."""
    sizes = tree_sizes(n, depth)
    return Tree(np.zeros(sizes[0]), depth, sizes)


def answer_to(turns: Floats, n: int, rank: int) -> Floats:
    """Return the turns of the subtree that answers the first capture of an evader of this rank.

    `turns` are those of a tree of n evaders; there is no answer in a tree of depth 0.
    """
    below = (len(turns) - n) // n
    return turns[n + rank * below : n + (rank + 1) * below]


@inlined
def subtree(tree: Tree, n: int, level: int, offset: int, rank: int) -> int:
    """Return where the turns of a subtree begin.

    The subtree answers the capture of the evader of this rank among the n - `level` evaders of the
    node whose turns begin at `offset`.
    """
    return offset + (n - level) + rank * tree.sizes[level + 1]
