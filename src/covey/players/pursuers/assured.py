"""The pursuer with a guarantee: the mirror image of a team that plans again."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from covey.bounds import plan_for_sequence
from covey.bounds.candidates import Candidates
from covey.bounds.polygon_bound import last_capture_bound
from covey.bounds.upper_end import UpperEnd, earliest_end
from covey.model import PursuerDisk, Team
from covey.planning import capture_times
from covey.planning.border import about_center
from covey.players.pursuers.parallel_approach import after_flight, approaches
from covey.simulation import Chase, Fly, PursuerPolicy, Situation

_EQUAL = 1e-9
"""Relative difference up to which two sequences assure the same time."""


@dataclass(frozen=True)
class AssuredPursuer:
    """Follow the sequence with the earliest time by which everybody is captured for sure.

    A pursuer that keeps to a sequence, and flies to each evader with the line of sight at a
    constant bearing, has captured everybody by a time that no flight of the evaders puts off: the
    fixed-sequence value for unlimited turn rates (docs/decisions/0006). This pursuer computes
    that time at every update, for the sequence that it follows and for all that may be better. It
    takes another sequence only if that one is proven to be better. A pursuer without a reach begins
    with the turn rates as well (docs/decisions/0017). So its assurance never rises.
    `Game.assurances` records it.

    Notes
    -----
    Among sequences that assure the same, the pursuer takes the one that ends earliest against the
    announced plans. Up to six evaders all sequences are compared; with more, those that a beam
    search finds.

    A visible pursuer that begins in a disk starts at the best point that a few improvements find. A
    hidden pursuer that the rules know as a disk only can't be steered: it keeps to the first
    sequence, and its first assurance holds. The game is taken to be about the last capture,
    whatever the objective is.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> game = covey.simulate(team, disk, pursuer=covey.AssuredPursuer(), update_time=0.1)
    >>> round(game.survival_time, 2)
    3.38
    """

    def describe(self) -> Mapping[str, Any]:
        """Return the name, as a scenario file gives it."""
        return {"name": "assured"}

    def start(self, seed: int) -> PursuerPolicy:  # noqa: ARG002 nothing is drawn
        """Return the policy of one game."""
        return _AssuredPolicy()


class _AssuredPolicy:
    """The policy of an `AssuredPursuer` in one game."""

    in_any_frame = True

    def __init__(self) -> None:
        self._sequence: tuple[int, ...] = ()  # by evader number, of the living
        self._assurance = math.inf
        self._candidates: Candidates | None = None

    def __call__(self, situation: Situation) -> Chase | Fly:
        """Follow the sequence, or one that is proven to be better."""
        living = situation.evaders
        if not self._sequence:
            return self._begin(situation)
        if len(living) < len(self._sequence):
            self._sequence = tuple(i for i in self._sequence if i in living)
            self._candidates = None
        if situation.place is None:
            return Chase(self._sequence, self._assurance)
        proven = self._proven(situation, self._assurance)
        proven[self._sequence] = min(proven.get(self._sequence, math.inf), self._assurance)
        highest = min(min(proven.values()) * (1.0 + _EQUAL), self._assurance)
        self._take_earliest(proven, 0.0, highest, situation)
        return self._follow(situation)

    def _begin(self, situation: Situation) -> Chase | Fly:
        """Announce the best sequence that is found, or one that assures the same."""
        end = _first_end(situation.team, situation.pursuer)
        start = situation.pursuer.center + end.start
        self._sequence = tuple(situation.evaders[row] for row in end.sequence)
        self._assurance = situation.time + end.time
        if situation.place is None and not situation.chooses_start:
            return Chase(self._sequence, self._assurance)
        started = replace(situation, place=start)
        lowest, highest = ((1.0 + off) * self._assurance for off in (-_EQUAL, _EQUAL))
        proven = self._proven(started, highest) | {self._sequence: self._assurance}
        self._take_earliest(proven, lowest, highest, started)
        decision = self._follow(started)
        if isinstance(decision, Fly) and situation.chooses_start:
            x, y = (start - situation.disk.center).tolist()
            return replace(decision, offset=(x, y))
        return decision

    def _proven(self, situation: Situation, cutoff: float) -> dict[tuple[int, ...], float]:
        """Return proven times, since the start, for the sequences that may end by the cutoff."""
        team, pursuer, time = situation.team, situation.pursuer, situation.time
        if self._candidates is None:
            self._candidates = Candidates(team, pursuer)
        sequences, living = self._candidates.sequences, situation.evaders
        bounds = self._candidates.better_than(cutoff - time, team, pursuer)
        return {
            tuple(living[i] for i in sequences[row]): time + bound for row, bound in bounds.items()
        }

    def _take_earliest(
        self,
        proven: Mapping[tuple[int, ...], float],
        lowest: float,
        highest: float,
        situation: Situation,
    ) -> None:
        """Of the sequences proven to end in an interval, take the best against the plans."""
        equal = [sequence for sequence, time in proven.items() if lowest <= time <= highest]
        if len(equal) > 1:
            equal.sort(key=lambda sequence: _planned_end(sequence, situation))
        self._sequence = equal[0]
        self._assurance = proven[self._sequence]

    def _follow(self, situation: Situation) -> Chase | Fly:
        velocities = approaches(situation, situation.evaders.index(self._sequence[0]))
        if not velocities:
            return Chase(self._sequence, self._assurance)
        if len(velocities) > 1:
            velocities.sort(key=lambda velocity: _proven_end(self._sequence, situation, velocity))
        return Fly(velocities[0], self._sequence, self._assurance)


def _first_end(team: Team, disk: PursuerDisk) -> UpperEnd:
    """Return the earliest end of a pursuer that flies by parallel approach from the beginning.

    With a reach it compares ends that don't need turn limits where a flight may touch somebody, so
    that it can't be sure of another.
    """
    openings = (0.0,) if disk.capture_radius == 0.0 else ()
    return earliest_end(*about_center(team, disk), openings=openings)


def _planned_end(sequence: Iterable[int], situation: Situation) -> float:
    """Return the last capture in a sequence if all fly what they have announced."""
    rows = [situation.evaders.index(i) for i in sequence]
    return float(capture_times(situation.team, situation.pursuer, situation.turns, rows)[-1])


def _proven_end(
    sequence: tuple[int, ...], situation: Situation, velocity: tuple[float, float]
) -> float:
    """Return a time by which everybody is captured in a sequence, after a flight."""
    time, end = after_flight(situation, velocity)
    if end is None:
        return time
    rows = [end.evaders.index(i) for i in sequence if i in end.evaders]
    agile = Team(end.team.positions, end.team.headings, end.team.speeds, math.inf)
    point = PursuerDisk(end.pursuer.center, 0.0, end.pursuer.speed)
    return time + last_capture_bound(agile, end.pursuer, plan_for_sequence(agile, point, rows))
