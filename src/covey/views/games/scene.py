"""A snapshot of a game on a map, for `draw_snapshots` and for films."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.text import Annotation

from covey.model.angles import unit_vectors
from covey.model.validation import Floats
from covey.views.games.prediction import predicted
from covey.views.games.snapshot import Snapshot, Trajectories, until
from covey.views.kit import style
from covey.views.kit.markers import (
    CAPTURED,
    CENTER,
    EVADERS,
    FLOWN,
    PLANNED,
    PREDICTED,
    PURSUER_FLOWN,
    PURSUER_PREDICTED,
    disk_handle,
    draw,
    draw_disk,
    legend_handle,
    pursuer_flying,
)
from covey.views.kit.page import Page
from covey.views.kit.point_labels import NUMBER
from covey.views.kit.sampling import joined, marked, sampled

_BESIDE = 8.5
"""From an evader to its number, typographic points."""


def draw_scene(
    axes: Axes, snapshot: Snapshot, flown: Trajectories, scale: float = 1.0
) -> list[Artist]:
    """Draw a snapshot, and return the artists; `scale` multiplies the size of the markers."""
    past, future = until(flown, snapshot), predicted(snapshot)
    positions, alive = snapshot.team.positions, snapshot.alive
    return [
        draw_disk(axes, snapshot.disk.center, snapshot.disk.radius),
        draw(axes, PURSUER_PREDICTED, future.pursuer),
        draw(axes, PLANNED, *future.paths),
        draw(axes, PURSUER_FLOWN, past.pursuer),
        draw(axes, FLOWN, *np.swapaxes(past.evaders, 0, 1)),
        draw(axes, PREDICTED, future.points, scale=scale),
        draw(axes, CAPTURED, positions[~alive], scale=scale),
        draw(axes, EVADERS, positions[alive], scale=scale),
        draw(axes, CENTER, snapshot.disk.center, scale=scale),
        draw(axes, pursuer_flying(snapshot.pursuer_heading), snapshot.pursuer, scale=scale),
    ]


def draw_numbers(axes: Axes, snapshot: Snapshot) -> list[Annotation]:
    """Write the number of each evader to its left, and return the texts.

    Behind it is its track and ahead its plan; beside it there is room, and the number doesn't jump.
    """
    lefts = _BESIDE * unit_vectors(snapshot.team.headings + 0.5 * math.pi)
    return [
        axes.annotate(
            str(i),
            tuple(snapshot.team.positions[i].tolist()),
            xytext=tuple(lefts[i].tolist()),
            textcoords="offset points",
            ha="center",
            va="center",
            fontsize=style.SMALL_TEXT_SIZE,
            zorder=style.TEXT_LAYER,
            **NUMBER,
        )
        for i in range(len(lefts))
    ]


def obstacles(snapshot: Snapshot, flown: Trajectories) -> Floats:
    """Points (K, 2) of all lines and markers of a scene, for labels to keep clear of."""
    past, future = until(flown, snapshot), predicted(snapshot)
    lines = [past.evaders, past.pursuer, *future.paths, sampled(future.pursuer)]
    markers = [snapshot.disk.center, snapshot.pursuer, future.points]
    return joined([*lines, marked(joined(markers))])


def extent(snapshots: list[Snapshot], flown: Trajectories) -> Floats:
    """Points (K, 2) that a camera must see: trajectories, and the paths planned at snapshots."""
    planned = [path for snapshot in snapshots for path in predicted(snapshot).paths]
    return joined([flown.evaders, flown.pursuer, *planned])


def draw_legend(page: Page) -> None:
    """Explain the markers, at the foot of the figure; about 0.45 in high."""
    handles = [
        legend_handle(EVADERS, "evader"),
        legend_handle(CAPTURED, "captured"),
        legend_handle(PREDICTED, "predicted capture"),
        legend_handle(pursuer_flying(0.0), "pursuer"),
        disk_handle("pursuer disk"),
        legend_handle(CENTER, "its center"),
        legend_handle(FLOWN, "flown"),
        legend_handle(PLANNED, "planned"),
        legend_handle(PURSUER_PREDICTED, "predicted pursuit"),
    ]
    page.legend(handles=handles, loc="lower center", ncols=3, columnspacing=1.2, borderpad=0.1)
