"""A heading control and its path (Fig. 1 of the paper)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.model import Team
from covey.model.angles import unit_vectors, wrap_angle
from covey.views.charts.single_turn import SingleTurn, draw_angle, draw_arrow, single_turn
from covey.views.kit import style
from covey.views.kit.layout import camera_around, set_view
from covey.views.kit.markers import DOTS, EVADERS, FLOWN, draw
from covey.views.kit.page import new_page, sheet_of
from covey.views.kit.point_labels import footprint, label
from covey.views.kit.sampling import joined, sampled
from covey.views.kit.style import styled

_PAPER_LIKE = Team([[0.0, 0.0]], [math.pi / 5])
_PAPER_LIKE_TURN = 0.6 * math.pi
_SHOWN = 1.8
"""Length of the time axis, in durations of the turn."""

_THIN: dict[str, Any] = {"color": style.INK, "linewidth": style.THIN_LINE}


@styled
def draw_control(
    team: Team | None = None,
    turn: float | None = None,
    *,
    evader: int = 0,
    ax: Axes | None = None,
    title: str | None = None,
    width: float = style.COLUMN_WIDTH,
) -> Figure:
    """Draw a heading over time, and its path.

    This is eq. 5 and Fig. 1 of the paper.

    Parameters
    ----------
    team, evader
        The evader; by default an example like the paper's.
    turn
        Signed turn δ, radians.
    ax
        Axes in whose place both panels are drawn. Default: a new figure.
    title
        Above both panels. Default: none.
    width
        Of a new figure, inches. Default: one column of a paper.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the evader makes no turn.

    Examples
    --------
    >>> from covey import views
    >>> figure = views.draw_control()
    """
    motion = single_turn(
        _PAPER_LIKE if team is None else team, _PAPER_LIKE_TURN if turn is None else turn, evader
    )
    sheet = sheet_of(ax, title, width)
    side = 0.5 * (sheet.width - 0.58)
    page = new_page(sheet, side + 0.56)
    _draw_heading(page.panel(0.30, 0.34, side, side), motion)
    _draw_path(page.panel(sheet.width - side - 0.06, 0.34, side, side), motion)
    return page.figure


def _draw_heading(axes: Axes, motion: SingleTurn) -> None:
    start, goal, end = motion.heading, motion.goal_heading, motion.turn_end
    axes.plot([0.0, end, _SHOWN * end], [start, goal, goal], gid="heading", **FLOWN.properties)
    axes.plot([0.0, end, end], [goal, goal, start - motion.turn], gid="guides", **style.GUIDE)
    # The slope triangle.
    a, b = 0.42, 0.68
    corner = start + a * motion.turn
    axes.plot([a * end, b * end, b * end], [corner, corner, start + b * motion.turn], **_THIN)
    slope = r"$\omega$" if motion.turn > 0 else r"$-\omega$"
    axes.text((b + 0.06) * end, start + 0.5 * (a + b) * motion.turn, slope, va="center")
    axes.annotate(
        "1",
        (0.5 * (a + b) * end, corner),
        xytext=(0.0, math.copysign(7.0, -motion.turn)),
        textcoords="offset points",
        ha="center",
        va="center",
    )
    axes.set_xlim(0.0, _SHOWN * end)
    axes.set_ylim(*sorted((start - 0.2 * motion.turn, goal + 0.2 * motion.turn)))
    axes.set_xticks([0.0, end], ["0", "$t_c$"])
    axes.set_yticks([start, goal], [r"$\theta^0$", r"$\phi$"])
    axes.set_xlabel("$t$", labelpad=0)
    axes.set_title(r"(a)  heading $\theta(t)$", loc="left", pad=4)


def _draw_path(axes: Axes, motion: SingleTurn) -> None:
    line = motion.path(_SHOWN * motion.turn_end)
    start, bend = motion.at(0.0), motion.at(motion.turn_end)
    arrow = 0.4 * float(np.ptp(line, axis=0).max())
    tips = [start + arrow * unit_vectors(angle) for angle in (motion.heading, 0.0)]
    camera = camera_around(joined([line, *tips, bend + arrow * unit_vectors(0.0)]), 0.1)
    set_view(axes, camera, ticks=False)
    center = motion.center
    axes.plot(*np.array([start, center, bend]).T, gid="guides", **style.GUIDE)
    draw(axes, FLOWN, line)
    draw(axes, EVADERS, start)
    draw(axes, DOTS, bend)
    edges = [line, sampled(np.array([start, center, bend])), sampled(np.array([start, tips[0]]))]
    for corner, angle, name in (
        (start, motion.heading, r"$\theta^0$"),
        (bend, motion.goal_heading, r"$\phi$"),
    ):
        draw_arrow(axes, corner, angle, arrow)
        text = draw_angle(axes, corner, float(wrap_angle(angle)), 0.4 * arrow, name)
        edges.append(footprint(axes, text))
    label(axes, 0.5 * (start + center)[None], [r"$v / \omega$"], joined(edges), style.TEXT_SIZE)
    axes.set_xlabel("$x$", labelpad=2)
    axes.set_ylabel("$y$", labelpad=2)
    axes.set_title("(b)  path", loc="left", pad=4)
