"""Labels of a game or a plan: the numbers of the evaders, and who is captured when."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes

from covey.model import Team
from covey.model.validation import Floats, Ints
from covey.views.kit import style
from covey.views.kit.point_labels import NUMBER, label, number_evaders

_WIDE = 2.0
"""Inches: on a narrower map the labels are smaller."""


class Captures(NamedTuple):
    """Captures in their order."""

    points: Floats  # (C, 2)
    evaders: Ints  # (C,) their numbers
    times: Floats  # (C,)


def number_and_time(evader: int, time: str) -> str:
    """Write who is captured, and the time with its unit: **3**: t = 12.5 s."""
    return rf"$\mathbf{{{evader}}}$: $t$ = {time}"


def label_captures(
    axes: Axes,
    inset: Axes | None,
    team: Team,
    captures: Captures,
    write: Callable[[float], str],
    lines: Floats,
) -> None:
    """Write the number of each evader beside its start, and who is captured when.

    With a close-up, the numbers of the starts stand there. `write` writes a time with its unit.
    """
    points, evaders, times = captures
    texts = [
        number_and_time(i, write(time))
        for i, time in zip(evaders.tolist(), times.tolist(), strict=True)
    ]
    numbers = [str(i) for i in range(len(team))]
    width = axes.get_window_extent().width / axes.figure.dpi
    size = style.SMALL_TEXT_SIZE * min(1.0, width / _WIDE)
    if inset:
        number_evaders(inset, team.positions, range(len(team)), lines)
        label(axes, points, texts, lines, size, clear_of=[inset])
    else:
        looks = [NUMBER] * len(numbers) + [{}] * len(texts)
        places = np.concatenate([team.positions, points])
        label(axes, places, [*numbers, *texts], lines, size, looks=looks)
