"""The frames of a film of a game."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
import numpy.typing as npt
from matplotlib.backends.backend_agg import FigureCanvasAgg

from covey.simulation import Game
from covey.views.games.scene import draw_legend, draw_scene, extent
from covey.views.games.snapshot import Snapshot, end_of, snapshot_at, trajectories
from covey.views.kit.layout import add_axes, camera_around, margins, new_figure, set_view
from covey.views.kit.style import COLUMN_WIDTH, styled
from covey.views.kit.time_format import time_format

Frame = npt.NDArray[np.uint8]

_DOTS_PER_INCH = 180
_PLANS = 40
"""Number of times, evenly spaced, whose planned paths the camera shows whole."""


class FrameRenderer:
    """Renders a game through a fixed camera. What doesn't move is drawn once.

    Parameters
    ----------
    game
        The record of a game.
    """

    @styled
    def __init__(self, game: Game) -> None:
        self._game = game
        self._flown = trajectories(game)
        self._write = time_format(end_of(game))
        plans = [snapshot_at(game, time) for time in np.linspace(0.0, end_of(game), _PLANS)]
        camera = camera_around(extent(plans, self._flown))
        bottom, title = 0.72, 0.24
        left, right = margins(camera)
        side = COLUMN_WIDTH - left - right
        figure = new_figure(COLUMN_WIDTH, bottom + side + title)
        figure.set_dpi(_DOTS_PER_INCH)
        self.axes = add_axes(figure, left, bottom, side, side)
        set_view(self.axes, camera)
        draw_legend(figure)
        self._title = self.axes.set_title("", loc="left", pad=4)
        self._canvas = cast(Any, FigureCanvasAgg(figure))  # its methods have no types
        self._canvas.draw()
        self._background = self._canvas.copy_from_bbox(figure.bbox)

    @styled
    def frame(self, time: float) -> Frame:
        """Render a time of the game as (height, width, 3); video codecs demand even numbers."""
        self._canvas.restore_region(self._background)
        snapshot = snapshot_at(self._game, time)
        moving = draw_scene(self.axes, snapshot, self._flown)
        self._title.set_text(self._caption(snapshot))
        for artist in sorted(moving, key=lambda artist: artist.get_zorder()):
            self.axes.draw_artist(artist)
        for still in (*self.axes.spines.values(), self._title):
            self.axes.draw_artist(still)
        for artist in moving:
            artist.remove()
        picture = np.asarray(self._canvas.buffer_rgba())
        height, width = (size - size % 2 for size in picture.shape[:2])
        return picture[:height, :width, :3].copy()

    def _caption(self, snapshot: Snapshot) -> str:
        captured = int(np.sum(~snapshot.alive))
        time, guaranteed = self._write(snapshot.time), self._write(snapshot.guaranteed)
        return (
            f"t = {time}     guaranteed until {guaranteed}"
            f"     captured {captured} of {len(snapshot.alive)}"
        )
