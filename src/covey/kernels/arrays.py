"""Array types of the kernels' arguments, and the workspace that holds their scratch."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from covey.kernels._jit import expanded

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]
Int32s = npt.NDArray[np.int32]


_LINE = 8  # floats in a line of the processor's cache, where each array begins


class Workspace(NamedTuple):
    """Memory for the scratch of kernels. Python owns it; kernels carve their arrays from it.

    A call carves the same arrays as the call before, so tables keep what was written to them. One
    thread at a time may use a workspace.
    """

    size: int  # evaders that the scratch has room for
    total: bool  # whether there is room for minima of sums, too
    carved: Ints  # (3,) how much of each of the following is in use
    floats: Floats
    ints: Ints
    slots: Int32s  # zeros at first


def new_workspace(size: int, total: bool = False) -> Workspace:
    """Allocate a workspace for teams of up to `size` evaders."""
    tables = 1 << size
    dense = 64 * (size + 8) ** 2  # all but the tables of the minima; carving checks the bound
    per_set = 2 * size + 4 + (2 * size if total else 0)
    return Workspace(
        size,
        total,
        np.zeros(3, np.int64),
        _aligned(dense + per_set * tables),
        np.zeros(dense + (1 + (size if total else 0)) * tables, np.int64),
        np.zeros(tables, np.int32),
    )


def _aligned(n: int) -> Floats:
    """Allocate (n,) floats that begin with a line of the processor's cache."""
    memory = np.empty(n + _LINE)
    begin = -memory.ctypes.data // memory.itemsize % _LINE
    return memory[begin : begin + n]


@expanded
def floats(workspace: Workspace, n: int) -> Floats:
    """Carve (n,) floats."""
    begin = workspace.carved[0]
    workspace.carved[0] = begin + (n + _LINE - 1) // _LINE * _LINE
    return workspace.floats[begin : begin + n]


@expanded
def float_rows(workspace: Workspace, m: int, n: int) -> Floats:
    """Carve (m, n) floats."""
    return floats(workspace, m * n).reshape((m, n))


@expanded
def ints(workspace: Workspace, n: int) -> Ints:
    """Carve (n,) integers."""
    begin = workspace.carved[1]
    workspace.carved[1] = begin + n
    return workspace.ints[begin : begin + n]


@expanded
def int_rows(workspace: Workspace, m: int, n: int) -> Ints:
    """Carve (m, n) integers."""
    return ints(workspace, m * n).reshape((m, n))


@expanded
def slots(workspace: Workspace, n: int) -> Int32s:
    """Carve (n,) short integers, which are zero unless a kernel left something there."""
    begin = workspace.carved[2]
    workspace.carved[2] = begin + n
    return workspace.slots[begin : begin + n]


@expanded
def begin_carving(workspace: Workspace) -> None:
    """Give all memory back, before a call carves its scratch."""
    for k in range(len(workspace.carved)):
        workspace.carved[k] = 0
