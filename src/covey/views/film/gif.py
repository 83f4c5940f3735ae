"""Write frames to a GIF file. All frames share one palette, so no colour flickers."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
from PIL import Image

from covey.simulation.files import whole_file
from covey.views.film.frames import Frame

_COLORS = 64


def save_gif(
    path: Path,
    frames: Iterable[Frame],
    samples: Sequence[Frame],
    count: int,
    fps: float,
    hold: float,
) -> None:
    """Write `count` frames as a film that stays at its end for `hold` seconds, then repeats.

    The palette is made for `samples`, some of the frames.
    """
    palette = Image.fromarray(np.concatenate(samples)).quantize(
        _COLORS, method=Image.Quantize.MAXCOVERAGE
    )
    pictures = (
        Image.fromarray(frame).quantize(palette=palette, dither=Image.Dither.NONE)
        for frame in frames
    )
    with whole_file(path) as file:
        next(pictures).save(
            file,
            format="GIF",
            save_all=True,
            append_images=pictures,
            duration=_durations(count, fps, hold),
            loop=0,
        )


def _durations(count: int, fps: float, hold: float) -> list[int]:
    """Milliseconds for each frame, rounded: a GIF counts in hundredths of a second."""
    ends = np.arange(count + 1) / fps
    ends[-1] += hold
    steps: list[int] = (10 * np.diff(np.rint(100.0 * ends)).astype(int)).tolist()
    return steps
