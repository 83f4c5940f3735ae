"""What one page has on the server: its game, its clock, and the answers to its messages."""

from __future__ import annotations

from collections.abc import Iterator
from io import BytesIO
from typing import Any

from covey.model import InputError
from covey.simulation import Game
from covey.simulation.storage import write_game
from covey.web.clock import Clock
from covey.web.game_json import cast, film, picture
from covey.web.human_game import TIME_LIMIT, UPDATE_TIME, Round
from covey.web.messages import Film, New, Pause, Run, Save, Steer, Step, read_message
from covey.web.upload import opened_film

STEP_UPDATES = 10
"""Of a step by hand: enough to be seen."""

Reply = dict[str, Any] | bytes
"""What a page is told, as JSON says it; bytes are a file."""


class Session:
    """A page's game. It knows nothing of sockets; `now` is in seconds of any steady clock."""

    def __init__(self) -> None:
        self._clock = Clock(UPDATE_TIME)
        self._round: Round | None = None
        self._owes_optimal = False

    @property
    def busy(self) -> bool:
        """Whether `advance` has something to do."""
        return self._clock.running or self._owes_optimal

    def receive(self, message: str | bytes, now: float) -> Iterator[Reply]:
        """Do what a page asks for, and answer; a mistake is answered too, and changes nothing."""
        try:
            if isinstance(message, bytes):
                yield {"type": "film", "game": "opened", **opened_film(message)}
            else:
                yield from self._answer(message, now)
        except InputError as error:
            yield error_reply(str(error))

    def advance(self, now: float) -> Iterator[Reply]:
        """Do what is due: the optimal game at first, then updates and, when they end, the score."""
        if self._owes_optimal:
            self._owes_optimal = False
            optimal = self._required_round().optimal
            yield {"type": "optimal", "survival_time": optimal.survival_time}
        updates = self._clock.due(now)
        if updates:
            yield from self._play(updates, now)

    def _answer(self, text: str, now: float) -> Iterator[Reply]:
        message = read_message(text)
        if isinstance(message, New):
            yield self._set_up(message)
            return
        game = self._required_round()
        match message:
            case Steer(target=target, heading=heading):
                game.person.steer(target, heading)
            case Run(pace=pace) if not game.over:
                self._clock.pace = pace
                self._clock.run(now)
            case Pause():
                self._clock.pause()
            case Step() if not game.over:
                self._clock.pause()
                yield from self._play(STEP_UPDATES, now)
            case Film(game=which):
                yield {"type": "film", "game": which, **film(self._whole_game(which))}
            case Save(game=which):
                yield _file(self._whole_game(which))

    def _set_up(self, message: New) -> Reply:
        game = Round(message.choices)
        self._clock.pause()
        self._round, self._owes_optimal = game, True
        start = game.record()
        return {
            "type": "game",
            "choices": message.choices.model_dump(),
            "cast": cast(start),
            "picture": picture(start, 0),
            "update_time": UPDATE_TIME,
            "time_limit": TIME_LIMIT,
        }

    def _play(self, updates: int, now: float) -> Iterator[Reply]:
        game = self._required_round()
        self._clock.count(now, game.play(updates))
        yield {"type": "frame", "rate": self._clock.rate(now), **picture(game.record(), -1)}
        if game.over:
            self._clock.pause()
            yield {"type": "over", **game.score()._asdict()}

    def _whole_game(self, which: str) -> Game:
        game = self._required_round()
        if which == "optimal":
            return game.optimal
        if not game.over:
            raise InputError("your game isn't over yet; play it to its end first")
        return game.record()

    def _required_round(self) -> Round:
        if self._round is None:
            raise InputError('there is no game yet; ask for one with "new" first')
        return self._round


def error_reply(text: str) -> Reply:
    """Return the answer to a message that can't be done."""
    return {"type": "error", "text": text}


def _file(game: Game) -> bytes:
    buffer = BytesIO()
    write_game(game, buffer)
    return buffer.getvalue()
