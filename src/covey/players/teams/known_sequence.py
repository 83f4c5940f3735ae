"""The flight for a known capture sequence, after Chikrii and others and Belousov and others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from covey.bounds.announced_sequence import best_announcement
from covey.bounds.fixed_sequence import plan_for_sequence
from covey.model.validation import Floats, checked_sequence, require_whole_team
from covey.players.teams.replan_interval import ReplanningTeam
from covey.simulation import Situation, TeamPolicy


@dataclass(frozen=True)
class KnownSequence(ReplanningTeam):
    """Maximise the last capture time of a pursuer that keeps to a known sequence.

    The fixed-sequence problem of the references, the paper's [7] and [8]: for each sequence s the
    maximum of f_s over the turns. The plan is the best flight against a pursuer that keeps to an
    announced sequence. Against any other pursuer it guarantees nothing.

    Parameters
    ----------
    sequence
        Each evader's number once, or None: the sequence that `BestSequence` would choose at the
        start of the game.
    replan_time
        Least time between two plans, >= 0. With 0 the team plans at every update. It always plans
        after a capture, for the rest of the sequence.

    References
    ----------
    A. A. Chikrii, L. A. Sobolenko and S. F. Kalashnikova, "A numerical method for the solution of
    the successive pursuit-and-evasion problem", Cybernetics 24 (1988).
    A. Belousov, Y. Berdyshev, A. Chentsov and A. Chikrii, "Solving the dynamic traveling salesman
    game problem", Cybernetics and Systems Analysis 46 (2010).

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> sequence = [2, 0, 1]
    >>> told, pursuer = covey.KnownSequence(sequence), covey.FixedSequence(sequence)
    >>> game = covey.simulate(team, disk, evaders=told, pursuer=pursuer, update_time=0.1)
    >>> round(game.survival_time, 2)
    3.62
    """

    file_name = "known-sequence"
    sequence: tuple[int, ...] | None = None
    replan_time: float = 0.0

    def __init__(self, sequence: Sequence[int] | None = None, replan_time: float = 0.0) -> None:
        order = None if sequence is None else checked_sequence("KnownSequence", sequence)
        object.__setattr__(self, "sequence", order)
        object.__setattr__(self, "replan_time", replan_time)
        super().__post_init__()

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a scenario file gives them."""
        given = {} if self.sequence is None else {"sequence": list(self.sequence)}
        return {"name": self.file_name, **given, "replan_time": self.replan_time}

    def planner(self, seed: int) -> TeamPolicy:  # noqa: ARG002 nothing is drawn
        """Return the function that makes the plans of one game."""
        sequence: tuple[int, ...] = ()

        def turns(situation: Situation) -> Floats:
            nonlocal sequence
            sequence = sequence or self._first_sequence(situation)
            living = situation.evaders
            rows = [living.index(i) for i in sequence if i in living]
            return plan_for_sequence(situation.team, situation.disk, rows).turns

        return turns

    def _first_sequence(self, situation: Situation) -> tuple[int, ...]:
        if self.sequence is None:
            rows = best_announcement(situation.team, situation.disk, ()).sequence
            return tuple(situation.evaders[row] for row in rows)
        require_whole_team("KnownSequence", self.sequence, len(situation.evaders))
        return self.sequence
