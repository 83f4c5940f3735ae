"""A contingent plan: what the team does now, and what it will do after each first capture."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.model.validation import Floats
from covey.planning import ContingentPlan
from covey.simulation.expected_captures import expected_captures
from covey.views.games.flight import path
from covey.views.kit.close_up import fitting_scale
from covey.views.kit.layout import camera_around, maps_in_rows
from covey.views.kit.markers import (
    CAPTURED,
    CENTER,
    EVADERS,
    FLOWN,
    PLANNED,
    PREDICTED,
    PURSUER_PREDICTED,
    draw,
    draw_disk,
    legend_handle,
)
from covey.views.kit.page import Page, sheet_of
from covey.views.kit.point_labels import number_evaders
from covey.views.kit.sampling import joined, marked, sampled
from covey.views.kit.style import COLUMN_WIDTH, styled
from covey.views.kit.time_format import time_format

_COLUMNS = 3
_FOOT = 0.66
"""For the names of the axes and the legend, inches."""
_SCALE = 0.75
"""Scale of the markers, as in other maps that are not the only one in a figure."""


class Branch(NamedTuple):
    """A plan flown along its worst capture sequence."""

    paths: dict[int, Floats]  # of each evader, up to its capture
    captures: Floats  # (n, 2) in their order


@styled
def draw_contingent(
    tree: ContingentPlan,
    *,
    ax: Axes | None = None,
    title: str | None = None,
    width: float = 2.0 * COLUMN_WIDTH,
) -> Figure:
    """Draw a contingent plan: the plan now, then the plan after each first capture.

    Every map shows its plan along the capture sequence that is the worst for it, with the turns
    that answer each capture. Hollow circles are the captures of that sequence. In the maps after a
    first capture, thick lines are what has been flown until then.

    Parameters
    ----------
    tree
        What `covey.plan_contingent` returned.
    ax
        Axes in whose place the maps are drawn. Default: a new figure.
    title
        Above all maps. Default: none.
    width
        Of a new figure, inches. Default: two columns of a paper, 7.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> from covey import views
    >>> figure = views.draw_contingent(covey.plan_contingent(team, disk))
    """
    first = {i: _flown(tree, i) for i in tree.evaders} if len(tree.evaders) > 1 else {}
    plans = [tree, *(tree.after(i) for i in first)]
    branches = [_worst_branch(each) for each in plans]
    seen = joined([points for each in branches for points in each.paths.values()])
    camera = camera_around(joined([seen, tree.disk.center + tree.disk.radius * np.eye(2)]))
    write = time_format(tree.survival_time, tree.team.units.time)
    names = [f"now: survives {write(tree.survival_time)}"]
    names += [f"after {i}: {write(tree.after(i).survival_time)} more" for i in first]
    sheet = sheet_of(ax, title, width)
    page, maps = maps_in_rows(names, _COLUMNS, camera, tree.team.unit, _FOOT, sheet)
    flights: list[dict[int, Floats]] = [{}, *first.values()]
    for axes, each, branch, flown in zip(maps, plans, branches, flights, strict=True):
        _draw_plan(axes, each, branch, [*flown.values()])
    for axes, (i, flown) in zip(maps[1:], first.items(), strict=True):
        draw(axes, CAPTURED, flown[i][-1], scale=_SCALE)
    _draw_legend(page)
    return page.figure


def _draw_plan(axes: Axes, tree: ContingentPlan, branch: Branch, flown: list[Floats]) -> None:
    """Draw what was flown until a plan begins, the team there, and the branch."""
    draw(axes, FLOWN, *flown)
    team, disk = tree.team, tree.disk
    scale = _SCALE * fitting_scale(axes, team.positions)
    draw_disk(axes, disk.center, disk.radius)
    draw(axes, CENTER, disk.center, scale=scale)
    pursuer = np.vstack([disk.nearest_point(branch.captures[0]), branch.captures])
    draw(axes, PURSUER_PREDICTED, pursuer)
    draw(axes, PLANNED, *branch.paths.values())
    draw(axes, PREDICTED, branch.captures, scale=_SCALE)
    draw(axes, EVADERS, team.positions, scale=scale)
    lines = joined([*branch.paths.values(), sampled(pursuer), *flown])
    markers = joined([branch.captures, disk.center])
    number_evaders(axes, team.positions, tree.evaders, joined([lines, marked(markers)]))


def _flown(tree: ContingentPlan, i: int) -> dict[int, Floats]:
    """Return what each evader flies until evader i is captured first, as early as it can be."""
    rank = tree.evaders.index(i)
    time = float(expected_captures(tree.team, tree.disk, tree.turns, np.array([rank]))[0])
    team = tree.team
    return {j: path(team, tree.turns, k, time) for k, j in enumerate(tree.evaders)}


def _worst_branch(tree: ContingentPlan) -> Branch:
    """Return a plan along its worst sequence, each capture as early as it can be."""
    pieces: dict[int, list[Floats]] = {i: [] for i in tree.evaders}
    captures = []
    for i in tree.critical_sequences[0]:
        flown = _flown(tree, i)
        for j, points in flown.items():
            pieces[j].append(points)
        captures.append(flown[i][-1])
        if len(tree.evaders) > 1:
            tree = tree.after(i)
    return Branch({i: np.concatenate(each) for i, each in pieces.items()}, np.array(captures))


def _draw_legend(page: Page) -> None:
    columns = 6 if page.width > 1.5 * COLUMN_WIDTH else 3
    handles = [
        legend_handle(EVADERS, "evader"),
        legend_handle(CAPTURED, "captured"),
        legend_handle(PREDICTED, "predicted capture"),
        legend_handle(FLOWN, "flown"),
        legend_handle(PLANNED, "planned"),
        legend_handle(PURSUER_PREDICTED, "predicted pursuit"),
    ]
    page.legend(
        handles=handles, loc="lower center", ncols=columns, columnspacing=1.2, borderpad=0.1
    )
