"""A game in four snapshots (Fig. 3 of the paper)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.model import InputError
from covey.model.validation import Floats, frozen_array
from covey.simulation import Game
from covey.views.games.scene import draw_legend, draw_scene, extent, obstacles
from covey.views.games.snapshot import end_of, snapshot_at, trajectories
from covey.views.kit.close_up import fitting_scale
from covey.views.kit.layout import camera_around, lettered, maps_in_rows
from covey.views.kit.page import sheet_of
from covey.views.kit.point_labels import number_evaders
from covey.views.kit.style import COLUMN_WIDTH, styled
from covey.views.kit.time_format import time_format

_FOOT = 0.86
"""For the names of the axes and the legend, inches."""
_SCALE = 0.75
"""Scale of the markers: these maps are half as wide as others."""


@styled
def draw_snapshots(
    game: Game,
    times: Sequence[float] | Floats | None = None,
    *,
    ax: Axes | None = None,
    title: str | None = None,
    width: float = COLUMN_WIDTH,
) -> Figure:
    """Draw snapshots of a game, all through the same camera, two in a row.

    The paper's Fig. 3 is such a picture.

    Parameters
    ----------
    game
        The record of a game.
    times
        From 0 to the end of the game. By default four: the start, a fifth and a half of the game,
        and its end.
    ax
        Axes in whose place the maps are drawn. Default: a new figure.
    title
        Above all maps. Default: none.
    width
        Of a new figure, inches. Default: one column of a paper, 3.5.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If there are no times, or a time is outside of the game.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> from covey import views
    >>> figure = views.draw_snapshots(covey.simulate(team, disk, update_time=0.1))
    """
    snapshots = [snapshot_at(game, time) for time in _checked(game, times)]
    flown = trajectories(game)
    camera = camera_around(extent(snapshots, flown))
    write = time_format(end_of(game), game.team.units.time)
    names = lettered([f"$t$ = {write(snapshot.time)}" for snapshot in snapshots])
    sheet = sheet_of(ax, title, width)
    page, maps = maps_in_rows(names, 2, camera, game.team.unit, _FOOT, sheet)
    for axes, snapshot in zip(maps, snapshots, strict=True):
        positions = snapshot.team.positions
        scale = _SCALE * fitting_scale(axes, positions[snapshot.alive])
        draw_scene(axes, snapshot, flown, scale)
        number_evaders(axes, positions, range(len(positions)), obstacles(snapshot, flown))
    draw_legend(page)
    return page.figure


def default_times(game: Game) -> Floats:
    """Four times, all over a game."""
    return np.array([0.0, 0.2, 0.5, 1.0]) * end_of(game)


def times_around_first_capture(game: Game) -> Floats:
    """Four times between which a hidden pursuer's disk grows and collapses (Fig. 3)."""
    captures = game.capture_times
    if len(captures) < 2 or captures[0] == 0.0:
        return np.linspace(0.0, end_of(game), 4)
    first, second = captures[:2].tolist()
    later = first + 0.25 * max(first, second - first)
    return np.array([0.0, 0.75 * first, first, min(later, end_of(game))])


def _checked(game: Game, times: Sequence[float] | Floats | None) -> list[float]:
    wanted = default_times(game) if times is None else frozen_array("times", times, (None,))
    outside = wanted[(wanted < 0.0) | (wanted > end_of(game))]
    if len(wanted) == 0 or len(outside):
        came = f"{outside[0]:g}" if len(outside) else "none"
        raise InputError(f"times: expected times from 0 to {end_of(game):g}, got {came}")
    return [float(time) for time in wanted]
