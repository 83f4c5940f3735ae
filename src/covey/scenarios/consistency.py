"""What must fit together in a scenario file, beyond the single values.

The checks read the file as it stands, mistakes and all, and pass over what can't be read: that one
has been told already, and a mistake in one place must not hide another.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from covey.kernels.minimum.last_capture import MOST_EVADERS
from covey.scenarios.mistakes import Mistake, Place, wanted_but_got
from covey.scenarios.schema import PursuerSection, TeamSection
from covey.scenarios.strategies import (
    EVADERS,
    OBJECTIVES,
    PURSUERS,
    Entry,
    misfits_of_parameters,
    strategy_mistakes,
)
from covey.scenarios.values import AWAY, as_not_negative, as_point, as_positive, as_whole

Document = Mapping[str, Any]

_WITH_PARAMETERS: Mapping[Place, Mapping[str, Entry]] = {
    ("team", "strategy"): EVADERS,
    ("pursuer", "strategy"): PURSUERS,
    ("game", "objective"): OBJECTIVES,
}


def crosschecks(document: Document) -> Iterator[Mistake]:
    """Find what doesn't fit together in a file, and the mistakes of what has parameters."""
    yield from _team_size(document)
    yield from _speeds(document)
    yield from _headings(document)
    for place in _WITH_PARAMETERS:
        yield from _parameters(document, place)


def _team_size(document: Document) -> Iterator[Mistake]:
    evaders, random = _look(document, "team", "evaders"), _look(document, "team", "random")
    wanted = f"1 to {MOST_EVADERS} evaders"
    if evaders and random is not None:
        text = "expected the evaders of [[team.evaders]] or those of [team.random], got both"
        yield Mistake(("team", "random"), text)
    if random is not None:
        count = _look(document, "team", "random", "count")
        if as_whole(count) is not None and not 1 <= count <= MOST_EVADERS:
            yield Mistake(("team", "random", "count"), wanted_but_got(wanted, count))
    elif not evaders and isinstance(_look(document, "team", default={}), dict):
        yield Mistake(
            ("team", "evaders"),
            f"expected {wanted}, got none; add a [[team.evaders]] table with a position for each, "
            "or [team.random] with a count",
        )
    elif isinstance(evaders, list) and len(evaders) > MOST_EVADERS:
        yield Mistake(("team", "evaders"), wanted_but_got(wanted, len(evaders)))


def _speeds(document: Document) -> Iterator[Mistake]:
    limit = as_positive(_look(document, "pursuer", "speed", default=_default(PursuerSection)))
    for place, given in _speed_places(document):
        speed = as_not_negative(given)
        if limit is not None and speed is not None and speed >= limit:
            note = "" if _look(document, *place) is not None else ", the default"
            yield Mistake(
                place,
                f"expected every evader to be slower than the pursuer ({limit:g}), or it could "
                f"flee for ever; got {speed:g}{note}",
            )


def _speed_places(document: Document) -> Iterator[tuple[Place, object]]:
    """All places that give an evader its speed, and the speeds there."""
    own = dict(
        enumerate(
            _look(document, "team", "evaders", index, "speed")
            for index in range(len(_evaders(document)))
        )
    )
    if not own or None in own.values():
        shared = _look(document, "team", "speed", default=_default(TeamSection))
        yield ("team", "speed"), shared
    for index, speed in own.items():
        yield ("team", "evaders", index, "speed"), speed


def _headings(document: Document) -> Iterator[Mistake]:
    center = as_point(_look(document, "pursuer", "center", default=[0.0, 0.0]))
    shared = _look(document, "team", "headings", default=AWAY)
    for index in range(len(_evaders(document))):
        place = ("team", "evaders", index)
        heading = _look(document, *place, "heading", default=shared)
        position = as_point(_look(document, *place, "position"))
        if heading == AWAY and position is not None and position == center:
            yield Mistake(
                (*place, "heading"),
                f'expected a heading in radians, got "{AWAY}" for an evader at the centre of the '
                "pursuer's disk, from where every heading leads away",
            )


def _parameters(document: Document, place: Place) -> Iterator[Mistake]:
    value, known = _look(document, *place), _WITH_PARAMETERS[place]
    if value is None:
        return
    mistakes = [*strategy_mistakes(place, value, known), *_sequences(document, place)]
    yield from mistakes or misfits_of_parameters(place, value, known)


def _sequences(document: Document, place: Place) -> Iterator[Mistake]:
    count = len(_evaders(document)) or as_whole(_look(document, "team", "random", "count"))
    several = _look(document, *place, "sequences")
    given = {(*place, "sequence"): _look(document, *place, "sequence")}
    given |= {(*place, "sequences", k): each for k, each in enumerate(_list(several))}
    for where, sequence in given.items():
        readable = isinstance(sequence, list) and all(as_whole(i) is not None for i in sequence)
        if count and readable and sorted(sequence) != list(range(count)):
            yield Mistake(where, wanted_but_got(f"each evader 0..{count - 1} once", sequence))


def _evaders(document: Document) -> list[Any]:
    return _list(_look(document, "team", "evaders"))


def _list(value: Any) -> list[Any]:
    return value if isinstance(value, list) else []


def _default(section: type[PursuerSection] | type[TeamSection]) -> Any:
    return section.model_fields["speed"].default


def _look(document: Any, *place: str | int, default: Any = None) -> Any:
    """Return what stands at a place of the file; `default` if nothing does."""
    try:
        for key in place:
            document = document[key]
    except (KeyError, TypeError):  # not there, or below a value that should have been a table
        return default
    return document
