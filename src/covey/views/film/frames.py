"""The frames of a film of a game."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
import numpy.typing as npt
from matplotlib.backends.backend_agg import FigureCanvasAgg

from covey.simulation import Game
from covey.views.games.scene import draw_moment, extent, put_legend
from covey.views.games.snapshot import Moment, end_of, moment_at, trajectories
from covey.views.kit.layout import add_axes, aim, camera_around, margins, new_figure
from covey.views.kit.style import COLUMN_WIDTH, styled
from covey.views.kit.time_format import clock

Frame = npt.NDArray[np.uint8]

_DOTS_PER_INCH = 180
_FORESEEN = 40
"""Plans that the camera takes into view, evenly spaced in time."""


class Film:
    """A game through a fixed camera; what doesn't move is drawn once.

    Parameters
    ----------
    game
        The record of a game.
    """

    @styled
    def __init__(self, game: Game) -> None:
        self._game = game
        self._flown = trajectories(game)
        self._clock = clock(end_of(game))
        plans = [moment_at(game, time) for time in np.linspace(0.0, end_of(game), _FORESEEN)]
        camera = camera_around(extent(plans, self._flown))
        bottom, title = 0.72, 0.24
        left, right = margins(camera)
        side = COLUMN_WIDTH - left - right
        figure = new_figure(COLUMN_WIDTH, bottom + side + title)
        figure.set_dpi(_DOTS_PER_INCH)
        self.axes = add_axes(figure, left, bottom, side, side)
        aim(self.axes, camera)
        put_legend(figure)
        self._title = self.axes.set_title("", loc="left", pad=4)
        self._canvas = cast(Any, FigureCanvasAgg(figure))  # its methods have no types
        self._canvas.draw()
        self._background = self._canvas.copy_from_bbox(figure.bbox)

    @styled
    def frame(self, time: float) -> Frame:
        """The picture at a time of the game, (height, width, 3); both are even, as films want."""
        self._canvas.restore_region(self._background)
        moment = moment_at(self._game, time)
        moving = draw_moment(self.axes, moment, self._flown)
        self._title.set_text(self._caption(moment))
        for artist in sorted(moving, key=lambda artist: artist.get_zorder()):
            self.axes.draw_artist(artist)
        for still in (*self.axes.spines.values(), self._title):
            self.axes.draw_artist(still)
        for artist in moving:
            artist.remove()
        picture = np.asarray(self._canvas.buffer_rgba())
        height, width = (size - size % 2 for size in picture.shape[:2])
        return picture[:height, :width, :3].copy()

    def _caption(self, moment: Moment) -> str:
        captured = int(np.sum(~moment.alive))
        time, guaranteed = self._clock(moment.time), self._clock(moment.guaranteed)
        return (
            f"t = {time}     guaranteed until {guaranteed}"
            f"     captured {captured} of {len(moment.alive)}"
        )
