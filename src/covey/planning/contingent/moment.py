"""A game at a moment, in the kernels' form, and as the next capture leaves it."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from covey.kernels.capture.interception import earliest_captures
from covey.kernels.capture.path import (
    HEADING,
    PATH,
    TURN_RATE,
    X,
    Y,
    sample,
    set_paths,
)
from covey.kernels.capture.pursuit import GrowingDisk, Pursuit
from covey.model.validation import Floats


class Moment(NamedTuple):
    """The evaders that are left, and the pursuer."""

    evaders: Floats  # (n, EVADER)
    pursuit: Pursuit

    def paths(self, turns: Floats) -> Floats:
        """Return the paths (n, PATH) of turns (n,)."""
        paths = np.empty((len(turns), PATH))
        set_paths(self.evaders, turns, self.pursuit.speed, paths)
        return paths

    def earliest(self, turns: Floats) -> Floats:
        """Return when each evader is captured at the earliest, if it is the first, (n,)."""
        times = np.empty(len(turns))
        x, y, radius, _, speed = self.pursuit
        earliest_captures(self.paths(turns), GrowingDisk(x, y, radius, 0.0, speed), times)
        return times


def fly_on(moment: Moment, turns: Floats, time: float) -> tuple[Moment, Floats]:
    """Return the moment when all have flown on for a time, and what is left of their turns (n,)."""
    positions = np.empty((1, len(turns), 2))
    sample(moment.paths(turns), np.array([time]), positions)
    rates = moment.evaders[:, TURN_RATE]
    if time > 0.0:
        most = np.minimum(rates * time, math.pi)
    else:
        most = np.where(np.isinf(rates), math.pi, 0.0)
    turned = np.maximum(np.minimum(turns, most), -most)
    evaders = moment.evaders.copy()
    evaders[:, [X, Y]] = positions[0]
    evaders[:, HEADING] += turned
    return Moment(evaders, moment.pursuit), turns - turned


def after_capture(moment: Moment, turns: Floats, rank: int, time: float) -> tuple[Moment, Floats]:
    """Return the moment when an evader is captured, and what is left of the others' turns (n - 1,).

    Parameters
    ----------
    moment
        Of n evaders.
    turns
        (n,) that all make.
    rank
        Row of the evader that is captured.
    time
        Since `moment`.
    """
    then, left = fly_on(moment, turns, time)
    x, y = then.evaders[rank, [X, Y]].tolist()
    radius = moment.pursuit.later_radius
    pursuit = moment.pursuit._replace(center_x=x, center_y=y, first_radius=radius)
    others = np.arange(len(turns)) != rank
    return Moment(then.evaders[others], pursuit), left[others]


def last_turn(moment: Moment) -> Floats:
    """Return the turn (1,) with which a single evader survives longest.

    It flies straight away from where the pursuer can be, on a tangent of its turning circle. From
    inside the circle there is no tangent; then the turn is the one of a few that is best.
    """
    x, y, heading, speed, rate = moment.evaders[0].tolist()
    if rate == 0.0:
        return np.zeros(1)
    off_x, off_y = x - moment.pursuit.center_x, y - moment.pursuit.center_y
    turns = [0.0, math.pi, -math.pi, math.atan2(off_y, off_x) - heading]
    radius = speed / rate
    for side in (1.0, -1.0):
        to_x = off_x - side * radius * math.sin(heading)
        to_y = off_y + side * radius * math.cos(heading)
        distance = math.hypot(to_x, to_y)
        if distance > radius:
            turns.append(math.atan2(to_y, to_x) - side * math.asin(radius / distance) - heading)
    candidates = np.array(turns)
    candidates -= 2.0 * math.pi * np.round(candidates / (2.0 * math.pi))
    copies = Moment(np.tile(moment.evaders, (len(candidates), 1)), moment.pursuit)
    return candidates[[np.argmax(copies.earliest(candidates))]]
