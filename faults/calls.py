"""`python -m faults.calls COUNT`: plans and games, over and over, until COUNT interrupts came.

It prints "ready" each time it may be interrupted. At its end it tells which calls gave something
else than they gave undisturbed.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from itertools import cycle
from typing import TypeAlias

import numpy as np

import covey

_Strategy: TypeAlias = covey.IterativeOpenLoop | Callable[[covey.Situation], list[float]]

_DISK = covey.PursuerDisk(radius=0.1)


def _team(size: int) -> covey.Team:
    random = np.random.default_rng(size)
    return covey.Team(random.uniform(-0.5, 0.5, (size, 2)), random.uniform(-np.pi, np.pi, size))


def _plan(size: int) -> object:
    plan = covey.plan(_team(size), _DISK, starts=20)
    return plan.turns.tolist(), plan.survival_time, plan.critical_sequences, plan.steps


def _bracket(size: int) -> object:
    found = covey.bracket(_team(size), _DISK)
    return found.lower, found.upper


def _hold(situation: covey.Situation) -> list[float]:
    return [0.0] * len(situation.evaders)


def _game(size: int, sensing: str, evaders: _Strategy) -> object:
    game = covey.simulate(_team(size), _DISK, evaders=evaders, sensing=sensing, update_time=0.05)
    return game.capture_sequence.tolist(), game.capture_times.tolist(), game.guarantee


CALLS: dict[str, Callable[[], object]] = {
    "a plan for five": lambda: _plan(5),
    "a plan for nine, in parallel": lambda: _plan(9),
    "a bracket": lambda: _bracket(2),
    "a visible game": lambda: _game(4, "visible", covey.IterativeOpenLoop()),
    "a hidden game": lambda: _game(4, "hidden", covey.IterativeOpenLoop()),
    "a game of a strategy in Python": lambda: _game(3, "hidden", _hold),
}


def main(count: int) -> None:
    """Repeat the calls until `count` interrupts came, then tell how the calls differed."""
    expected = {name: call() for name, call in CALLS.items()}
    names, differing = cycle(CALLS), set()
    for _ in range(count):
        try:
            print("ready", flush=True)
            for name in names:
                if CALLS[name]() != expected[name]:
                    differing.add(name)
        except KeyboardInterrupt:
            pass
    differing |= {name for name, call in CALLS.items() if call() != expected[name]}
    print(json.dumps(sorted(differing)))


if __name__ == "__main__":
    main(int(sys.argv[1]))
