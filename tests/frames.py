"""One game, written down in other frames of the plane and in other units."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

import covey


class Frame(NamedTuple):
    """Turned by an angle, then moved, then counted in smaller units of length and time."""

    angle: float = 0.0
    offset: tuple[float, float] = (0.0, 0.0)
    length: float = 1.0
    time: float = 1.0

    def points(self, points):
        """The points (..., 2) as they are written here."""
        cosine, sine = math.cos(self.angle), math.sin(self.angle)
        turned = np.asarray(points) @ np.array([[cosine, sine], [-sine, cosine]])
        return self.length * (turned + np.asarray(self.offset))

    def team(self, team):
        """The team as it is written here."""
        return covey.Team(
            self.points(team.positions),
            team.headings + self.angle,
            team.speeds * (self.length / self.time),
            team.turn_rates / self.time,
        )

    def disk(self, disk):
        """The pursuer as it is written here."""
        return covey.PursuerDisk(
            self.points(disk.center),
            disk.radius * self.length,
            disk.speed * (self.length / self.time),
            disk.capture_radius * self.length,
        )

    def game(self, team, disk):
        """Both."""
        return self.team(team), self.disk(disk)


ELSEWHERE = Frame(1.0, (3.0, 1.0), 100.0, 7.0)
"""Turned, moved and scaled at once."""

FRAMES = {"at home": Frame(), "elsewhere": ELSEWHERE}
"""The frames in which a test with the fixture `frame` runs."""
