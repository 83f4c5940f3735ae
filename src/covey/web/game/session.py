"""A page's session on the server: its game, its pace, and the answers to its messages."""

from __future__ import annotations

from collections.abc import Iterator
from io import BytesIO
from typing import Any

from covey.model import InputError
from covey.simulation import Game
from covey.simulation.storage import write_game
from covey.web.game.game_json import film, frame, header
from covey.web.game.human_game import TIME_LIMIT, UPDATE_TIME, HumanGame
from covey.web.game.messages import Film, New, Pause, Run, Save, Steer, Step, read_message
from covey.web.game.pacing import Pacer
from covey.web.game.upload import read_upload
from covey.web.worker import worker

STEP_UPDATES = 10
"""Updates of a step by hand: enough to be seen."""

Reply = dict[str, Any] | str | bytes | None
"""A message to the page, sent as JSON, or JSON already; bytes are a file.

None is no message: between two updates, other pages may have a turn.
"""


class Session:
    """A page's session. It knows nothing of sockets; `now` is in seconds of any monotonic clock.

    Attributes
    ----------
    reference_pending : bool
        Whether `advance` will play the reference game, which takes long.
    """

    def __init__(self) -> None:
        self._pacer = Pacer(UPDATE_TIME)
        self._game: HumanGame | None = None
        self.reference_pending = False

    @property
    def busy(self) -> bool:
        """Whether `advance` has something to do."""
        return self._pacer.running or self.reference_pending

    def receive(self, message: str | bytes, now: float) -> Iterator[Reply]:
        """Do what a page asks for, and answer. A mistake is answered too, and changes nothing."""
        try:
            if isinstance(message, bytes):
                yield worker.call(read_upload, message)
            else:
                yield from self._answer(message, now)
        except InputError as error:
            yield error_reply(str(error))

    def advance(self, now: float) -> Iterator[Reply]:
        """Do what is due: the reference game first, then updates and, at the end, the score."""
        if self.reference_pending:
            self.reference_pending = False
            game = self._current_game()
            times = {"survival_time": game.reference.survival_time, "assurance": game.assurance}
            yield {"type": "reference", **times}
        updates = self._pacer.due(now)
        if updates:
            yield from self._play(updates, now)

    def _answer(self, text: str, now: float) -> Iterator[Reply]:
        message = read_message(text)
        if isinstance(message, New):
            yield self._set_up(message)
            return
        game = self._current_game()
        match message:
            case Steer(target=target, heading=heading):
                game.pursuer.steer(target, heading)
            case Run(pace=pace) if not game.over:
                self._pacer.pace = pace
                self._pacer.run(now)
            case Pause():
                self._pacer.pause()
            case Step() if not game.over:
                self._pacer.pause()
                yield from self._play(STEP_UPDATES, now)
            case Film(game=which):
                yield worker.call(film, self._whole_game(which), which)
            case Save(game=which):
                yield worker.call(_file, self._whole_game(which))

    def _set_up(self, message: New) -> Reply:
        game = HumanGame(message.choices)
        self._pacer.pause()
        self._game, self.reference_pending = game, True
        start = game.record()
        return {
            "type": "game",
            "choices": message.choices.model_dump(),
            "cast": header(start),
            "picture": frame(start, 0),
            "update_time": UPDATE_TIME,
            "time_limit": TIME_LIMIT,
        }

    def _play(self, updates: int, now: float) -> Iterator[Reply]:
        game, played = self._current_game(), 0
        for _ in range(updates):
            played += game.advance(1)
            yield None
        self._pacer.count(now, played)
        yield {"type": "frame", "rate": self._pacer.rate(now), **frame(game.record(), -1)}
        if game.over:
            self._pacer.pause()
            yield {"type": "over", **game.score()._asdict()}

    def _whole_game(self, which: str) -> Game:
        game = self._current_game()
        if which == "reference":
            return game.reference
        if not game.over:
            raise InputError("your game isn't over yet; play it to its end first")
        return game.record()

    def _current_game(self) -> HumanGame:
        if self._game is None:
            raise InputError('there is no game yet; ask for one with "new" first')
        return self._game


def error_reply(text: str) -> dict[str, Any]:
    """Return the answer to a mistake."""
    return {"type": "error", "text": text}


def _file(game: Game) -> bytes:
    buffer = BytesIO()
    write_game(game, buffer)
    return buffer.getvalue()
