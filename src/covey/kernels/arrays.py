"""Array types of the kernels' arguments, and the workspace that holds their scratch."""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np
import numpy.typing as npt

from covey.kernels._jit import expanded, inlined
from covey.kernels.library.layout import kept

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]
Int32s = npt.NDArray[np.int32]

# What an entry takes has a known number of dimensions, too.
Vector = Annotated[npt.NDArray[np.float64], 1]
Matrix = Annotated[npt.NDArray[np.float64], 2]
Tensor = Annotated[npt.NDArray[np.float64], 3]
IntVector = Annotated[npt.NDArray[np.int64], 1]
IntMatrix = Annotated[npt.NDArray[np.int64], 2]
Int32Vector = Annotated[npt.NDArray[np.int32], 1]
Float32Vector = Annotated[npt.NDArray[np.float32], 1]
Float32Matrix = Annotated[npt.NDArray[np.float32], 2]


PATH = 15
"""Numbers that describe a path, see `capture.path`."""

_LINE = 8  # floats in a line of the processor's cache
_LANES = 4  # floats in a register of the processor


MOST_EVADERS = 50
"""Largest team: a set and a last captured evader are one integer."""

LARGEST_TABLE = 20
"""Evaders up to which the minimum over all sequences may keep a table of all sets."""

FEWEST_WALKING = 18
"""Evaders from which on walks come before the table, see `minimum.large`."""

MOST_NEIGHBOURS = 8
"""Evaders that a walk of a larger team remembers at most, see `minimum.large`."""

MOST_WEIGHT = 6
"""Largest weight of the visits of an evader, in the mean over the team."""

STAGES_BEFORE_TABLE, STAGES, STAGES_OF_GUARANTEE = 1, 2, 6
"""Stages after which walks are given up: where a table can follow, and for larger teams in a search
and for a guarantee, see `minimum.large`."""

LABELS = 1 << 23
"""Labels that the minimum for a large team keeps at most."""


class WalkMemory(NamedTuple):
    """Memory of the minimum for large teams; empty for small teams.

    Few arrays travel with each call, and `minimum.large.scratch` divides them up.
    """

    floats: Vector
    ints: IntVector  # begins with SOLVED, ..., STAGES_GIVEN
    int32s: Int32Vector
    neighbours: IntMatrix  # (n, MOST_NEIGHBOURS + 1) how many there are, and who


SOLVED, LABELS_TAKEN, STATES_TAKEN, STAGES_GIVEN = range(4)
"""Slots of `WalkMemory.ints`: evaders of the minimum of which weights are kept, 0: none; labels and
states of a walk that it took; stages after which a minimum is given up."""


@kept
class Workspace(NamedTuple):
    """Memory for the scratch of kernels. Python owns it; kernels carve their arrays from it.

    A call carves the same arrays as the call before, so tables keep what was written to them. One
    thread at a time may use a workspace. There is a buffer for each number of columns, because
    numba takes rows of a table for nothing, and gives a new shape to an array by a slow call.
    """

    size: int  # n: evaders that the scratch has room for
    total: bool  # whether there is room for minima of sums, too
    fewest_walking: int  # evaders from which on the minimum begins with walks
    largest_table: int  # evaders up to which the minimum may keep a table of all sets
    carved: IntVector  # (7,) how much of each of the following is in use
    floats: Vector  # (.,)
    rows: Matrix  # (., n)
    wide_rows: Matrix  # (., n + 2)
    path_rows: Matrix  # (., PATH)
    padded_rows: Matrix  # (., n rounded up to a multiple of the processor's lanes)
    ints: IntVector  # (.,)
    int_rows: IntMatrix  # (., n)
    slots: Int32Vector  # (2**n,) zeros at first; carved as a whole
    walks: WalkMemory
    stop: IntVector  # (1,) `GO_ON`; another thread may write `FINISH` or `ABANDON`


GO_ON, FINISH, ABANDON = range(3)
"""How a call goes on. `FINISH`: searches and games end at their next check, with what they have.
`ABANDON`: minima end too, and the results mean nothing."""

FLOATS, ROWS, WIDE_ROWS, PATH_ROWS, PADDED_ROWS, INTS, INT_ROWS = range(7)


