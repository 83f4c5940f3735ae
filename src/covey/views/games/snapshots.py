"""A game in four snapshots (Fig. 3 of the paper)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from covey.model import InputError
from covey.model.validation import Floats, frozen_array
from covey.simulation import Game
from covey.views.games.scene import draw_legend, draw_scene, extent
from covey.views.games.snapshot import end_of, snapshot_at, trajectories
from covey.views.kit.layout import add_axes, camera_around, margins, new_figure, set_view
from covey.views.kit.style import COLUMN_WIDTH, styled
from covey.views.kit.time_format import time_format

_BOTTOM, _GAP, _TITLE = 0.66, 0.08, 0.20
_SCALE = 0.75
"""Scale of the markers: these maps are half as wide as others."""


@styled
def draw_snapshots(game: Game, times: Sequence[float] | None = None) -> Figure:
    """Draw snapshots of a game, all through the same camera, two in a row (Fig. 3 of the paper).

    Parameters
    ----------
    game
        The record of a game.
    times
        From 0 to the end of the game. By default four: the start, shortly before the first
        capture, that capture, and a little later.

    Returns
    -------
    matplotlib.figure.Figure
        One column of a paper wide.

    Raises
    ------
    InputError
        If there are no times, or a time is outside of the game.
    """
    snapshots = [snapshot_at(game, time) for time in _checked(game, times)]
    flown = trajectories(game)
    camera = camera_around(extent(snapshots, flown))
    write = time_format(end_of(game))
    rows = -(-len(snapshots) // 2)
    left, right = margins(camera)
    side = (COLUMN_WIDTH - left - _GAP - right) / 2
    figure = new_figure(COLUMN_WIDTH, _BOTTOM + rows * (side + _TITLE))
    for number, snapshot in enumerate(snapshots):
        across, down = number % 2, number // 2
        bottom = _BOTTOM + (rows - 1 - down) * (side + _TITLE)
        axes = add_axes(figure, left + across * (side + _GAP), bottom, side, side)
        set_view(axes, camera)
        axes.tick_params(labelleft=across == 0, labelbottom=number + 2 >= len(snapshots))
        axes.set_title(
            f"({chr(ord('a') + number)})  $t$ = {write(snapshot.time)}", loc="left", pad=3
        )
        draw_scene(axes, snapshot, flown, _SCALE)
    draw_legend(figure)
    return figure


def default_times(game: Game) -> Floats:
    """Four times between which a hidden pursuer's disk grows and collapses."""
    captures = game.capture_times
    if len(captures) < 2 or captures[0] == 0.0:
        return np.linspace(0.0, end_of(game), 4)
    first, second = captures[:2].tolist()
    later = first + 0.25 * max(first, second - first)
    return np.array([0.0, 0.75 * first, first, min(later, end_of(game))])


def _checked(game: Game, times: Sequence[float] | None) -> list[float]:
    wanted = default_times(game) if times is None else frozen_array("times", times, (None,))
    outside = wanted[(wanted < 0.0) | (wanted > end_of(game))]
    if len(wanted) == 0 or len(outside):
        came = f"{outside[0]:g}" if len(outside) else "none"
        raise InputError(f"times: expected times from 0 to {end_of(game):g}, got {came}")
    return [float(time) for time in wanted]
