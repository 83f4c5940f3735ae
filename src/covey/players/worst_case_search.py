"""The searches for a worst case: branch and bound over captures, and every game played."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from copy import deepcopy
from typing import NamedTuple

from covey.kernels.arrays import Workspace
from covey.kernels.play.policy import TeamMemory
from covey.kernels.play.rules import State
from covey.kernels.play.to_capture import guaranteed_value, play_to_capture
from covey.model import InputError, Objective, PursuerDisk, Team, objective_value
from covey.planning.long_calls import interruptible
from covey.planning.workspace import workspace
from covey.players.compiled import (
    BuiltInTeam,
    game_interceptions,
    initial_game,
)
from covey.players.pursuers.delayed import DelayedSequence
from covey.simulation import Settings, TeamPolicy, TeamStrategy, play

_ROUNDING = 1e-9
"""Relative: rounding may bring a team below its guarantee by this much."""


class Capture(NamedTuple):
    """Who was captured, when, and how long after the earliest capture."""

    evader: int
    time: float
    delay: float


class _Node(NamedTuple):
    """A game after its first captures."""

    captures: tuple[Capture, ...]
    state: State
    memory: TeamMemory
    lower_bound: float  # of the values of all games that continue this one


class Tree:
    """Branch and bound, depth first, least bound first; `worst` is the least game so far."""

    def __init__(
        self,
        team: Team,
        disk: PursuerDisk,
        strategy: BuiltInTeam,
        delays: tuple[float, ...],
        settings: Settings,
    ) -> None:
        self._rules, self._delays, self._objective = (
            settings.rules(disk),
            delays,
            settings.objective,
        )
        first, state, self._options, memory = initial_game(team, disk, strategy, settings)
        self._size = len(team)
        self._work = game_interceptions(first, memory.objective, settings)
        self._root = _Node((), state, memory, first.value)
        self.worst: tuple[Capture, ...] = ()
        self._least = math.inf
        self.flights = 0

    def explore(self) -> None:
        """Find the worst game."""
        self._explore(self._root)

    def _explore(self, node: _Node) -> None:
        if node.state.alive[0] == 0:
            value = value_of(node.captures, self._objective)
            if value < self._least:
                self.worst, self._least = node.captures, value
            return
        for child in sorted(self._children(node), key=lambda child: child.lower_bound):
            if child.lower_bound * (1.0 - _ROUNDING) < self._least:
                self._explore(child)

    def _children(self, node: _Node) -> Iterator[_Node]:
        for row, delay in itertools.product(range(int(node.state.alive[0])), self._delays):
            state, memory = deepcopy(node.state), deepcopy(node.memory)
            captured = int(state.ids[row])
            if not self._play_to_capture(state, memory, row, delay):
                raise _too_many_updates(self._rules.update_time)
            self.flights += 1
            captures = (*node.captures, Capture(captured, float(state.time[0]), delay))
            yield _Node(captures, state, memory, self._lower_bound(captures, state, memory))

    def _play_to_capture(self, state: State, memory: TeamMemory, row: int, delay: float) -> bool:
        def go_on(scratch: Workspace) -> bool:
            return play_to_capture(state, self._rules, self._options, memory, row, delay, scratch)

        return interruptible(go_on, self._size, memory.objective.total, self._work)

    def _lower_bound(
        self, captures: tuple[Capture, ...], state: State, memory: TeamMemory
    ) -> float:
        """Return a lower bound of the values of all games that continue this one.

        The living survive at least until now. A plan for an expectation guarantees no more.
        """
        alive, total = int(state.alive[0]), memory.objective.total
        bound = float(state.time[0]) * (alive if total else 1)
        if alive > 0 and not memory.objective.expected:
            bound = guaranteed_value(state, self._rules, total, workspace(self._size, total))
        return bound + (sum(capture.time for capture in captures) if total else 0.0)


def value_of(captures: tuple[Capture, ...], objective: Objective) -> float:
    """Return what the objective measures of these captures."""
    return objective_value(objective, [capture.time for capture in captures])


def all_games(
    team: Team,
    disk: PursuerDisk,
    evaders: TeamStrategy | TeamPolicy,
    delays: tuple[float, ...],
    settings: Settings,
) -> Iterator[tuple[Capture, ...]]:
    """Play every sequence with all delays, from the start."""
    n = len(team)
    for sequence in itertools.permutations(range(n)):
        for waits in itertools.product(delays, repeat=n):
            game = play(team, disk, evaders, DelayedSequence(sequence, waits), settings)
            if math.isinf(game.survival_time):
                raise _too_many_updates(settings.update_time)
            yield tuple(map(Capture, sequence, game.capture_times.tolist(), waits))


def _too_many_updates(update_time: float) -> InputError:
    return InputError(
        f"update_time: expected a longer one, got {update_time:g}: a game took too long"
    )
