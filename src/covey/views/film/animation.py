"""A game as a film."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from covey.model.validation import Floats, number
from covey.simulation import Game
from covey.views.film.frames import Film, Frame
from covey.views.film.gif import save_gif
from covey.views.film.mp4 import require_video, save_mp4
from covey.views.games.snapshot import end_of
from covey.views.kit.saving import FILMS, checked_suffix

Progress = Callable[[int, int], None]

_HOLD = 1.0
"""Seconds for which the end stays on the screen."""


def animate(
    game: Game,
    path: str | os.PathLike[str],
    *,
    seconds: float = 7.0,
    fps: float = 20.0,
    progress: Progress | None = None,
) -> Path:
    """Save a game as a film: fixed camera, time at a constant rate, one more second for its end.

    Parameters
    ----------
    game
        The record of a game.
    path
        Ends in .gif, or in .mp4 where the extra `video` is installed. Folders that are missing are
        made, and a file of that name is replaced.
    seconds
        How long the game takes on the screen.
    fps
        Frames a second, at most 50.
    progress
        Called with the number of frames drawn and of all frames, after each one.

    Returns
    -------
    pathlib.Path
        Where it is now.

    Raises
    ------
    InputError
        If the ending is another one, a number is out of its range, or .mp4 needs what isn't
        installed.
    OSError
        If the file can't be written; its `strerror` says why.
    """
    place = Path(path)
    suffix = checked_suffix(place, FILMS, "a film")
    rate = number("fps", fps, low=0.0, strictly=True, high=50.0)
    length = number("seconds", seconds, low=0.0, strictly=True)
    if suffix == ".mp4":
        require_video()
    film, times = Film(game), frame_times(game, length, rate)
    frames = _reported(film, times, progress)
    if suffix == ".gif":
        samples = [film.frame(time) for time in times[:: max(1, len(times) // 8)].tolist()]
        save_gif(place, frames, samples, len(times), rate, _HOLD)
    else:
        save_mp4(place, frames, rate, _HOLD)
    return place


def frame_times(game: Game, seconds: float, fps: float) -> Floats:
    """Times in the game of the frames: evenly spaced, from its start to its very end."""
    return np.linspace(0.0, end_of(game), max(2, round(seconds * fps)))


def _reported(film: Film, times: Floats, progress: Progress | None) -> Iterator[Frame]:
    for done, time in enumerate(times.tolist(), start=1):
        yield film.frame(time)
        if progress is not None:
            progress(done, len(times))
