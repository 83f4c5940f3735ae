"""A scenario: where a game starts."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.model.angles import unit_vectors
from covey.model.units import counted
from covey.scenarios import Scenario
from covey.views.kit.close_up import fitting_scale
from covey.views.kit.layout import camera_around, single_map
from covey.views.kit.markers import CENTER, EVADERS, HEADINGS, draw, draw_disk
from covey.views.kit.page import sheet_of
from covey.views.kit.point_labels import number_evaders
from covey.views.kit.sampling import joined, marked, rim, sampled
from covey.views.kit.style import COLUMN_WIDTH, styled

_AHEAD = 0.3
"""Length of the line ahead of the fastest evader, relative to half the side of the start."""


@styled
def draw_scenario(
    scenario: Scenario,
    *,
    ax: Axes | None = None,
    title: str | None = None,
    width: float = COLUMN_WIDTH,
) -> Figure:
    """Draw the start of a scenario: the evaders, and the disk of the pursuer.

    The line ahead of an evader has the direction of its heading, and is as long as the evader is
    fast, relative to the others.

    Parameters
    ----------
    scenario
        What `covey.load_scenario` returned.
    ax
        Axes to draw on. Default: a new figure.
    title
        Default: how many evaders there are, and whether they see the pursuer.
    width
        Of a new figure, inches. Default: one column of a paper, 3.5.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> import covey
    >>> from covey import views
    >>> figure = views.draw_scenario(covey.load_scenario("unequal"))
    """
    team, disk = scenario.team, scenario.disk
    start = joined([team.positions, disk.center, rim(disk.center, disk.radius)])
    fastest = float(team.speeds.max()) or 1.0
    lengths = _AHEAD * camera_around(start).half_side * team.speeds / fastest
    ends = team.positions + lengths[:, None] * unit_vectors(team.headings)
    ahead = np.stack([team.positions, ends], axis=1)
    if title is None:
        title = f"{counted(len(team), 'evader')}, {scenario.sensing} pursuer"
    camera = camera_around(joined([start, ends]))
    figure, axes = single_map(camera, sheet_of(ax, title, width), team.unit)
    scale = fitting_scale(axes, team.positions)
    draw_disk(axes, disk.center, disk.radius)
    draw(axes, CENTER, disk.center, scale=scale)
    draw(axes, HEADINGS, *ahead)
    draw(axes, EVADERS, team.positions, scale=scale)
    lines = joined([*map(sampled, ahead), start, marked(disk.center)])
    number_evaders(axes, team.positions, range(len(team)), lines)
    return figure
