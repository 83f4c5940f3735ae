"""A game that a person plays, the best pursuer's game from the same start, and the score."""

from __future__ import annotations

import math
from functools import cached_property
from typing import NamedTuple

from covey.bounds import bracket
from covey.model import InputError
from covey.players import BestSequence, CommittedPursuer, simulate
from covey.simulation import Game, Settings
from covey.simulation.match import Match
from covey.web.game.choices import Choices
from covey.web.game.human_pursuer import HumanPursuer
from covey.web.worker import worker

UPDATE_TIME = 0.005
"""Of the game's time: even at a quarter of real time the team plans every 20 ms."""

TIME_LIMIT = 120.0
"""A game is stopped then: nobody chases for longer."""

_ROUNDING = 1e-9
"""Relative: two pursuers that capture in the same order are equally quick up to this."""

LONGEST_GUARANTEE = 60.0
"""Games with a longer guarantee are refused: they could hardly be won before the time limit."""


class GameScore(NamedTuple):
    """A person against the best pursuer known; None where not everybody was captured.

    Attributes
    ----------
    time : float or None
        Survival time of the team against the person.
    share : float
        Survival time against that pursuer over `time`: 1 is as good, 0 if `time` is None.
    """

    time: float | None
    share: float


class HumanGame:
    """A game that a person plays.

    Raises
    ------
    InputError
        If the guarantee of the team is above `LONGEST_GUARANTEE`.
    """

    def __init__(self, choices: Choices) -> None:
        self._choices = choices
        self.pursuer = HumanPursuer(UPDATE_TIME)
        settings = Settings(choices.sensing, UPDATE_TIME, choices.seed, TIME_LIMIT)
        self._match = Match(*choices.game(), choices.team_strategy(), self.pursuer, settings)
        guarantee = self._match.record().guarantee
        if guarantee > LONGEST_GUARANTEE:
            raise InputError(
                f"choices: this team is sure to survive for {guarantee:.0f}, and more than "
                f"{LONGEST_GUARANTEE:.0f} is too long to chase; take fewer or slower evaders"
            )

    @property
    def over(self) -> bool:
        """Whether everybody is captured, or the time limit is reached."""
        return self._match.over

    def advance(self, updates: int) -> int:
        """Play `updates` updates, or fewer to the end; return the number played."""
        for played in range(updates):
            if self.over:
                return played
            self._match.step()
        return updates

    def record(self) -> Game:
        """Return what has happened until now."""
        return self._match.record()

    @cached_property
    def reference(self) -> Game:
        """The game of the best pursuer known against the same team."""
        in_order = self._play(BestSequence(), None)
        # Against a team that answers captures, the committed pursuer may never come to an end.
        as_quick = in_order.survival_time * (1.0 + _ROUNDING)
        committed = self._play(CommittedPursuer(), as_quick or None)
        return min(committed, in_order, key=lambda game: game.survival_time)

    @cached_property
    def assurance(self) -> float:
        """A time by which a pursuer can have captured everybody, whatever the team does."""
        team, disk = self._choices.game()
        return float(worker.call(bracket, team, disk, depth=0, seed=self._choices.seed).upper)

    def _play(self, pursuer: CommittedPursuer | BestSequence, time_limit: float | None) -> Game:
        team, disk = self._choices.game()
        return worker.call(
            simulate,
            team,
            disk,
            evaders=self._choices.team_strategy(),
            pursuer=pursuer,
            sensing=self._choices.sensing,
            update_time=UPDATE_TIME,
            seed=self._choices.seed,
            time_limit=time_limit,
        )

    def score(self) -> GameScore:
        """Return the score of a game that is over."""
        game = self.record()
        if math.isinf(game.survival_time):
            return GameScore(None, 0.0)
        time = game.survival_time
        # Both are 0 where everybody begins within the pursuer's reach.
        share = self.reference.survival_time / time if time > 0.0 else 1.0
        return GameScore(time, share)
