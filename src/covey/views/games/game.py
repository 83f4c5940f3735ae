"""A whole game in one picture."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.simulation import Game
from covey.views.games.capture_labels import Captures, label_captures
from covey.views.games.snapshot import (
    Trajectories,
    capture_points,
    end_of,
    snapshot_at,
    trajectories,
)
from covey.views.kit.close_up import close_up, fitting_scale
from covey.views.kit.layout import camera_around, single_map
from covey.views.kit.markers import (
    CAPTURED,
    DOTS,
    EVADERS,
    FLOWN,
    PURSUER_FLOWN,
    draw,
    draw_disk,
    pursuer_flying,
)
from covey.views.kit.page import sheet_of
from covey.views.kit.sampling import joined, marked, rim
from covey.views.kit.style import COLUMN_WIDTH, styled
from covey.views.kit.time_format import time_format


@styled
def draw_game(
    game: Game, *, ax: Axes | None = None, title: str | None = None, width: float = COLUMN_WIDTH
) -> Figure:
    """Draw all trajectories of a game, and its captures: who was captured, and when.

    Dots are the evaders at the start, with their numbers; the triangle is the pursuer at the start.
    Full circles are evaders alive at the end. The disk is the pursuer's at the start. Where the
    start is small beside the game, a close-up shows it.

    Parameters
    ----------
    game
        The record of a game.
    ax
        Axes to draw on. Default: a new figure.
    title
        Default: how long the team survived, and what was guaranteed.
    width
        Of a new figure, inches. Default: one column of a paper, 3.5.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> from covey import views
    >>> figure = views.draw_game(covey.simulate(team, disk, update_time=0.1))
    """
    flown, points, unit = trajectories(game), capture_points(game), game.team.unit
    tracks = [*np.swapaxes(flown.evaders, 0, 1), flown.pursuer]
    write = time_format(end_of(game), game.team.units.time)
    sheet = sheet_of(ax, _outcome(game, write) if title is None else title, width)
    figure, axes = single_map(camera_around(joined(tracks)), sheet, unit)
    disk = rim(game.disk.center, game.disk.radius)
    close = joined([game.team.positions, disk])
    inset = close_up(axes, close, joined(tracks))
    for each in (axes, inset) if inset else (axes,):
        _draw_course(each, game, flown)
    captures = Captures(points, game.capture_sequence, game.capture_times)
    drawn = joined([*tracks, disk, marked(flown.pursuer[0])])
    label_captures(axes, inset, game.team, captures, write, drawn)
    return figure


def _draw_course(axes: Axes, game: Game, flown: Trajectories) -> None:
    """Draw everything but labels."""
    start, end = snapshot_at(game, 0.0), snapshot_at(game, end_of(game))
    scale = fitting_scale(axes, game.team.positions)
    draw_disk(axes, game.disk.center, game.disk.radius)
    draw(axes, PURSUER_FLOWN, flown.pursuer)
    draw(axes, FLOWN, *np.swapaxes(flown.evaders, 0, 1))
    draw(axes, DOTS, game.team.positions, scale=scale)
    draw(axes, CAPTURED, capture_points(game))
    draw(axes, EVADERS, end.team.positions[end.alive])
    draw(axes, pursuer_flying(start.pursuer_heading), start.pursuer, scale=0.8 * scale)


def _outcome(game: Game, write: Callable[[float], str]) -> str:
    end, n = end_of(game), len(game.team)
    captured = len(game.capture_sequence)
    what = "survived" if captured == n else f"stopped with {n - captured} of {n} alive at"
    if game.objective["name"] != "last-capture":
        return f"{what} {write(end)}"  # the plan guaranteed another objective, not this time
    return f"{what} {write(end)} (guaranteed {write(game.guarantee)})"
