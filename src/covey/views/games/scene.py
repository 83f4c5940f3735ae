"""One moment of a game on a map: what the snapshots and the animation both show."""

from __future__ import annotations

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.model.validation import Floats
from covey.views.games.prediction import predicted
from covey.views.games.snapshot import Moment, Trajectories, until
from covey.views.kit.markers import (
    CAPTURED,
    CENTER,
    EVADERS,
    FLOWN,
    PLANNED,
    PREDICTED,
    PURSUER_FLOWN,
    PURSUER_PREDICTED,
    disk_key,
    key,
    pursuer_flying,
    put,
    put_disk,
)
from covey.views.kit.sampling import joined


def draw_moment(
    axes: Axes, moment: Moment, flown: Trajectories, scale: float = 1.0
) -> list[Artist]:
    """Put a moment of a game on a map, and return all that was put there.

    `scale` is the size of the marks.
    """
    past, future = until(flown, moment), predicted(moment)
    positions, alive = moment.team.positions, moment.alive
    return [
        put_disk(axes, moment.disk.center, moment.disk.radius),
        put(axes, PURSUER_PREDICTED, future.pursuer),
        put(axes, PLANNED, *future.paths),
        put(axes, PURSUER_FLOWN, past.pursuer),
        put(axes, FLOWN, *np.swapaxes(past.evaders, 0, 1)),
        put(axes, PREDICTED, future.points, scale=scale),
        put(axes, CAPTURED, positions[~alive], scale=scale),
        put(axes, EVADERS, positions[alive], scale=scale),
        put(axes, CENTER, moment.disk.center, scale=scale),
        put(axes, pursuer_flying(moment.pursuer_heading), moment.pursuer, scale=scale),
    ]


def extent(moments: list[Moment], flown: Trajectories) -> Floats:
    """Points (K, 2) that a camera must see: all that was flown, and what the plans foresaw."""
    foreseen = [path for moment in moments for path in predicted(moment).paths]
    return joined([flown.evaders, flown.pursuer, *foreseen])


def put_legend(figure: Figure) -> None:
    """Explain the signs, at the foot of the figure; about 0.45 in high."""
    keys = [
        key(EVADERS, "evader"),
        key(CAPTURED, "captured"),
        key(PREDICTED, "predicted capture"),
        key(pursuer_flying(0.0), "pursuer"),
        disk_key("pursuer disk"),
        key(CENTER, "its center"),
        key(FLOWN, "flown"),
        key(PLANNED, "planned"),
        key(PURSUER_PREDICTED, "predicted pursuit"),
    ]
    figure.legend(handles=keys, loc="lower center", ncols=3, columnspacing=1.2, borderpad=0.1)
