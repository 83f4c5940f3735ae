"""What a page may say, and how long it may be; anything else is answered with an error."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from covey.model import InputError
from covey.web.choices import Choices

MOST_CHARACTERS = 2000

_Coordinate = Annotated[float, Field(ge=-1e4, le=1e4)]


class _Message(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class New(_Message):
    """Set up a game; it waits to be run."""

    type: Literal["new"]
    choices: Choices


class Steer(_Message):
    """Make for a point, or fly a heading in radians; with neither, wait."""

    type: Literal["steer"]
    target: tuple[_Coordinate, _Coordinate] | None = None
    heading: Annotated[float, Field(ge=-100.0, le=100.0)] | None = None


class Run(_Message):
    """Let time run, so many times as fast as the wall's."""

    type: Literal["run"]
    pace: Annotated[float, Field(ge=0.1, le=2.0)] = 1.0


class Pause(_Message):
    """Let time stand still."""

    type: Literal["pause"]


class Step(_Message):
    """Play one update, and pause."""

    type: Literal["step"]


class Film(_Message):
    """Send a whole game to be looked at."""

    type: Literal["film"]
    game: Literal["yours", "optimal"]


class Save(_Message):
    """Send the record of a game, as a file."""

    type: Literal["save"]
    game: Literal["yours", "optimal"]


Message = New | Steer | Run | Pause | Step | Film | Save

_adapter: TypeAdapter[Message] = TypeAdapter(Annotated[Message, Field(discriminator="type")])


def read_message(text: str) -> Message:
    """Return the message, or raise InputError that says what is wrong with it."""
    if len(text) > MOST_CHARACTERS:
        raise InputError(f"message: expected at most {MOST_CHARACTERS} characters, got {len(text)}")
    try:
        return _adapter.validate_json(text)
    except ValidationError as error:
        raise InputError("; ".join(_mistakes(error))) from None


def _mistakes(error: ValidationError) -> list[str]:
    mistakes = []
    for detail in error.errors(include_url=False, include_input=False):
        place = ".".join(str(key) for key in detail["loc"][1:]) or "message"
        mistakes.append(f"{place}: {detail['msg']}")
    return mistakes
