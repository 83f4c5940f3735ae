"""All methods on one game, then all on the next: what disturbs the machine disturbs them alike."""

from __future__ import annotations

import itertools
import time
from collections import defaultdict
from typing import NamedTuple

from moments import moments
from own import Compiled, FromPython
from peers.ipopt import Ipopt
from peers.slsqp import Slsqp, SlsqpByDifferences

SIZES = tuple(range(2, 16))
LEAST_GAMES, MOST_GAMES = 20, 200
METHOD_SECONDS, SIZE_SECONDS = 4.0, 20.0
"""After these a method takes no further part at a size, and a size has no more than the least."""

METHODS = (Compiled, FromPython, Slsqp, SlsqpByDifferences, Ipopt)
TASKS = ("warm", "cold", "best")
REFERENCE = Compiled.name


class Solve(NamedTuple):
    """One method on one game."""

    size: int
    game: int
    task: str
    method: str
    seconds: float
    value: float
    settled: bool


def pairs(size):
    """Return the methods and tasks that are measured at a size."""
    return [
        (method, task)
        for method in METHODS
        if size <= method.largest
        for task in TASKS
        if hasattr(method, task)
    ]


MEASURED: dict[int, list[Solve]] = {}
"""By size, so that a run measures once what several of its benchmarks report."""


def measure(size):
    """Return what every method took and reached on the games of a size, a list of `Solve`."""
    if size not in MEASURED:
        MEASURED[size] = _play(size)
    return MEASURED[size]


def _play(size):
    solvers = {method: method(size) for method, _ in pairs(size)}
    runs = [(method.name, task, getattr(solvers[method], task)) for method, task in pairs(size)]
    solves, spent, begun = [], defaultdict(float), time.perf_counter()
    for game, moment in enumerate(itertools.islice(moments(size), MOST_GAMES)):
        for name, task, run in runs:
            if spent[name, task] < METHOD_SECONDS:
                answer = run(moment)
                solves.append(Solve(size, game, task, name, *answer))
                spent[name, task] += answer.seconds
        if game + 1 >= LEAST_GAMES and time.perf_counter() - begun > SIZE_SECONDS:
            break
    return solves


def warm_up():
    """Play one game with all methods, so that everything is compiled: kernels know no sizes."""
    moment = next(moments(2))
    for method, task in pairs(2):
        getattr(method(2), task)(moment)
