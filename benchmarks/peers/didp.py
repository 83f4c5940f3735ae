"""didppy on the inner minimum of eq. (6) for straight flight: domain-independent DP.

A state is the set of evaders that are free, who was captured last, and the time, of which less is
better. A capture takes the closed form of eq. (7). The bound of a state is the capture in it that
takes longest if the pursuer flies there at once. Complete anytime beam search is the solver that
its authors advise; bounds are proven at any time.
"""

from __future__ import annotations

import time
from typing import NamedTuple

import didppy as dp
import numpy as np


class Certificate(NamedTuple):
    """What a method knows about a minimum over all capture sequences, and after what time."""

    seconds: float
    lower: float
    upper: float
    exact: bool


class Didp:
    """The exact minimum, for evaders that fly straight ahead."""

    name = "didppy, CABS"

    def certify(self, team, disk, seconds):
        """Return the certificate that so many seconds bring; the model isn't timed."""
        model = straight_flight_model(team, disk)
        solver = dp.CABS(model, time_limit=seconds, quiet=True)
        begun = time.perf_counter()
        found = solver.search()
        spent = time.perf_counter() - begun
        return Certificate(spent, found.best_bound or 0.0, found.cost, found.is_optimal)


def straight_flight_model(team, disk):
    """Return the model: the least time in which all evaders, flying straight, are captured."""
    n = len(team)
    # The last place is the pursuer's own, where it hasn't captured anybody.
    positions = np.vstack([team.positions, disk.center])
    ways = np.column_stack([np.cos(team.headings), np.sin(team.headings)])
    velocities = np.vstack([team.speeds[:, None] * ways, np.zeros(2)])
    radii = np.append(np.full(n, 2.0 * disk.capture_radius), disk.radius + disk.capture_radius)
    model = dp.Model(float_cost=True)
    place = model.add_object_type(number=n + 1)
    free = model.add_set_var(object_type=place, target=range(n))
    last = model.add_element_var(object_type=place, target=n)
    now = model.add_float_resource_var(target=0.0, less_is_better=True)
    radius = model.add_float_table(radii.tolist())[last]

    def at_last(values):
        return model.add_float_table(values.tolist())[last]

    def duration(i):
        """Time of the flight to the capture of evader i: the root of eq. (7)."""
        x, y = (
            at_last(column) + at_last(drift) * now
            for column, drift in zip(
                (positions[i] - positions).T, (velocities[i] - velocities).T, strict=True
            )
        )
        vx, vy = velocities[i].tolist()
        closing = disk.speed**2 - vx**2 - vy**2
        if not radii.any():
            b = x * vx + y * vy
            return (b + dp.sqrt(b * b + (x * x + y * y) * closing)) / closing
        b = x * vx + y * vy - disk.speed * radius
        outside = x * x + y * y - radius * radius
        root = (b + dp.sqrt(b * b + dp.max(outside, 0.0) * closing)) / closing
        return (outside > 0.0).if_then_else(root, 0.0)

    model.add_base_case([free.is_empty()])
    for i in range(n):
        flight = model.add_float_state_fun(duration(i))
        capture = dp.Transition(
            name=str(i),
            cost=flight + dp.FloatExpr.state_cost(),
            effects=[(free, free.remove(i)), (last, i), (now, now + flight)],
            preconditions=[free.contains(i)],
        )
        model.add_transition(capture)
        model.add_dual_bound(free.contains(i).if_then_else(flight, 0.0))
    return model
