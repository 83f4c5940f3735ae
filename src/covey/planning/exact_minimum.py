"""The exact minimum over all capture sequences, on two cores where the team is large."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import TypeVar

import numpy as np

from covey.kernels.arrays import Ints, Pursuit, Table
from covey.kernels.capture.straight_legs import make_lines, set_lines
from covey.kernels.minimum.deadlines import new_deadlines, set_deadlines
from covey.kernels.minimum.labels import SubsetScratch, begin_labels, new_labels, trace_back
from covey.kernels.minimum.last_capture import first_bound, least_time
from covey.kernels.minimum.layers import follow_half

LARGE = 19
"""Evaders from which on two cores are faster than one."""

_BITS = 4

Done = TypeVar("Done")


def exact_minimum(paths: Table, n: int, pursuit: Pursuit) -> tuple[float, Ints]:
    """Return the least time of a capture sequence of n evaders, and one that attains it."""
    if n >= LARGE and (os.cpu_count() or 1) > 1:
        with ThreadPoolExecutor(1) as crew:
            return _in_halves(paths, n, pursuit, crew)
    sequence = np.empty(n, np.int64)
    # NumPy asks the system for large pages, which take half the time that many small ones would.
    scratch = SubsetScratch(new_labels(n), make_lines(n), new_deadlines(n))
    time, _ = least_time(paths, n, pursuit, math.inf, sequence, scratch)
    return time, sequence


def _in_halves(
    paths: Table, n: int, pursuit: Pursuit, crew: ThreadPoolExecutor
) -> tuple[float, Ints]:
    def on_both_cores(work: Callable[[int], Done]) -> tuple[Done, Done]:
        other = crew.submit(work, 1)
        return work(0), other.result()

    def write_deadlines(blocks: Sequence[int], half: int) -> None:
        for block in blocks[half::2]:
            sets = block << n - _BITS, block + 1 << n - _BITS
            set_deadlines(paths, lines, n, pursuit, bound, *sets, deadlines)

    def follow(begins: tuple[int, int], ends: tuple[int, int], half: int) -> int:
        times = np.empty(n)
        return 1 + follow_half(paths, n, pursuit, bound, halves, begins, ends, half, times)

    sequence = np.empty(n, np.int64)
    labels, lines, deadlines = (new_labels(n), new_labels(n)), make_lines(n), new_deadlines(n)
    halves = (
        SubsetScratch(labels[0], lines, deadlines),
        SubsetScratch(labels[1], lines, deadlines),
    )
    set_lines(paths, n, lines)
    bound = first_bound(paths, n, pursuit, sequence, labels[0])
    # A set's deadlines follow from those of its subsets, so blocks that agree in how many of the
    # last evaders are still ahead don't wait for each other.
    for many in range(_BITS + 1):
        blocks = [block for block in range(1 << _BITS) if block.bit_count() == many]
        on_both_cores(partial(write_deadlines, blocks))
    begins = 1, 1
    ends = 1 + begin_labels(paths, n, pursuit, bound, halves[0]), 1
    for _ in range(n - 1):
        begins, ends = ends, on_both_cores(partial(follow, begins, ends))
    return trace_back(paths, n, pursuit, bound, sequence, *labels), sequence
