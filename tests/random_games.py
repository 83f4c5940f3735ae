"""Games to test with, and what rounding may do to their times."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import strategies as st

import covey

EPSILON = float(np.finfo(np.float64).eps)

PLACE = np.array([3.0, 1.0])
"""Of the pursuer in random games."""


def random_game(generator, count, *, radius=0.0, capture_radius=0.0, mixed=False):
    """A team spread over a unit square around the pursuer, as in section V of the paper.

    The pursuer isn't at the origin: whatever takes the origin for the centre is wrong here.

    Where it is `mixed`, speeds and turn rates differ: some stand, can't turn, or turn at once.
    """
    speeds, turn_rates = 0.25, math.pi / 2
    if mixed:
        speeds = generator.choice([0.0, 0.1, 0.25, 0.5, 0.8], count)
        turn_rates = generator.choice([0.0, 0.5, math.pi / 2, 6.0, math.inf], count)
    team = covey.Team(
        PLACE + generator.uniform(-0.5, 0.5, (count, 2)),
        generator.uniform(-math.pi, math.pi, count),
        speeds,
        turn_rates,
    )
    return team, covey.PursuerDisk(PLACE, radius, 1.0, capture_radius)


def random_turns(generator, count):
    """Turns to either side, up to a half turn."""
    return generator.uniform(-math.pi, math.pi, count)


def fleeing(distance, *, speed=0.25, bearing=0.7, center=(0.0, 0.0)):
    """One evader at a distance from a point, that flies straight away from it and can't turn."""
    away = np.array([math.cos(bearing), math.sin(bearing)])
    return covey.Team([np.add(center, distance * away)], [bearing], speed, 0.0)


# Multiples of a millionth: products of tiny numbers would vanish below the least double.
_shares = st.integers(-(10**6), 10**6).map(lambda k: k * 1e-6)
_positive_shares = st.integers(0, 10**6).map(lambda k: k * 1e-6)
_angles = _shares.map(lambda share: share * math.pi)


@st.composite
def games(draw, most=4, fastest=0.9, disks=True):
    """A team of up to `most`, a disk and turns, in any unit of length and time.

    Speeds go up to `fastest` times the pursuer's; evaders may stand, share a place, start inside
    the disk, be unable to turn, turn at once, or fly circles much larger than the game.
    """
    count = draw(st.integers(1, most))
    length, speed = 10.0 ** draw(st.integers(-6, 6)), 10.0 ** draw(st.integers(-3, 3))
    rates = st.sampled_from([0.0, 1e-12, 1e-6, 1.0, 1e6, math.inf]) | _positive_shares.map(
        lambda share: 10.0 * share
    )

    def some(shares):
        return np.array(draw(st.lists(shares, min_size=count, max_size=count)))

    team = covey.Team(
        length * np.column_stack([some(_shares), some(_shares)]),
        some(_angles),
        speed * fastest * some(_positive_shares),
        speed / length * some(rates),
    )
    radii = _positive_shares.map(lambda share: 0.3 * length * share) if disks else st.just(0.0)
    center = length * draw(_shares), length * draw(_shares)
    return team, covey.PursuerDisk(center, draw(radii), speed, draw(radii)), some(_angles)


def extent(team, disk):
    """The largest coordinate or radius that goes into the arithmetic."""
    places = np.vstack([team.positions, disk.center])
    return float(np.abs(places).max()) + disk.radius + 2.0 * disk.capture_radius


def time_rounding(team, disk, time):
    """How far rounding may move a capture time of this size.

    A place is known to a few units in the last digit. An error of it delays a capture by as much
    over the difference of the speeds, and every further capture amplifies the delay.
    """
    fastest = float(team.speeds.max())
    slower = disk.speed - fastest
    place = 32.0 * EPSILON * (extent(team, disk) + disk.speed * time)
    return place / slower * ((disk.speed + fastest) / slower) ** (len(team) - 1)
