"""The frames of a film of a game."""

from __future__ import annotations

from typing import Any, cast

import numpy as np
import numpy.typing as npt
from matplotlib.backends.backend_agg import FigureCanvasAgg

from covey.simulation import Game
from covey.views.games.scene import draw_legend, draw_numbers, draw_scene, extent
from covey.views.games.snapshot import Snapshot, end_of, snapshot_at, trajectories
from covey.views.kit.close_up import fitting_scale
from covey.views.kit.layout import camera_around, margins, name_axes, set_view
from covey.views.kit.page import fit, new_page, sheet_of
from covey.views.kit.style import COLUMN_WIDTH, styled
from covey.views.kit.time_format import time_format

Frame = npt.NDArray[np.uint8]

_DOTS_PER_INCH = 180
_EDGE = 0.1
"""Inches from the edge of a frame to its caption."""
_PLANS = 40
"""Number of times, evenly spaced, whose planned paths the camera shows whole."""


class FrameRenderer:
    """Renders a game through a fixed camera. What doesn't move is drawn once.

    Parameters
    ----------
    game
        The record of a game.
    title
        Above the frames. Default: none.
    width
        Inches, of 180 dots each.
    """

    @styled
    def __init__(self, game: Game, title: str | None = None, width: float = COLUMN_WIDTH) -> None:
        self._game = game
        self._flown = trajectories(game)
        self._write = time_format(end_of(game), game.team.units.time)
        plans = [snapshot_at(game, time) for time in np.linspace(0.0, end_of(game), _PLANS)]
        camera = camera_around(extent(plans, self._flown))
        bottom, above, letter = 0.88, 0.24, 0.18
        numbers, right = margins(camera)
        left = letter + numbers
        side = width - left - right
        page = new_page(sheet_of(None, title, width), bottom + side + above)
        figure = page.figure
        figure.set_dpi(_DOTS_PER_INCH)
        self.axes = page.panel(left, bottom, side, side)
        set_view(self.axes, camera)
        name_axes(self.axes, game.team.unit)
        draw_legend(page)
        caption = self._caption(plans[-1])  # of the most digits
        self._title = self.axes.set_title(caption, loc="left", pad=4, x=(_EDGE - left) / side)
        fit(self._title, width - 2.0 * _EDGE)
        self._title.set_text("")  # each frame has its own
        self._canvas = cast(Any, FigureCanvasAgg(figure))  # its methods have no types
        self._canvas.draw()
        self._background = self._canvas.copy_from_bbox(figure.bbox)

    @styled
    def frame(self, time: float) -> Frame:
        """Render a time of the game as (height, width, 3); video codecs demand even numbers."""
        self._canvas.restore_region(self._background)
        snapshot = snapshot_at(self._game, time)
        scale = fitting_scale(self.axes, snapshot.team.positions[snapshot.alive])
        moving = draw_scene(self.axes, snapshot, self._flown, scale)
        moving += draw_numbers(self.axes, snapshot)
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
            f"t = {time}   guaranteed until {guaranteed}"
            f"   captured {captured} of {len(snapshot.alive)}"
        )
