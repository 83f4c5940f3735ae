"""What must fit together in a scenario file, beyond the single values.

The checks read the raw document, so that a mistake in one path hides none elsewhere. Values that
can't be read are passed over: their mistakes are told already.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from covey.kernels.arrays import MOST_EVADERS
from covey.model.validation import is_slower
from covey.scenarios.mistakes import KeyPath, Mistake, look, wanted_but_got
from covey.scenarios.schema import PursuerSection, TeamSection
from covey.scenarios.values.kinds import (
    AWAY,
    as_not_negative,
    as_point,
    as_positive,
    as_sequence,
    as_whole,
)

Document = Mapping[str, Any]

_WITH_SEQUENCES = (("team", "strategy"), ("pursuer", "strategy"), ("game", "objective"))


def inconsistencies(document: Document) -> Iterator[Mistake]:
    """Find what doesn't fit together in a file."""
    yield from _team_size(document)
    yield from _alternatives(document)
    yield from _speeds(document)
    yield from _headings(document)
    for path in _WITH_SEQUENCES:
        yield from _sequences(document, path)


def not_both(one: str, other: KeyPath) -> Mistake:
    """Return the mistake of a key that stands beside another one, which says the same."""
    return Mistake(other, f"expected {one} or {other[-1]}, got both; leave one out")


def too_fast(path: KeyPath, speed: float, limit: float, note: str = "") -> Mistake:
    """Return the mistake of an evader's speed that isn't below `limit`, the pursuer's."""
    return Mistake(
        path,
        f"expected every evader to be slower than the pursuer ({limit:.12g}), or it could flee for "
        f"ever; got {speed:.12g}{note}",
    )


def _team_size(document: Document) -> Iterator[Mistake]:
    evaders, random = look(document, "team", "evaders"), look(document, "team", "random")
    wanted = f"1 to {MOST_EVADERS} evaders"
    if evaders and random is not None:
        text = "expected the evaders of [[team.evaders]] or those of [team.random], got both"
        yield Mistake(("team", "random"), text)
    if random is not None:
        count = look(document, "team", "random", "count")
        if as_whole(count) is not None and not 1 <= count <= MOST_EVADERS:
            yield Mistake(("team", "random", "count"), wanted_but_got(wanted, count))
    elif not evaders and isinstance(look(document, "team", default={}), dict):
        yield Mistake(
            ("team", "evaders"),
            f"expected {wanted}, got none; add a [[team.evaders]] table with a position for each, "
            "or [team.random] with a count",
        )
    elif isinstance(evaders, list) and len(evaders) > MOST_EVADERS:
        yield Mistake(("team", "evaders"), wanted_but_got(wanted, len(evaders)))


def _alternatives(document: Document) -> Iterator[Mistake]:
    tables: list[KeyPath] = [("team",)]
    tables += [("team", "evaders", index) for index in range(len(_evaders(document)))]
    for path in tables:
        if all(look(document, *path, key) is not None for key in ("turn_rate", "turn_radius")):
            yield not_both("turn_rate", (*path, "turn_radius"))
    if look(document, "pursuer", "last_seen") is not None:
        given = [key for key in ("center", "radius") if look(document, "pursuer", key) is not None]
        if given:
            yield not_both(" and ".join(given), ("pursuer", "last_seen"))


def _speeds(document: Document) -> Iterator[Mistake]:
    limit = as_positive(look(document, "pursuer", "speed", default=_default(PursuerSection)))
    for path, given in _all_speeds(document):
        speed = as_not_negative(given)
        if limit is not None and speed is not None and not is_slower(speed, limit):
            note = "" if look(document, *path) is not None else ", the default"
            yield too_fast(path, speed, limit, note)


def _all_speeds(document: Document) -> Iterator[tuple[KeyPath, object]]:
    """Return every speed that an evader has from the file, and its path."""
    own = dict(
        enumerate(
            look(document, "team", "evaders", index, "speed")
            for index in range(len(_evaders(document)))
        )
    )
    if not own or None in own.values():
        shared = look(document, "team", "speed", default=_default(TeamSection))
        yield ("team", "speed"), shared
    for index, speed in own.items():
        yield ("team", "evaders", index, "speed"), speed


def _headings(document: Document) -> Iterator[Mistake]:
    seen = look(document, "pursuer", "last_seen", "position", default=[0.0, 0.0])
    center = as_point(look(document, "pursuer", "center", default=seen))
    plural = look(document, "team", "headings", default=AWAY)
    shared = look(document, "team", "heading", default=plural)
    for index in range(len(_evaders(document))):
        path = ("team", "evaders", index)
        heading = look(document, *path, "heading", default=shared)
        position = as_point(look(document, *path, "position"))
        if heading == AWAY and position is not None and position == center:
            yield Mistake(
                (*path, "heading"),
                f'expected a heading in radians, got "{AWAY}" for an evader at the centre of the '
                "pursuer's disk, from where every heading leads away; write heading = 0.0, for "
                "example",
            )


def _sequences(document: Document, path: KeyPath) -> Iterator[Mistake]:
    count = len(_evaders(document)) or as_whole(look(document, "team", "random", "count"))
    several = _list(look(document, *path, "sequences"))
    given: dict[KeyPath, Any] = {(*path, "sequence"): look(document, *path, "sequence")}
    given |= {(*path, "sequences", k): each for k, each in enumerate(several)}
    for where, value in given.items():
        sequence = as_sequence(value)
        if count and sequence is not None and sorted(sequence) != list(range(count)):
            yield Mistake(where, wanted_but_got(f"each evader 0..{count - 1} once", sequence))


def _evaders(document: Document) -> list[Any]:
    return _list(look(document, "team", "evaders"))


def _list(value: Any) -> list[Any]:
    return value if isinstance(value, list) else []


def _default(section: type[PursuerSection] | type[TeamSection]) -> Any:
    return section.model_fields["speed"].default
