"""What Figs. 1 and 2 share: one evader that makes one turn, arrows and angles."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Arc, FancyArrowPatch
from matplotlib.text import Text

from covey.model import InputError, Team
from covey.model.angles import unit_vectors
from covey.model.validation import Floats, number, whole_number
from covey.views.games.flight import path
from covey.views.kit import style

_WIDE = 0.5
"""Radians: a wider angle has room for its name."""


@dataclass(frozen=True, eq=False)
class SingleTurn:
    """One evader, its signed turn, and the time t_c at which the turn ends."""

    team: Team
    turn: float
    turn_end: float

    @property
    def heading(self) -> float:
        """θ⁰, radians."""
        return float(self.team.headings[0])

    @property
    def goal_heading(self) -> float:
        """φ, radians, not wrapped."""
        return self.heading + self.turn

    @property
    def speed(self) -> float:
        """Lengths per time."""
        return float(self.team.speeds[0])

    @property
    def center(self) -> Floats:
        """Center of the turning circle, (2,)."""
        radius = self.speed / float(self.team.turn_rates[0])
        left = self.heading + math.copysign(0.5 * math.pi, self.turn)
        place: Floats = self.team.positions[0] + radius * unit_vectors(left)
        return place

    def path(self, until: float) -> Floats:
        """Points (K, 2) of the path from time 0 on."""
        return path(self.team, np.array([self.turn]), 0, until)

    def at(self, time: float) -> Floats:
        """Position (2,) at a time."""
        position: Floats = self.path(time)[-1]
        return position


def single_turn(team: Team, turn: float, evader: int) -> SingleTurn:
    """Return the turn of one evader, or raise InputError if the evader doesn't turn."""
    if whole_number("evader", evader, low=0) >= len(team):
        raise InputError(f"evader: expected one of 0..{len(team) - 1}, got {evader}")
    alone = team.take(np.array([evader]))
    delta = number("turn", turn)
    rate, speed = float(alone.turn_rates[0]), float(alone.speeds[0])
    if delta == 0.0 or not 0.0 < rate < math.inf or speed == 0.0:
        raise InputError(
            f"evader {evader}: expected one that turns while it flies, for the figure is about "
            f"that; got speed {speed:g}, turn rate {rate:g}, turn {delta:g}"
        )
    return SingleTurn(alone, delta, abs(delta) / rate)


def draw_arrow(axes: Axes, start: Floats, heading: float, length: float) -> FancyArrowPatch:
    """Draw an arrow on a map."""
    tip = start + length * unit_vectors(heading)
    arrow = FancyArrowPatch(
        tuple(start),
        tuple(tip),
        arrowstyle="-|>",
        mutation_scale=7,
        shrinkA=0,
        shrinkB=0,
        color=style.INK,
        linewidth=0.9,
        zorder=style.PURSUER_LAYER,
    )
    axes.add_patch(arrow)
    return arrow


def draw_angle(axes: Axes, corner: Floats, heading: float, radius: float, text: str) -> Text:
    """Draw the angle from +x to `heading` as an arc with a text beside it; return the text."""
    x, y = corner.tolist()
    low, high = sorted((0.0, math.degrees(heading)))
    axes.plot([x, x + 1.5 * radius], [y, y], color=style.FAINT, linewidth=style.THIN_LINE)
    axes.add_patch(
        Arc(
            (x, y),
            2 * radius,
            2 * radius,
            theta1=low,
            theta2=high,
            lw=style.THIN_LINE,
            color=style.INK,
        )
    )
    # A narrow angle has no room for its text, which goes to the other side of the line.
    wide = abs(heading) > _WIDE
    middle = 0.5 * heading if wide else math.copysign(_WIDE, -heading)
    away = 1.6 * radius
    return axes.text(
        x + away * math.cos(middle), y + away * math.sin(middle), text, ha="center", va="center"
    )
