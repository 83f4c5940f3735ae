"""Write frames to an MP4 file, with the ffmpeg of the extra `video`."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from importlib import import_module
from itertools import repeat
from pathlib import Path
from typing import Any

from covey.model import InputError
from covey.simulation.files import whole_file
from covey.views.film.frames import Frame


def require_video() -> Any:
    """Return the module that runs ffmpeg, or raise InputError that says how to install it."""
    try:
        return import_module("imageio_ffmpeg")
    except ImportError:
        raise InputError(
            "a film as .mp4 needs ffmpeg: pip install 'covey[video]', or save it as .gif"
        ) from None


def has_video() -> bool:
    """Tell whether ffmpeg is installed."""
    try:
        require_video()
    except InputError:
        return False
    return True


def save_mp4(path: Path, frames: Iterator[Frame], fps: float, hold: float) -> None:
    """Write frames as a film whose last frame stays for `hold` seconds.

    ffmpeg writes to a temporary file first, so `path` never holds half a film.
    """
    video = require_video()
    with tempfile.TemporaryDirectory() as folder:
        part = Path(folder) / "film.mp4"
        _encode(video, part, _held(frames, round(hold * fps)), fps)
        with whole_file(path) as file, part.open("rb") as film:
            shutil.copyfileobj(film, file)


def _encode(video: Any, path: Path, frames: Iterator[Frame], fps: float) -> None:
    first = next(frames)
    height, width, _ = first.shape
    writer = video.write_frames(
        str(path),
        (width, height),
        fps=fps,
        codec="libx264",
        quality=8,
        macro_block_size=2,
        output_params=["-movflags", "+faststart"],  # a browser plays it before it is all loaded
    )
    writer.send(None)
    try:
        writer.send(first.tobytes())
        for frame in frames:
            writer.send(frame.tobytes())
    finally:
        writer.close()


def _held(frames: Iterator[Frame], more: int) -> Iterator[Frame]:
    """The frames, then the last frame `more` times again."""
    for frame in frames:
        yield frame
    yield from repeat(frame, more)
