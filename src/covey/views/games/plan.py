"""A plan, with the captures that it must expect."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from covey.model import PursuerDisk, Team
from covey.planning import Plan
from covey.views.games.prediction import predict
from covey.views.kit.layout import TITLE, camera_around, single_map
from covey.views.kit.markers import (
    CENTER,
    EVADERS,
    PLANNED,
    PREDICTED,
    PURSUER_PREDICTED,
    draw,
    draw_disk,
)
from covey.views.kit.point_labels import label
from covey.views.kit.sampling import joined, sampled
from covey.views.kit.style import styled
from covey.views.kit.time_format import time_format


@styled
def draw_plan(team: Team, disk: PursuerDisk, plan: Plan) -> Figure:
    """Draw the paths of a plan, each up to the capture that the plan must expect.

    Hollow circles are the captures along the first critical sequence, numbered in order, with their
    times.

    Parameters
    ----------
    team, disk
        The state that was planned for.
    plan
        The plan that `covey.plan` returned for this state.

    Returns
    -------
    matplotlib.figure.Figure
        One column of a paper wide.
    """
    sequence = np.array(plan.critical_sequences[0], dtype=np.int64)
    expected = predict(team, disk, plan.turns, sequence)
    lines = joined([*expected.paths, sampled(expected.pursuer)])
    reach = disk.radius * np.array([[-1.0, -1.0], [1.0, 1.0]])
    camera = camera_around(joined([lines, disk.center + reach]))
    figure, axes = single_map(camera, headroom=TITLE)
    draw_disk(axes, disk.center, disk.radius)
    draw(axes, CENTER, disk.center)
    draw(axes, PURSUER_PREDICTED, expected.pursuer)
    draw(axes, PLANNED, *expected.paths)
    draw(axes, PREDICTED, expected.points)
    draw(axes, EVADERS, team.positions)
    write = time_format(plan.survival_time)
    axes.set_title(f"guaranteed survival {write(plan.survival_time)}", loc="left", pad=4)
    texts = [f"{k}: {write(time)}" for k, time in enumerate(expected.times.tolist(), start=1)]
    label(axes, expected.points, texts, joined([lines, team.positions]))
    return figure
