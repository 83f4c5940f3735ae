"""A plan, with the captures that it must expect."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.bounds import Bracket
from covey.bounds.bracket import LowerEnd
from covey.planning import Plan
from covey.views.games.capture_labels import Captures, label_captures
from covey.views.games.prediction import Prediction, predict
from covey.views.games.tree import draw_contingent
from covey.views.kit.close_up import close_up, fitting_scale
from covey.views.kit.layout import camera_around, single_map
from covey.views.kit.markers import (
    CENTER,
    EVADERS,
    PLANNED,
    PREDICTED,
    PURSUER_PREDICTED,
    draw,
    draw_disk,
)
from covey.views.kit.page import sheet_of
from covey.views.kit.sampling import joined, marked, rim, sampled
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
    figure, axes = single_map(camera, sheet_of(ax, title, width), team.unit)
    inset = close_up(axes, start, lines)
    for each in (axes, inset) if inset else (axes,):
        _draw_paths(each, plan, expected)
    captures = Captures(expected.points, expected.evaders, expected.times)
    label_captures(axes, inset, team, captures, write, joined([lines, start, marked(disk.center)]))
    return figure


def draw_bracket(
    bracket: Bracket,
    *,
    ax: Axes | None = None,
    title: str | None = None,
    width: float | None = None,
) -> Figure:
    """Draw the plan that guarantees the lower end of a bracket, and name both ends.

    Parameters
    ----------
    bracket
        What `covey.bracket` returned.
    ax, width
        See `draw_plan` or, where a contingent plan guarantees more, `draw_contingent`.
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
    tree = bracket.contingent
    if tree is not None and bracket.lower_by is LowerEnd.CONTINGENT:
        return draw_contingent(tree, ax=ax, title=title, width=width or 2.0 * COLUMN_WIDTH)
    return draw_plan(bracket.plan, ax=ax, title=title, width=width or COLUMN_WIDTH)


def _draw_paths(axes: Axes, plan: Plan, expected: Prediction) -> None:
    """Draw everything but labels."""
    scale = fitting_scale(axes, plan.team.positions)
    draw_disk(axes, plan.disk.center, plan.disk.radius)
    draw(axes, CENTER, plan.disk.center, scale=scale)
    draw(axes, PURSUER_PREDICTED, expected.pursuer)
    draw(axes, PLANNED, *expected.paths)
    draw(axes, PREDICTED, expected.points)
    draw(axes, EVADERS, plan.team.positions, scale=scale)
