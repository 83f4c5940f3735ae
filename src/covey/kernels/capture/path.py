"""The single-parameter Dubins path (eq. 5): one arc at full turn rate, then straight.

A path is a row of `PATH` numbers that the other kernels read; `set_paths` writes it. Time counts
from the moment of planning. The straight part is stored as a line extended back to time 0, so that
the position at t, which is asked most often, costs two multiplications.
"""

from __future__ import annotations

import math

from covey.kernels._jit import entry, inlined
from covey.kernels.arrays import PATH as PATH
from covey.kernels.arrays import Floats, Matrix, Tensor, Vector

# An evader is a row (x, y, heading, speed, turn rate).
X, Y, HEADING, SPEED, TURN_RATE = range(5)
EVADER = 5

# A path is a row (end of the turn, line at time 0, velocity on the line, arc, second derivatives).
TURN_END = 0
LINE_X, LINE_Y, VELOCITY_X, VELOCITY_Y = 1, 2, 3, 4
START_X, START_Y, START_HEADING, CHORD, HALF_RATE = 5, 6, 7, 8, 9
TURN_END_SLOPE = 10  # d(end of the turn) / d(signed turn): sign(turn) / turn rate
CLOSING = 11  # v_p^2 - v^2
START_COSINE, START_SINE = 12, 13
STEERS = 14  # 1; 0 if the evader can't turn, so that its path doesn't depend on the turn


@entry
def set_paths(evaders: Matrix, turns: Vector, pursuer_speed: float, paths: Matrix) -> None:
    """Write, for each evader, the path that turns by a signed angle and then flies straight.

    An evader that can't turn (rate 0) flies straight, whatever its turn is. An infinite rate turns
    at once.

    Parameters
    ----------
    evaders
        (n, EVADER) rows of position, heading, speed and turn rate.
    turns
        (n,) signed turns, radians.
    pursuer_speed
        v_p.
    paths
        (n, PATH) modified in place.
    """
    for i in range(len(turns)):
        heading, speed, rate = evaders[i, HEADING], evaders[i, SPEED], evaders[i, TURN_RATE]
        turn = turns[i] if rate > 0.0 else 0.0
        turn_end = abs(turn) / rate if turn != 0.0 else 0.0
        goal = heading + turn
        velocity_x, velocity_y = speed * math.cos(goal), speed * math.sin(goal)
        end_x, end_y = evaders[i, X], evaders[i, Y]
        chord = half_rate = turn_end_slope = 0.0
        if turn_end > 0.0:
            # A chord of the circle keeps full precision however large the circle is.
            chord = 2.0 * speed / rate
            half_rate = math.copysign(0.5 * rate, turn)
            turn_end_slope = math.copysign(1.0 / rate, turn)
            reach = chord * math.sin(0.5 * abs(turn))
            end_x += reach * math.cos(heading + 0.5 * turn)
            end_y += reach * math.sin(heading + 0.5 * turn)
        paths[i, TURN_END] = turn_end
        paths[i, STEERS] = 1.0 if rate > 0.0 else 0.0
        paths[i, LINE_X] = end_x - velocity_x * turn_end
        paths[i, LINE_Y] = end_y - velocity_y * turn_end
        paths[i, VELOCITY_X], paths[i, VELOCITY_Y] = velocity_x, velocity_y
        paths[i, START_X], paths[i, START_Y] = evaders[i, X], evaders[i, Y]
        paths[i, START_HEADING] = heading
        if turn_end > 0.0:
            paths[i, START_COSINE], paths[i, START_SINE] = math.cos(heading), math.sin(heading)
        paths[i, CHORD], paths[i, HALF_RATE] = chord, half_rate
        paths[i, TURN_END_SLOPE] = turn_end_slope
        paths[i, CLOSING] = (pursuer_speed - speed) * (pursuer_speed + speed)


@inlined
def position(paths: Floats, i: int, time: float) -> tuple[float, float]:
    """The position of evader i at `time`."""
    if time >= paths[i, TURN_END]:
        return (
            paths[i, LINE_X] + paths[i, VELOCITY_X] * time,
            paths[i, LINE_Y] + paths[i, VELOCITY_Y] * time,
        )
    half_turn = paths[i, HALF_RATE] * time
    reach = paths[i, CHORD] * abs(math.sin(half_turn))
    bearing = paths[i, START_HEADING] + half_turn
    return (
        paths[i, START_X] + reach * math.cos(bearing),
        paths[i, START_Y] + reach * math.sin(bearing),
    )


@entry
def sample(paths: Matrix, times: Vector, positions: Tensor) -> None:
    """Write the position of every evader at each of the `times`, to (times, evaders, 2)."""
    for k in range(len(times)):
        for i in range(len(paths)):
            positions[k, i, 0], positions[k, i, 1] = position(paths, i, times[k])


@inlined
def velocity(paths: Floats, i: int, time: float) -> tuple[float, float]:
    """The velocity of evader i at `time`."""
    if time >= paths[i, TURN_END]:
        return paths[i, VELOCITY_X], paths[i, VELOCITY_Y]
    heading = paths[i, START_HEADING] + 2.0 * paths[i, HALF_RATE] * time
    speed = paths[i, CHORD] * abs(paths[i, HALF_RATE])
    return speed * math.cos(heading), speed * math.sin(heading)


@inlined
def wrapped(angle: float) -> float:
    """The same direction in [-π, π]."""
    return angle - 2.0 * math.pi * round(angle / (2.0 * math.pi))
