"""Plays the games of one start in all cases of a study."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from covey.players import simulate, survival
from covey.simulation import Game, Outcome
from covey.studies.design.as_visible import AsVisible
from covey.studies.design.case import Case, InitialState, game_of
from covey.studies.design.study import Study


class StudyGame(NamedTuple):
    """A game that was played, as a study counts it."""

    number: int
    case: int
    start: int
    origin: InitialState
    outcome: Outcome
    record: Game | None  # None unless the study stores trajectories


class GameError(Exception):
    """A game that couldn't be played: its number in the study, its seed, the error's text."""

    def __init__(self, number: int, seed: int, message: str) -> None:
        super().__init__(number, seed, message)  # all arguments: pickle needs them
        self.number, self.seed, self.message = number, seed, message

    def __str__(self) -> str:
        """Return the line that is shown to the user."""
        return f"game {self.number} (seed {self.seed}): {self.message}"


def play_start(study: Study, number: int) -> Iterator[StudyGame]:
    """Play all games of a start, in the order of the cases."""
    visible: dict[tuple[Any, ...], Outcome] = {}
    for k, case in enumerate(study.cases):
        start = study.start(number, case.team_size)
        game = number * len(study.cases) + k
        try:
            outcome, record = _play(case, start, visible, study.trajectories)
        except Exception as error:
            message = f"{type(error).__name__}: {error}"
            raise GameError(game, start.seed, message) from error
        yield StudyGame(game, k, number, start, outcome, record)


def _play(
    case: Case, start: InitialState, visible: dict[tuple[Any, ...], Outcome], recorded: bool
) -> tuple[Outcome, Game | None]:
    """Play a game; `visible` holds the outcomes of visible games of this start, and gets new ones.

    A hidden `AsVisible` pursuer needs the captures of the visible game, which is played once.
    """
    if not isinstance(case.pursuer, AsVisible):
        return _play_as(case, start, recorded)
    key = _without_sensing(case)
    seen = case._replace(sensing="visible", pursuer=case.pursuer.visible())
    if case.sensing == "visible":
        outcome, record = _play_as(seen, start, recorded)
        visible[key] = outcome
        return outcome, record
    if key not in visible:
        visible[key], _ = _play_as(seen, start, False)
    pursuer = case.pursuer.hidden(visible[key], case.team_size)
    return _play_as(case._replace(pursuer=pursuer), start, recorded)


def _without_sensing(case: Case) -> tuple[Any, ...]:
    """Return a key of a case that is equal for cases that differ in sensing only.

    Strategies may not be hashable. Their identities stand for them, as they live as long as the
    study.
    """
    values = case._asdict() | {"evaders": id(case.evaders), "pursuer": id(case.pursuer)}
    del values["sensing"]
    return tuple(values.values())


def _play_as(case: Case, start: InitialState, recorded: bool) -> tuple[Outcome, Game | None]:
    arguments: dict[str, Any] = {
        "evaders": case.evaders,
        "pursuer": case.pursuer,
        "sensing": case.sensing,
        "update_time": case.update_time,
        "seed": start.seed,
        "objective": case.objective,
    }
    if recorded:
        game = simulate(*game_of(case, start), **arguments)
        return game.outcome(), game
    return survival(*game_of(case, start), **arguments), None
