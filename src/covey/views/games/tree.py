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
from covey.views.kit.layout import add_axes, camera_around, margins, new_figure, set_view
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
from covey.views.kit.point_labels import label
from covey.views.kit.sampling import joined, sampled
from covey.views.kit.style import COLUMN_WIDTH, styled
from covey.views.kit.time_format import time_format

_COLUMNS = 3
_BOTTOM, _GAP, _TITLE = 0.5, 0.08, 0.20
_SCALE = 0.75
"""Scale of the markers, as in other maps that are not the only one in a figure."""


class Branch(NamedTuple):
    """A plan flown along its worst capture sequence."""

    paths: dict[int, Floats]  # of each evader, up to its capture
    captures: Floats  # (n, 2) in their order


@styled
def draw_contingent(tree: ContingentPlan) -> Figure:
    """Draw a contingent plan: the plan now, then the plan after each first capture.

    Every map shows its plan along the capture sequence that is the worst for it, with the turns
    that answer each capture. Hollow circles are the captures of that sequence. In the maps after a
    first capture, thick lines are what has been flown until then.

    Parameters
    ----------
    tree
        What `covey.plan_contingent` returned.

    Returns
    -------
    matplotlib.figure.Figure
        Two columns of a paper wide.
    """
    first = {i: _flown(tree, i) for i in tree.evaders} if len(tree.evaders) > 1 else {}
    plans = [tree, *(tree.after(i) for i in first)]
    branches = [_worst_branch(each) for each in plans]
    seen = joined([points for each in branches for points in each.paths.values()])
    camera = camera_around(joined([seen, tree.disk.center + tree.disk.radius * np.eye(2)]))
    left, right = margins(camera)
    side = (2.0 * COLUMN_WIDTH - left - right - (_COLUMNS - 1) * _GAP) / _COLUMNS
    rows = -(-len(plans) // _COLUMNS)
    figure = new_figure(2.0 * COLUMN_WIDTH, _BOTTOM + rows * (side + _TITLE))
    write = time_format(tree.survival_time)
    for k, (each, branch) in enumerate(zip(plans, branches, strict=True)):
        down, across = divmod(k, _COLUMNS)
        bottom = _BOTTOM + (rows - 1 - down) * (side + _TITLE)
        axes = add_axes(figure, left + across * (side + _GAP), bottom, side, side)
        set_view(axes, camera)
        axes.tick_params(labelleft=across == 0, labelbottom=k + _COLUMNS >= len(plans))
        if k == 0:
            title = f"now: survives {write(each.survival_time)}"
        else:
            captured = tree.evaders[k - 1]
            title = f"after {captured}: {write(each.survival_time)} more"
            draw(axes, FLOWN, *first[captured].values())
            draw(axes, CAPTURED, first[captured][captured][-1], scale=_SCALE)
        axes.set_title(title, loc="left", pad=3)
        _draw_plan(axes, each, branch)
    _draw_legend(figure)
    return figure


def _draw_plan(axes: Axes, tree: ContingentPlan, branch: Branch) -> None:
    """Draw the team where a plan begins, and the branch."""
    team, disk = tree.team, tree.disk
    draw_disk(axes, disk.center, disk.radius)
    draw(axes, CENTER, disk.center, scale=_SCALE)
    pursuer = np.vstack([disk.nearest_point(branch.captures[0]), branch.captures])
    draw(axes, PURSUER_PREDICTED, pursuer)
    draw(axes, PLANNED, *branch.paths.values())
    draw(axes, PREDICTED, branch.captures, scale=_SCALE)
    draw(axes, EVADERS, team.positions, scale=_SCALE)
    lines = joined([*branch.paths.values(), sampled(pursuer)])
    label(axes, team.positions, [str(i) for i in tree.evaders], lines)


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


def _draw_legend(figure: Figure) -> None:
    handles = [
        legend_handle(EVADERS, "evader"),
        legend_handle(CAPTURED, "captured"),
        legend_handle(PREDICTED, "predicted capture"),
        legend_handle(FLOWN, "flown"),
        legend_handle(PLANNED, "planned"),
        legend_handle(PURSUER_PREDICTED, "predicted pursuit"),
    ]
    figure.legend(handles=handles, loc="lower center", ncols=6, columnspacing=1.2, borderpad=0.1)
