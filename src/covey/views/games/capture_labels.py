"""Labels of a game or a plan: the numbers of the evaders, and their captures."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes

from covey.model import Team
from covey.model.validation import Floats
from covey.views.kit.point_labels import NUMBER, label, number_evaders


class Captures(NamedTuple):
    """Where evaders are captured, (C, 2), and what is written there."""

    points: Floats
    texts: Sequence[str]


def label_captures(
    axes: Axes, inset: Axes | None, team: Team, captures: Captures, lines: Floats
) -> None:
    """Write the number of each evader beside its start, and the text of each capture.

    With a close-up, the numbers stand there.
    """
    points, texts = captures
    numbers = [str(i) for i in range(len(team))]
    if inset:
        number_evaders(inset, team.positions, range(len(team)), lines)
        label(axes, points, texts, lines, clear_of=[inset])
    else:
        looks = [NUMBER] * len(numbers) + [{}] * len(texts)
        places = np.concatenate([team.positions, points])
        label(axes, places, [*numbers, *texts], lines, looks=looks)