def new_workspace(
    size: int,
    total: bool = False,
    fewest_walking: int = FEWEST_WALKING,
    largest_table: int = LARGEST_TABLE,
) -> Workspace:
    """Allocate a workspace for teams of up to `size` evaders."""
    table = min(size, largest_table)
    sets = 1 << table
    states = size << size if total else table << table
    return Workspace(
        size,
        total,
        fewest_walking,
        largest_table,
        np.zeros(7, np.int64),
        _aligned(1, states * (3 if total else 1) + 64 * (size + 8))[0],
        _aligned(16 * size + 40, size),
        _aligned(size + 2, size + 2),
        _aligned(4 * size, PATH),
        _aligned(sets + size + 24, -(-size // _LANES) * _LANES),
        np.zeros(sets + (states if total else 0) + 24 * (size + 8), np.int64),
        np.zeros((4 * size + 8, size), np.int64),
        np.zeros(sets, np.int32),
        _walk_memory(size if size >= fewest_walking else 0),
        np.zeros(1, np.int64),
    )


def _walk_memory(size: int) -> WalkMemory:
    """Allocate memory for large teams. The system hands out pages where they are first used."""
    states, labels = walk_states(size), LABELS if size > 0 else 0
    ints = np.empty(labels + 32 * (size + 8), np.int64)
    ints[SOLVED], ints[STAGES_GIVEN] = 0, stages_of_search(size)
    return WalkMemory(
        np.empty(states + labels + (1 << MOST_NEIGHBOURS) + 16 * (size + 8)),
        ints,
        np.empty(states + (size * size << MOST_NEIGHBOURS) + 3 * labels, np.int32),
        np.empty((size, MOST_NEIGHBOURS + 1), np.int64),
    )


def stages_of_search(size: int) -> int:
    """Return after how many stages walks are given up in a search."""
    return STAGES_BEFORE_TABLE if size <= LARGEST_TABLE else STAGES


@inlined
def walk_states(n: int) -> int:
    """Return how many states walks of n evaders have, by weight, last captured and memory."""
    return ((MOST_WEIGHT * n + 1) * n) << MOST_NEIGHBOURS


def _aligned(rows: int, columns: int) -> Floats:
    """Allocate (rows, columns) floats that begin with a line of the processor's cache."""
    memory = np.empty(rows * columns + _LINE)
    begin = -memory.ctypes.data // memory.itemsize % _LINE
    return memory[begin : begin + rows * columns].reshape(rows, columns)


@inlined
def padded(n: int) -> int:
    """Return how many columns a padded table of n evaders has."""
    return (n + _LANES - 1) // _LANES * _LANES


@expanded
def floats(workspace: Workspace, n: int) -> Floats:
    """Carve (n,) floats that begin with a line of the processor's cache."""
    begin = workspace.carved[FLOATS]
    workspace.carved[FLOATS] = begin + (n + _LINE - 1) // _LINE * _LINE
    return workspace.floats[begin : begin + n]


@expanded
def rows(workspace: Workspace, m: int) -> Floats:
    """Carve (m, n) floats."""
    begin = workspace.carved[ROWS]
    workspace.carved[ROWS] = begin + m
    return workspace.rows[begin : begin + m]


@expanded
def wide_rows(workspace: Workspace, m: int) -> Floats:
    """Carve (m, n + 2) floats."""
    begin = workspace.carved[WIDE_ROWS]
    workspace.carved[WIDE_ROWS] = begin + m
    return workspace.wide_rows[begin : begin + m]


@expanded
def path_rows(workspace: Workspace, m: int) -> Floats:
    """Carve (m, PATH) floats."""
    begin = workspace.carved[PATH_ROWS]
    workspace.carved[PATH_ROWS] = begin + m
    return workspace.path_rows[begin : begin + m]


@expanded
def padded_rows(workspace: Workspace, m: int) -> Floats:
    """Carve m rows of floats, a column an evader, padded to a multiple of the processor's lanes."""
    begin = workspace.carved[PADDED_ROWS]
    workspace.carved[PADDED_ROWS] = begin + m
    return workspace.padded_rows[begin : begin + m]


@expanded
def ints(workspace: Workspace, n: int) -> Ints:
    """Carve (n,) integers."""
    begin = workspace.carved[INTS]
    workspace.carved[INTS] = begin + n
    return workspace.ints[begin : begin + n]


@expanded
def int_rows(workspace: Workspace, m: int) -> Ints:
    """Carve (m, n) integers."""
    begin = workspace.carved[INT_ROWS]
    workspace.carved[INT_ROWS] = begin + m
    return workspace.int_rows[begin : begin + m]


@expanded
def begin_carving(workspace: Workspace) -> None:
    """Give all memory back, before a call carves its scratch."""
    for k in range(len(workspace.carved)):
        workspace.carved[k] = 0
