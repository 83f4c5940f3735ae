"""A game as a film."""

from __future__ import annotations

import base64
import os
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from covey.model.validation import Floats, number
from covey.simulation import Game
from covey.simulation.files import check_writable
from covey.views.film.frames import Frame, FrameRenderer
from covey.views.film.gif import save_gif
from covey.views.film.mp4 import has_video, require_video, save_mp4
from covey.views.games.snapshot import end_of
from covey.views.kit.saving import FILMS, checked_suffix
from covey.views.kit.style import COLUMN_WIDTH

Progress = Callable[[int, int], None]

_HOLD = 1.0
"""Seconds for which the last frame stays."""


class Film:
    """A film of a game, which plays in a notebook, or is saved as a file.

    Attributes
    ----------
    game : Game
        The record that the film shows.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> film = covey.animate(covey.simulate(team, disk, update_time=0.1), seconds=2.0)
    """

    def __init__(
        self, game: Game, seconds: float, fps: float, title: str | None, width: float
    ) -> None:
        self.game = game
        self._rate = number("fps", fps, low=0.0, strictly=True, high=50.0)
        self._length = number("seconds", seconds, low=0.0, strictly=True)
        self._title, self._width = title, number("width", width, low=1.0, high=100.0)

    def __repr__(self) -> str:
        """Return what is shown, and for how long, in one line."""
        return f"Film({self.game!r}, {self._length:g} s)"

    def _repr_html_(self) -> str:
        """Return a page's part that plays the film and holds it whole."""
        suffix = ".mp4" if has_video() else ".gif"
        with tempfile.TemporaryDirectory() as folder:
            content = self.save(Path(folder) / f"film{suffix}").read_bytes()
        data = base64.b64encode(content).decode()
        if suffix == ".gif":
            return f'<img src="data:image/gif;base64,{data}">'
        return f'<video controls autoplay muted loop src="data:video/mp4;base64,{data}"></video>'

    def save(self, path: str | os.PathLike[str], *, progress: Progress | None = None) -> Path:
        """Save the film.

        Parameters
        ----------
        path
            Ends in .gif, or in .mp4 where the extra `video` is installed. The folder must be there;
            an existing file is replaced.
        progress
            Called after each frame, with the numbers of frames drawn and of all frames.

        Returns
        -------
        pathlib.Path
            The file that was written.

        Raises
        ------
        InputError
            If the ending is another one, or `video` isn't installed.
        OSError
            If the file can't be written; its `strerror` says why.
        """
        path = Path(path)
        suffix = checked_suffix(path, FILMS, "a film")
        if suffix == ".mp4":
            require_video()
        check_writable(path)  # before all frames are drawn
        renderer = FrameRenderer(self.game, self._title, self._width)
        times = frame_times(self.game, self._length, self._rate)
        frames = _reported(renderer, times, progress)
        if suffix == ".gif":
            samples = [renderer.frame(time) for time in times[:: max(1, len(times) // 8)].tolist()]
            save_gif(path, frames, samples, len(times), self._rate, _HOLD)
        else:
            save_mp4(path, frames, self._rate, _HOLD)
        return path


def animate(
    game: Game,
    *,
    seconds: float = 7.0,
    fps: float = 20.0,
    title: str | None = None,
    width: float = COLUMN_WIDTH,
) -> Film:
    """Make a film of a game, with a fixed camera and a constant rate; the end stays for 1 s.

    The last line of a notebook's cell plays there; `save` writes a file.

    Parameters
    ----------
    game
        The record of a game.
    seconds
        Length of the game on the screen.
    fps
        Frames a second, at most 50.
    title
        Above the frames. Default: none.
    width
        Inches, of 180 dots each. Default: one column of a paper, 3.5.

    Returns
    -------
    Film

    Raises
    ------
    InputError
        If a number is out of its range.

    Examples
    --------
    >>> import covey
    >>> game = covey.load_scenario("visible").simulate()
    >>> film = covey.animate(game, seconds=3.0)
    """
    return Film(game, seconds, fps, title, width)


def frame_times(game: Game, seconds: float, fps: float) -> Floats:
    """Times of the frames in the game: evenly spaced, its start and its end included."""
    return np.linspace(0.0, end_of(game), max(2, round(seconds * fps)))


def _reported(renderer: FrameRenderer, times: Floats, progress: Progress | None) -> Iterator[Frame]:
    for done, time in enumerate(times.tolist(), start=1):
        yield renderer.frame(time)
        if progress is not None:
            progress(done, len(times))
