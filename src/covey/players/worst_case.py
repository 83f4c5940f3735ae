"""The worst that a hidden pursuer can do to a team's strategy: a search of the tree of captures."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from copy import deepcopy
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import NamedTuple

from covey.kernels.play.policy import TeamMemory
from covey.kernels.play.rules import State
from covey.kernels.play.to_capture import guaranteed_value, play_to_capture
from covey.model import InputError, LastCapture, Objective, PursuerDisk, Team, objective_value
from covey.model.validation import number
from covey.planning import plan
from covey.planning.workspace import workspace
from covey.players.compiled import BuiltInTeam, checked_settings, team_is_built_in
from covey.players.pursuers.delayed import DelayedSequence
from covey.players.teams.open_loop import IterativeOpenLoop, first_memory
from covey.simulation import Settings, TeamPolicy, TeamStrategy, play
from covey.simulation.settings import first_state

_PROMISE_KEPT = 1e-9
"""By how much, relative, rounding may bring a team below what its plan guaranteed."""


class WorstCaseScope(StrEnum):
    """Over which hidden pursuers a worst case was taken."""

    PROMPT = "all capture sequences, each capture as soon as the disk reaches the evader"
    DELAYED = "all capture sequences, each capture after each of the delays"


@dataclass(frozen=True)
class WorstCase:
    """The worst that a hidden pursuer can do to a team's strategy.

    Attributes
    ----------
    survival_time : float
        Time of the last capture: the least there is, where the game is about that.
    value : float
        The least of what the objective measures: the last capture, or the sum.
    sequence : tuple of int
        The order of capture that leads to it.
    capture_times : tuple of float
        (N,) in the order of `sequence`.
    delays : tuple of float
        (N,) how long each capture waited, in the order of `sequence`.
    scope : WorstCaseScope
        Which pursuers were looked at. One that waits for other times, or decides about its delays
        by what it sees of the evaders, may do a little better still.
    flights : int
        Flights from one capture to the next that were played.
    """

    survival_time: float
    value: float
    sequence: tuple[int, ...]
    capture_times: tuple[float, ...]
    delays: tuple[float, ...]
    scope: WorstCaseScope
    flights: int


class Capture(NamedTuple):
    """Who was captured, when, and how long after it could have been."""

    evader: int
    time: float
    delay: float


def worst_case(
    team: Team,
    disk: PursuerDisk,
    *,
    evaders: TeamStrategy | TeamPolicy = IterativeOpenLoop(),  # noqa: B008 frozen
    delays: Sequence[float] = (0.0,),
    update_time: float = 0.01,
    seed: int = 0,
    objective: Objective = LastCapture(),  # noqa: B008 frozen
) -> WorstCase:
    """Find the capture sequence by which a hidden pursuer ends a team's survival earliest.

    Or by which the sum of survival times is least, where the game is about that. What a team that
    doesn't see the pursuer does depends on the captures alone, so the worst case is the least over
    a tree: who is captured first, who then, ....

    Parameters
    ----------
    team, disk
        The state at time 0; up to 20 evaders, each slower than the pursuer.
    evaders
        The team's strategy, as `simulate` takes it.
    delays
        Each capture may wait so long after the disk has reached the evader, times >= 0; see
        `covey.players.DelayedSequence`. By default it doesn't wait, as in the paper.
    update_time, seed, objective
        As `simulate` takes them. The worst case is the least of what the objective measures.

    Returns
    -------
    WorstCase
        The least value, exact over the pursuers that `scope` names; equal to that of `simulate`
        with its sequence and delays.

    Raises
    ------
    InputError
        If an argument can't be used.

    Notes
    -----
    Open loop and iterative open loop play each beginning of a sequence once, and a beginning whose
    team has planned for more than the least value found is dropped: neither ever falls short of its
    plan. A plan for an expectation promises nothing, so few beginnings are dropped. Any other
    strategy may remember anything, so it plays every sequence from the start: N! games, times the
    delays. It must play the same game when it is started anew with the same seed.
    """
    checked = checked_settings(team, disk, "hidden", update_time, seed, None, objective)
    settings = replace(checked, time_limit=math.inf)  # captures that wait may come after it
    waits = tuple(dict.fromkeys(number("delays", delay, low=0.0) for delay in delays))
    if not waits:
        raise InputError("delays: expected at least one, got none")
    if team_is_built_in(evaders):
        tree = _Tree(team, disk, evaders, waits, settings)
        tree.explore()
        worst, flights = tree.worst, tree.flights
    else:
        games = [*_all_games(team, disk, evaders, waits, settings)]
        worst = min(games, key=lambda captures: _value(captures, objective))
        flights = len(games) * len(team)
    return WorstCase(
        survival_time=worst[-1].time,
        value=_value(worst, objective),
        sequence=tuple(capture.evader for capture in worst),
        capture_times=tuple(capture.time for capture in worst),
        delays=tuple(capture.delay for capture in worst),
        scope=WorstCaseScope.DELAYED if any(waits) else WorstCaseScope.PROMPT,
        flights=flights,
    )


class _Node(NamedTuple):
    """A game after its first captures."""

    captures: tuple[Capture, ...]
    state: State
    memory: TeamMemory
    promised: float  # no game that goes on from here has a smaller value


class _Tree:
    """Depth first, the smallest promise first; `worst` is the game of least value so far."""

    def __init__(
        self,
        team: Team,
        disk: PursuerDisk,
        strategy: BuiltInTeam,
        delays: tuple[float, ...],
        settings: Settings,
    ) -> None:
        n = len(team)
        self._rules, self._policy = settings.rules(disk), strategy.compiled()
        self._delays, self._objective = delays, settings.objective
        first = plan(
            team, disk, objective=settings.objective, seed=settings.seed, starts=strategy.starts
        )
        state = first_state(team, disk)
        state.turns[:] = first.turns
        memory = first_memory(first, settings.seed, self._policy.restarts)
        self._workspace = workspace(n, memory.objective.total)
        self._root = _Node((), state, memory, first.value)
        self.worst: tuple[Capture, ...] = ()
        self._least = math.inf
        self.flights = 0

    def explore(self) -> None:
        """Find the worst game."""
        self._explore(self._root)

    def _explore(self, node: _Node) -> None:
        if node.state.alive[0] == 0:
            value = _value(node.captures, self._objective)
            if value < self._least:
                self.worst, self._least = node.captures, value
            return
        for child in sorted(self._children(node), key=lambda child: child.promised):
            if child.promised * (1.0 - _PROMISE_KEPT) < self._least:
                self._explore(child)

    def _children(self, node: _Node) -> Iterator[_Node]:
        for row, delay in itertools.product(range(int(node.state.alive[0])), self._delays):
            state, memory = deepcopy(node.state), deepcopy(node.memory)
            captured = int(state.ids[row])
            if not play_to_capture(
                state,
                self._rules,
                self._policy,
                memory,
                row,
                delay,
                self._workspace,
            ):
                raise _too_many_updates(self._rules.update_time)
            self.flights += 1
            captures = (*node.captures, Capture(captured, float(state.time[0]), delay))
            yield _Node(captures, state, memory, self._promised(captures, state, memory))

    def _promised(self, captures: tuple[Capture, ...], state: State, memory: TeamMemory) -> float:
        """What no game that goes on from here falls below.

        The living survive until now at least; a plan for an expectation promises no more.
        """
        alive, total = int(state.alive[0]), memory.objective.total
        promised = float(state.time[0]) * (alive if total else 1)
        if alive > 0 and not memory.objective.expected:
            promised = guaranteed_value(state, self._rules, total, self._workspace)
        return promised + (sum(capture.time for capture in captures) if total else 0.0)


def _value(captures: tuple[Capture, ...], objective: Objective) -> float:
    return objective_value(objective, [capture.time for capture in captures])


def _all_games(
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
