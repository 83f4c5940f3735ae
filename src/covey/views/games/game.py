"""A whole game in one picture."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from matplotlib.figure import Figure

from covey.simulation import Game
from covey.views.games.snapshot import capture_points, end_of, snapshot_at, trajectories
from covey.views.kit.layout import TITLE, camera_around, single_map
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
from covey.views.kit.point_labels import label
from covey.views.kit.sampling import joined
from covey.views.kit.style import styled
from covey.views.kit.time_format import time_format


@styled
def draw_game(game: Game) -> Figure:
    """Draw all trajectories of a game, and its captures, numbered in order, with their times.

    Dots are the evaders at the start, the triangle is the pursuer at the start. Full circles are
    evaders alive at the end. The disk is the pursuer's at the start.

    Parameters
    ----------
    game
        The record of a game.

    Returns
    -------
    matplotlib.figure.Figure
        One column of a paper wide.
    """
    flown, points = trajectories(game), capture_points(game)
    start, end = snapshot_at(game, 0.0), snapshot_at(game, end_of(game))
    tracks = [*np.swapaxes(flown.evaders, 0, 1), flown.pursuer]
    figure, axes = single_map(camera_around(joined(tracks)), headroom=TITLE)
    draw_disk(axes, game.disk.center, game.disk.radius)
    draw(axes, PURSUER_FLOWN, flown.pursuer)
    draw(axes, FLOWN, *tracks[:-1])
    draw(axes, DOTS, game.team.positions)
    draw(axes, CAPTURED, points)
    draw(axes, EVADERS, end.team.positions[end.alive])
    draw(axes, pursuer_flying(start.pursuer_heading), start.pursuer, scale=0.8)
    write = time_format(end_of(game))
    axes.set_title(_outcome(game, write), loc="left", pad=4)
    texts = [f"{k}: {write(time)}" for k, time in enumerate(game.capture_times.tolist(), start=1)]
    label(axes, points, texts, joined(tracks))
    return figure


def _outcome(game: Game, write: Callable[[float], str]) -> str:
    end, n = end_of(game), len(game.team)
    captured = len(game.capture_sequence)
    what = "survived" if captured == n else f"stopped with {n - captured} of {n} alive at"
    if game.objective["name"] != "last-capture":
        return f"{what} {write(end)}"  # the plan guaranteed another objective, not this time
    return f"{what} {write(end)} (guaranteed {write(game.guarantee)})"
