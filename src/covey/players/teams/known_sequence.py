"""The flight for a known capture sequence, after Chikrii and others and Belousov and others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from covey.bounds.announced_sequence import best_announcement
from covey.bounds.fixed_sequence import plan_for_sequence
from covey.model.validation import Floats, checked_sequence, require_whole_team
from covey.players.teams.replan_interval import checked_replan_time, paced
from covey.simulation import Situation, TeamPolicy


@dataclass(frozen=True)
class KnownSequence:
    """Fly so that a pursuer which keeps to a known sequence has captured everybody latest.

    The fixed-sequence problem of the references, which the paper names as [7] and [8]: for each
    sequence s the maximum of f_s over the turns. It is the best flight against a pursuer that has
    announced its sequence and keeps to it, and no guarantee against one that doesn't.

    Parameters
    ----------
    sequence
        Each evader's number once, or None: the sequence that `BestSequence` would choose at the
        start of the game.
    replan_time
        Least time between two plans, >= 0; 0 plans at every update. A capture brings a new plan at
        once, for what is left of the sequence.

    References
    ----------
    A. A. Chikrii, L. A. Sobolenko and S. F. Kalashnikova, "A numerical method for the solution of
    the successive pursuit-and-evasion problem", Cybernetics 24 (1988).
    A. Belousov, Y. Berdyshev, A. Chentsov and A. Chikrii, "Solving the dynamic traveling salesman
    game problem", Cybernetics and Systems Analysis 46 (2010).
    """

    sequence: tuple[int, ...] | None = None
    replan_time: float = 0.0

    def __init__(self, sequence: Sequence[int] | None = None, replan_time: float = 0.0) -> None:
        order = None if sequence is None else checked_sequence("KnownSequence", sequence)
        object.__setattr__(self, "sequence", order)
        object.__setattr__(self, "replan_time", replan_time)
        checked_replan_time(self)

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        known = {} if self.sequence is None else {"sequence": list(self.sequence)}
        return {"name": "known-sequence", **known, "replan_time": self.replan_time}

    def start(self, seed: int) -> TeamPolicy:  # noqa: ARG002 the protocol's signature
        """Return the policy of one game."""
        sequence: tuple[int, ...] = ()

        def turns(situation: Situation) -> Floats:
            nonlocal sequence
            sequence = sequence or self._first_sequence(situation)
            living = situation.evaders
            rows = [living.index(i) for i in sequence if i in living]
            return plan_for_sequence(situation.team, situation.disk, rows).turns

        return paced(turns, self.replan_time)

    def _first_sequence(self, situation: Situation) -> tuple[int, ...]:
        if self.sequence is None:
            rows = best_announcement(situation.team, situation.disk, ()).sequence
            return tuple(situation.evaders[row] for row in rows)
        require_whole_team("KnownSequence", self.sequence, len(situation.evaders))
        return self.sequence
