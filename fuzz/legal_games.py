"""Nasty but legal arguments: huge, tiny and equal lengths, speeds near 0 and the pursuer's."""

from __future__ import annotations

import math
from typing import NamedTuple

from hypothesis import strategies as st

LENGTHS = (1.0, 1e-9, 1e9, 1e-40, 1e40)
TIMES = (1.0, 1e-9, 1e-3, 1e3, 1e9)
OFFSETS = (0.0, 1.0, 1e5)
"""Of all coordinates, in units of length."""
SHARES = (0.0, 1.0, -1.0, 0.5, 1e-9, -1e-16)
SPEEDS = (0.25, 0.0, 1e-12, 0.5, 0.9, 0.999, 0.999999, 1.0 - 2e-12, math.nextafter(1.0, 0.0))
"""Of the pursuer's."""
TURN_RATES = (1.0, 0.0, 1e-9, 1e-3, 1e3, 1e9, math.inf)
HEADINGS = (0.0, math.pi, -math.pi, 1.5, 1e9, -1e9)
RADII = (0.0, 1e-12, 0.1, 1.0, 1e6)
UPDATES = (0.1, 1e-12, 1e-3, 1.0, 1e6)


class Size(NamedTuple):
    """Of a game."""

    count: int  # evaders
    length: float
    time: float


def sizes(most):
    """Draw the size of a game of up to `most` evaders."""
    lengths, times = st.sampled_from(LENGTHS), st.sampled_from(TIMES)
    return st.builds(Size, st.integers(1, most), lengths, times)


@st.composite
def states(draw, size):
    """Draw the arguments of a team and those of a disk."""
    count, length, speed = size.count, size.length, size.length / size.time
    offset = draw(st.sampled_from(OFFSETS))
    shares = st.sampled_from(SHARES) | st.floats(-1.0, 1.0)
    point = st.lists(shares.map(lambda x: length * (x + offset)), min_size=2, max_size=2)
    team = {
        "positions": draw(st.lists(point, min_size=count, max_size=count)),
        "headings": draw(each(HEADINGS, count)),
        "speeds": [speed * share for share in draw(each(SPEEDS, count))],
        "turn_rates": [rate / size.time for rate in draw(each(TURN_RATES, count))],
    }
    disk = {
        "center": draw(point),
        "radius": length * draw(st.sampled_from(RADII)),
        "speed": speed,
        "capture_radius": length * draw(st.sampled_from(RADII)),
    }
    return team, disk


def each(values, count):
    """Draw one of the values for each evader."""
    return st.lists(st.sampled_from(values), min_size=count, max_size=count)


def turns(count):
    """Draw turns."""
    return each((0.0, math.pi, -math.pi, 1e-9, 0.5, -3.0), count)


def sequences(count):
    """Draw a capture sequence."""
    return st.permutations(range(count)).map(list)


def objectives(count):
    """Draw an objective, as a scenario file gives it."""
    draws = st.lists(sequences(count), min_size=1, max_size=3, unique_by=tuple)
    measures = st.sampled_from(("last", "total"))
    return st.one_of(
        _named("last-capture"),
        _named("total-survival"),
        _named("expected-survival", sequences=draws, measure=measures),
    )


def evaders(count):
    """Draw a team's strategy, as a scenario file gives it, with short searches."""
    searches = {"starts": st.integers(1, 2), "restarts": st.integers(0, 1)}
    return st.one_of(
        _named("iterative-open-loop", **searches),
        _named("open-loop", starts=st.just(2)),
        _named("constant-heading", **searches),
        _named("known-sequence", sequence=sequences(count)),
        *map(_named, ("largest-distance", "smallest-danger", "straight-away", "hold-course")),
    )


def pursuers(count):
    """Draw a pursuer's strategy, as a scenario file gives it."""
    return st.one_of(
        _named("committed", margin=st.sampled_from((0.0, 0.01, 1e50))),
        _named("flying", offset=st.just([0.6, 0.8])),
        _named("fixed-sequence", sequence=sequences(count)),
        *map(_named, ("patient", "best-sequence", "random-sequence", "nearest-first")),
    )


def timing(unit):
    """Draw the update time of a game, and a limit of a few updates."""
    updates = st.sampled_from(UPDATES).map(lambda share: share * unit)
    limits = st.sampled_from((1.0, 2.5, 10.0))
    return st.builds(lambda dt, most: {"update_time": dt, "time_limit": most * dt}, updates, limits)


def _named(name, **parameters):
    return st.fixed_dictionaries({"name": st.just(name), **parameters})
