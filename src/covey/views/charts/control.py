"""A heading control and the path that it makes (Fig. 1 of the paper)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.model import Team
from covey.model.angles import unit_vectors, wrap_angle
from covey.views.charts.single_turn import Turning, one_turning, put_angle, put_arrow
from covey.views.kit import style
from covey.views.kit.layout import add_axes, aim, camera_around, new_figure
from covey.views.kit.markers import DOTS, EVADERS, FLOWN, put
from covey.views.kit.point_labels import footprint, label
from covey.views.kit.sampling import dense, joined
from covey.views.kit.style import styled

_PAPER_LIKE = Team([[0.0, 0.0]], [math.pi / 5])
_PAPER_LIKE_TURN = 0.6 * math.pi
_SHOWN = 1.8
"""Time that is shown, in durations of the turn."""

_THIN: dict[str, Any] = {"color": style.INK, "linewidth": style.THIN_LINE}
_GUIDE: dict[str, Any] = {
    "color": style.FAINT,
    "linewidth": style.THIN_LINE,
    "linestyle": style.PURSUER_DOTS,
}


@styled
def draw_control(team: Team | None = None, turn: float | None = None, *, evader: int = 0) -> Figure:
    """Draw a heading over time, and the path that it makes (eq. 5; Fig. 1 of the paper).

    Parameters
    ----------
    team, evader
        The evader; by default one like the paper's.
    turn
        Signed turn δ, radians.

    Returns
    -------
    matplotlib.figure.Figure
        One column of a paper wide.

    Raises
    ------
    InputError
        If the evader makes no turn.
    """
    turning = one_turning(
        _PAPER_LIKE if team is None else team, _PAPER_LIKE_TURN if turn is None else turn, evader
    )
    side = 1.46
    figure = new_figure(style.COLUMN_WIDTH, side + 0.56)
    _draw_heading(add_axes(figure, 0.30, 0.34, side, side), turning)
    _draw_path(add_axes(figure, style.COLUMN_WIDTH - side - 0.06, 0.34, side, side), turning)
    return figure


def _draw_heading(axes: Axes, turning: Turning) -> None:
    start, goal, end = turning.heading, turning.goal_heading, turning.turn_end
    axes.plot([0.0, end, _SHOWN * end], [start, goal, goal], gid="heading", **FLOWN.look)
    axes.plot([0.0, end, end], [goal, goal, start - turning.turn], gid="guides", **_GUIDE)
    # A small triangle under the slope, as one draws it on a blackboard.
    a, b = 0.42, 0.68
    corner = start + a * turning.turn
    axes.plot([a * end, b * end, b * end], [corner, corner, start + b * turning.turn], **_THIN)
    slope = r"$\omega$" if turning.turn > 0 else r"$-\omega$"
    axes.text((b + 0.06) * end, start + 0.5 * (a + b) * turning.turn, slope, va="center")
    axes.annotate(
        "1",
        (0.5 * (a + b) * end, corner),
        xytext=(0.0, math.copysign(7.0, -turning.turn)),
        textcoords="offset points",
        ha="center",
        va="center",
    )
    axes.set_xlim(0.0, _SHOWN * end)
    axes.set_ylim(*sorted((start - 0.2 * turning.turn, goal + 0.2 * turning.turn)))
    axes.set_xticks([0.0, end], ["0", "$t_c$"])
    axes.set_yticks([start, goal], [r"$\theta^0$", r"$\phi$"])
    axes.set_xlabel("$t$", labelpad=0)
    axes.set_title(r"(a)  heading $\theta(t)$", loc="left", pad=4)


def _draw_path(axes: Axes, turning: Turning) -> None:
    line = turning.path(_SHOWN * turning.turn_end)
    start, bend = turning.at(0.0), turning.at(turning.turn_end)
    arrow = 0.4 * float(np.ptp(line, axis=0).max())
    tips = [start + arrow * unit_vectors(angle) for angle in (turning.heading, 0.0)]
    aim(
        axes,
        camera_around(joined([line, *tips, bend + arrow * unit_vectors(0.0)]), 0.1),
        ticks=False,
    )
    center = turning.center
    axes.plot(*np.array([start, center, bend]).T, gid="guides", **_GUIDE)
    put(axes, FLOWN, line)
    put(axes, EVADERS, start)
    put(axes, DOTS, bend)
    edges = [line, dense(np.array([start, center, bend])), dense(np.array([start, tips[0]]))]
    for place, angle, name in (
        (start, turning.heading, r"$\theta^0$"),
        (bend, turning.goal_heading, r"$\phi$"),
    ):
        put_arrow(axes, place, angle, arrow)
        text = put_angle(axes, place, float(wrap_angle(angle)), 0.4 * arrow, name)
        edges.append(footprint(axes, text))
    label(axes, 0.5 * (start + center)[None], [r"$v / \omega$"], joined(edges), style.TEXT_SIZE)
    axes.set_xlabel("$x$", labelpad=2)
    axes.set_ylabel("$y$", labelpad=2)
    axes.set_title("(b)  path", loc="left", pad=4)
