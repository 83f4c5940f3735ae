"""The messages of a page, and their limits. The server answers anything else with an error."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from covey.model import InputError
from covey.web.game.choices import Choices

MOST_CHARACTERS = 2000
MOST_MISTAKES = 10
"""That are told; a message can make hundreds, and the answer would be many times as long."""

_Coordinate = Annotated[float, Field(ge=-1e4, le=1e4)]


class _Message(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class New(_Message):
    """Set up a game, which waits for `Run` or `Step`."""

    type: Literal["new"]
    choices: Choices


class Steer(_Message):
    """Fly to a point or along a heading, radians; with neither, wait."""

    type: Literal["steer"]
    target: tuple[_Coordinate, _Coordinate] | None = None
    heading: Annotated[float, Field(ge=-100.0, le=100.0)] | None = None


class Run(_Message):
    """Let time run, `pace` times as fast as real time."""

    type: Literal["run"]
    pace: Annotated[float, Field(ge=0.1, le=2.0)] = 1.0


class Pause(_Message):
    """Let time stand still."""

    type: Literal["pause"]


class Step(_Message):
    """Play `session.STEP_UPDATES` updates, and pause."""

    type: Literal["step"]


class Film(_Message):
    """Send a whole game, for the page to replay."""

    type: Literal["film"]
    game: Literal["yours", "reference"]


class Save(_Message):
    """Send the record of a whole game, as a file."""

    type: Literal["save"]
    game: Literal["yours", "reference"]


Message = New | Steer | Run | Pause | Step | Film | Save

_adapter: TypeAdapter[Message] = TypeAdapter(Annotated[Message, Field(discriminator="type")])


def read_message(text: str) -> Message:
    """Return the message, or raise InputError that says its mistakes."""
    if len(text) > MOST_CHARACTERS:
        raise InputError(f"message: expected at most {MOST_CHARACTERS} characters, got {len(text)}")
    try:
        return _adapter.validate_json(text)
    except ValidationError as error:
        raise InputError("; ".join(_mistakes(error))) from None


def is_quick(message: str | bytes) -> bool:
    """Return whether an answer takes no longer than a frame of a game."""
    if isinstance(message, bytes):
        return False
    try:
        return not isinstance(read_message(message), New | Film | Save)
    except InputError:
        return True


def _mistakes(error: ValidationError) -> list[str]:
    mistakes = []
    for detail in error.errors(include_url=False, include_input=False):
        key_path = ".".join(str(key) for key in detail["loc"][1:]) or "message"
        mistakes.append(f"{key_path}: {detail['msg']}")
    more = len(mistakes) - MOST_MISTAKES
    return mistakes if more <= 0 else [*mistakes[:MOST_MISTAKES], f"and {more} more"]
