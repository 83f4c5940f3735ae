"""What a person can choose before a game, the limits of each choice, and the game it makes."""

from __future__ import annotations

from functools import cache
from typing import Literal, Self

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, model_validator

from covey.model import PursuerDisk, Team
from covey.model.validation import Floats
from covey.players import (
    ConstantHeading,
    Contingent,
    IterativeOpenLoop,
    LargestDistance,
    OpenLoop,
    SmallestDanger,
    StraightAway,
)
from covey.scenarios import example_path, load_scenario
from covey.scenarios.samplers import Formation, Sampler, Square
from covey.simulation import TeamStrategy

_REPLAN_TIME = 0.05
"""Of teams that plan in Python, which takes up to some 20 ms."""

MOST_ANSWERING = 8
"""Evaders that answer captures, at most: their first plan takes a second, that of 10 up to four."""

_TEAMS: dict[str, TeamStrategy] = {
    "iterative-open-loop": IterativeOpenLoop(),
    "open-loop": OpenLoop(),
    "contingent": Contingent(depth=1, replan_time=_REPLAN_TIME),
    "constant-heading": ConstantHeading(replan_time=_REPLAN_TIME),
    "largest-distance": LargestDistance(replan_time=_REPLAN_TIME),
    "smallest-danger": SmallestDanger(replan_time=_REPLAN_TIME),
    "straight-away": StraightAway(),
}
_SAMPLERS: dict[str, Sampler] = {"random": Square(), "formation": Formation()}
_FIG3_EVADERS = 5


class Choices(BaseModel):
    """One game: the same choices give the same start and the same team on every machine.

    The pursuer begins at the origin, and the team knows that. A person steers it, so it captures
    only with a capture radius > 0.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    evaders: int = Field(default=5, ge=1, le=10)
    speed: float = Field(default=0.25, ge=0.05, le=0.6)  # of each evader
    pursuer_speed: float = Field(default=1.0, ge=0.7, le=2.0)
    turn_rate: float = Field(default=1.57, ge=0.2, le=10.0)
    capture_radius: float = Field(default=0.03, ge=0.01, le=0.1)
    sensing: Literal["visible", "hidden"] = "visible"
    team: Literal[
        "iterative-open-loop",
        "open-loop",
        "contingent",
        "constant-heading",
        "largest-distance",
        "smallest-danger",
        "straight-away",
    ] = "iterative-open-loop"
    start: Literal["random", "formation", "fig3"] = "random"
    seed: int = Field(default=1, ge=0, lt=2**31)

    @model_validator(mode="after")
    def _count_fits_start(self) -> Self:
        if self.start == "fig3" and self.evaders != _FIG3_EVADERS:
            raise ValueError(f"the start of Fig. 3 has {_FIG3_EVADERS} evaders, got {self.evaders}")
        return self

    @model_validator(mode="after")
    def _count_fits_team(self) -> Self:
        if self.team == "contingent" and self.evaders > MOST_ANSWERING:
            raise ValueError(
                f"a team that answers captures has at most {MOST_ANSWERING} evaders, "
                f"got {self.evaders}"
            )
        return self

    def game(self) -> tuple[Team, PursuerDisk]:
        """Return the state at time 0."""
        positions, headings = self._start()
        return (
            Team(positions, headings, self.speed, self.turn_rate),
            PursuerDisk(speed=self.pursuer_speed, capture_radius=self.capture_radius),
        )

    def team_strategy(self) -> TeamStrategy:
        """Return how the team plans."""
        return _TEAMS[self.team]

    def _start(self) -> tuple[Floats, Floats]:
        if self.start == "fig3":
            return _fig3()
        generator = np.random.default_rng(self.seed)
        return _SAMPLERS[self.start].draw(0, self.evaders, generator)


@cache
def _fig3() -> tuple[Floats, Floats]:
    team = load_scenario(example_path("fig3")).team
    return team.positions, team.headings
