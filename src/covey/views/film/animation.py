"""Save a game as a film."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from covey.model.validation import Floats, number
from covey.simulation import Game
from covey.simulation.files import check_writable
from covey.views.film.frames import Frame, FrameRenderer
from covey.views.film.gif import save_gif
from covey.views.film.mp4 import require_video, save_mp4
from covey.views.games.snapshot import end_of
from covey.views.kit.saving import FILMS, checked_suffix

Progress = Callable[[int, int], None]

_HOLD = 1.0
"""Seconds for which the last frame stays."""


def animate(
    game: Game,
    path: str | os.PathLike[str],
    *,
    seconds: float = 7.0,
    fps: float = 20.0,
    progress: Progress | None = None,
) -> Path:
    """Save a game as a film with a fixed camera and a constant rate; the end stays for 1 s.

    Parameters
    ----------
    game
        The record of a game.
    path
        Ends in .gif, or in .mp4 where the extra `video` is installed. The folder must be there; an
        existing file is replaced.
    seconds
        Length of the game on the screen.
    fps
        Frames a second, at most 50.
    progress
        Called after each frame, with the numbers of frames drawn and of all frames.

    Returns
    -------
    pathlib.Path
        The file that was written.

    Raises
    ------
    InputError
        If the ending is another one, a number is out of its range, or `video` isn't installed.
    OSError
        If the file can't be written; its `strerror` says why.
    """
    path = Path(path)
    suffix = checked_suffix(path, FILMS, "a film")
    rate = number("fps", fps, low=0.0, strictly=True, high=50.0)
    length = number("seconds", seconds, low=0.0, strictly=True)
    if suffix == ".mp4":
        require_video()
    check_writable(path)  # before all frames are drawn
    renderer, times = FrameRenderer(game), frame_times(game, length, rate)
    frames = _reported(renderer, times, progress)
    if suffix == ".gif":
        samples = [renderer.frame(time) for time in times[:: max(1, len(times) // 8)].tolist()]
        save_gif(path, frames, samples, len(times), rate, _HOLD)
    else:
        save_mp4(path, frames, rate, _HOLD)
    return path


def frame_times(game: Game, seconds: float, fps: float) -> Floats:
    """Times of the frames in the game: evenly spaced, its start and its end included."""
    return np.linspace(0.0, end_of(game), max(2, round(seconds * fps)))


def _reported(renderer: FrameRenderer, times: Floats, progress: Progress | None) -> Iterator[Frame]:
    for done, time in enumerate(times.tolist(), start=1):
        yield renderer.frame(time)
        if progress is not None:
            progress(done, len(times))
