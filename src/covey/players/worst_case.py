"""The worst case of a team's strategy against a hidden pursuer: a search of capture sequences."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import StrEnum

from covey.model import InputError, LastCapture, Objective, PursuerDisk, Team
from covey.model.display import html_table, one_line, quantity
from covey.model.units import titled, units_with
from covey.model.validation import number
from covey.players.compiled import (
    checked_settings,
    team_is_built_in,
)
from covey.players.names import team_strategy
from covey.players.teams.open_loop import IterativeOpenLoop
from covey.players.worst_case_search import Tree, all_games, value_of
from covey.simulation import TeamPolicy, TeamStrategy


class WorstCaseScope(StrEnum):
    """Over which hidden pursuers a worst case was taken."""

    PROMPT = "all capture sequences, each capture as soon as the disk reaches the evader"
    DELAYED = "all capture sequences, each capture after each of the delays"


@dataclass(frozen=True)
class WorstCase:
    """The worst case of a team's strategy against a hidden pursuer.

    Attributes
    ----------
    survival_time : float
        Time of the last capture: the least one, where the game is about the last capture.
    value : float
        The least of what the objective measures: the last capture, or the sum.
    sequence : tuple of int
        The order of capture that gives this value.
    capture_times : tuple of float
        (N,) in the order of `sequence`.
    delays : tuple of float
        (N,) delay of each capture, in the order of `sequence`.
    scope : WorstCaseScope
        The pursuers that were considered. A pursuer with other delays, or with delays that depend
        on what it sees of the evaders, may reach a slightly lower value.
    flights : int
        Number of flights, from one capture to the next, that were played.
    unit : str
        Of the team's lengths; with one, all times are in seconds.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> worst = covey.worst_case(team, disk, evaders=covey.StraightAway(), update_time=0.1)
    >>> worst.sequence
    (1, 0, 2)
    >>> print(worst.scope)
    all capture sequences, each capture as soon as the disk reaches the evader
    """

    survival_time: float
    value: float
    sequence: tuple[int, ...]
    capture_times: tuple[float, ...]
    delays: tuple[float, ...]
    scope: WorstCaseScope
    flights: int
    unit: str = ""

    def __repr__(self) -> str:
        """Return the last capture, the order that ends so early, and who was considered."""
        return one_line(
            "WorstCase",
            survival_time=quantity(self.survival_time, units_with(self.unit).time),
            sequence=self.sequence,
            scope=self.scope,
        )

    def _repr_html_(self) -> str:
        second = units_with(self.unit).time
        columns = {
            "capture": range(1, len(self.sequence) + 1),
            "evader": self.sequence,
            titled("time", second): self.capture_times,
            titled("delay", second): self.delays,
        }
        return html_table(repr(self), columns)


def worst_case(
    team: Team,
    disk: PursuerDisk,
    *,
    evaders: TeamStrategy | TeamPolicy | str = IterativeOpenLoop(),  # noqa: B008 frozen
    delays: Sequence[float] = (0.0,),
    update_time: float = 0.01,
    seed: int = 0,
    objective: Objective | str = LastCapture(),  # noqa: B008 frozen
) -> WorstCase:
    """Find the capture sequence by which a hidden pursuer ends a team's survival earliest.

    Or by which the sum of survival times is least, where the game is about the sum. A team that
    doesn't see the pursuer reacts to captures alone. So the worst case is the least value in a tree
    whose branches are the next evader captured and its delay.

    Parameters
    ----------
    team, disk
        The state at time 0; up to 50 evaders, each slower than the pursuer.
    evaders
        The team's strategy, as `simulate` takes it.
    delays
        Times >= 0 that each capture may wait after the disk has reached the evader; see
        `covey.players.DelayedSequence`. By default no capture waits, as in the paper.
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
    Open loop and iterative open loop play each prefix of a sequence once. A prefix is pruned if the
    plan after it guarantees more than the least value found, as neither strategy falls below its
    plan. A plan for an expectation guarantees nothing, so few prefixes are pruned. Any other
    strategy may have a memory, so it plays every sequence from the start: N! games, times the
    delays. It must play the same game whenever it is started with the same seed.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> worst = covey.worst_case(team, disk)
    >>> worst.survival_time >= covey.plan(team, disk).survival_time - 1e-9
    True
    """
    evaders = team_strategy(evaders)
    checked = checked_settings(team, disk, "hidden", update_time, seed, None, objective)
    settings = replace(checked, time_limit=math.inf)  # captures that wait may come after it
    waits = tuple(dict.fromkeys(number("delays", delay, low=0.0) for delay in delays))
    if not waits:
        raise InputError("delays: expected at least one, got none")
    if team_is_built_in(evaders):
        tree = Tree(team, disk, evaders, waits, settings)
        tree.explore()
        worst, flights = tree.worst, tree.flights
    else:
        games = [*all_games(team, disk, evaders, waits, settings)]
        worst = min(games, key=lambda captures: value_of(captures, settings.objective))
        flights = len(games) * len(team)
    return WorstCase(
        survival_time=worst[-1].time,
        value=value_of(worst, settings.objective),
        sequence=tuple(capture.evader for capture in worst),
        capture_times=tuple(capture.time for capture in worst),
        delays=tuple(capture.delay for capture in worst),
        scope=WorstCaseScope.DELAYED if any(waits) else WorstCaseScope.PROMPT,
        flights=flights,
        unit=team.unit,
    )
