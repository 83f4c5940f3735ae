"""A plan, with the captures that it must expect."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.bounds import Bracket
from covey.planning import Plan
from covey.views.games.prediction import Prediction, predict
from covey.views.kit.close_up import close_up, fitting_scale
from covey.views.kit.layout import Sheet, camera_around, single_map
from covey.views.kit.markers import (
    CENTER,
    EVADERS,
    PLANNED,
    PREDICTED,
    PURSUER_PREDICTED,
    draw,
    draw_disk,
)
from covey.views.kit.point_labels import NUMBER, label, number_and_time, number_evaders
from covey.views.kit.sampling import joined, rim, sampled
from covey.views.kit.style import COLUMN_WIDTH, styled
from covey.views.kit.time_format import time_format


@styled
def draw_plan(
    plan: Plan, *, ax: Axes | None = None, title: str | None = None, width: float = COLUMN_WIDTH
) -> Figure:
    """Draw the paths of a plan, each up to the capture that the plan must expect.

    Hollow circles are the captures along the first critical sequence: who is captured, and when.
    Where the team is small beside its paths, a close-up shows it.

    Parameters
    ----------
    plan
        What `covey.plan` returned.
    ax
        Axes to draw on. Default: a new figure.
    title
        Default: the survival time that the plan guarantees.
    width
        Of a new figure, inches. Default: one column of a paper, 3.5.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> from covey import views
    >>> figure = views.draw_plan(covey.plan(team, disk), title="three evaders")
    """
    team, disk = plan.team, plan.disk
    sequence = np.array(plan.critical_sequences[0], dtype=np.int64)
    expected = predict(team, disk, plan.turns, sequence)
    lines = joined([*expected.paths, sampled(expected.pursuer)])
    start = joined([team.positions, rim(disk.center, disk.radius)])
    write = time_format(plan.survival_time, team.units.time)
    if title is None:
        title = f"guaranteed survival {write(plan.survival_time)}"
    camera = camera_around(joined([lines, start]))
    figure, axes = single_map(camera, Sheet(ax, title, width), team.unit)
    inset, numbers = close_up(axes, start, lines), range(len(team))
    texts = [
        number_and_time(i, write(time))
        for i, time in zip(expected.evaders.tolist(), expected.times.tolist(), strict=True)
    ]
    for each in (axes, inset) if inset else (axes,):
        _draw_paths(each, plan, expected)
    if inset:
        label(axes, expected.points, texts, lines)
        number_evaders(inset, team.positions, numbers, joined([lines, start]))
    else:
        looks = [NUMBER] * len(team) + [{}] * len(texts)
        places = np.concatenate([team.positions, expected.points])
        label(axes, places, [*map(str, numbers), *texts], lines, looks=looks)
    return figure


def draw_bracket(
    bracket: Bracket,
    *,
    ax: Axes | None = None,
    title: str | None = None,
    width: float = COLUMN_WIDTH,
) -> Figure:
    """Draw the plan of a bracket, and between which times the true value of the game lies.

    Parameters
    ----------
    bracket
        What `covey.bracket` returned.
    ax, width
        See `draw_plan`.
    title
        Default: both bounds.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> from covey import views
    >>> figure = views.draw_bracket(covey.bracket(team, disk))
    """
    write = time_format(bracket.upper, bracket.plan.team.units.time)
    if title is None:
        title = f"sure of {write(bracket.lower)}; nobody of more than {write(bracket.upper)}"
    return draw_plan(bracket.plan, ax=ax, title=title, width=width)


def _draw_paths(axes: Axes, plan: Plan, expected: Prediction) -> None:
    """Draw everything but labels."""
    scale = fitting_scale(axes, plan.team.positions)
    draw_disk(axes, plan.disk.center, plan.disk.radius)
    draw(axes, CENTER, plan.disk.center, scale=scale)
    draw(axes, PURSUER_PREDICTED, expected.pursuer)
    draw(axes, PLANNED, *expected.paths)
    draw(axes, PREDICTED, expected.points)
    draw(axes, EVADERS, plan.team.positions, scale=scale)
