"""The game once more, in plain Python and by other means than the kernels use: slow and obvious."""

from __future__ import annotations

import itertools
import math

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

FINEST = 1e-15
"""How closely a root is enclosed, relative to the time at which it lies."""


def turn_end(team, turns, i):
    """When evader i has finished its turn (t_c of the paper); it never does with turn rate 0."""
    if turns[i] == 0.0 or team.turn_rates[i] == 0.0:
        return 0.0
    return abs(turns[i]) / team.turn_rates[i]


def place(team, turns, i, time):
    """Where evader i is: the chord of its arc, then straight (eq. 5)."""
    heading, speed = team.headings[i], team.speeds[i]
    goal = heading + (turns[i] if team.turn_rates[i] > 0.0 else 0.0)
    end = turn_end(team, turns, i)
    turning, straight = min(time, end), max(time - end, 0.0)
    half = math.copysign(0.5, turns[i]) * team.turn_rates[i] * turning if turning > 0.0 else 0.0
    chord = speed * turning * np.sinc(half / math.pi)
    return (
        team.positions[i]
        + chord * np.array([math.cos(heading + half), math.sin(heading + half)])
        + speed * straight * np.array([math.cos(goal), math.sin(goal)])
    )


def flown_place(team, turns, i, time):
    """Where evader i is, by integrating its equations of motion; needs a finite turn rate."""
    rate = math.copysign(team.turn_rates[i], turns[i])
    end = turn_end(team, turns, i)
    state = np.array([*team.positions[i], team.headings[i]])
    for start, stop, control in ((0.0, min(time, end), rate), (end, time, 0.0)):
        if stop > start:
            state = solve_ivp(
                _dubins, (start, stop), state, "DOP853", args=(team.speeds[i], control),
                rtol=1e-13, atol=1e-14,
            ).y[:, -1]  # fmt: skip
    return state[:2]


def _dubins(_time, state, speed, control):
    return [speed * math.cos(state[2]), speed * math.sin(state[2]), control]


def gap(team, turns, i, center, radius, start, pursuer_speed, time):
    """How far evader i is outside the disk that grows from `start` on: g of eq. (7)."""
    off = place(team, turns, i, time) - center
    return math.hypot(*off) - radius - pursuer_speed * (time - start)


def stepped_capture(team, disk, turns, steps=200):
    """The first moment at which the disk holds the one evader: march, then halve the last step."""

    def outside(time):
        reach = disk.radius + disk.capture_radius
        return gap(team, turns, 0, disk.center, reach, 0.0, disk.speed, time) > 0.0

    if not outside(0.0):
        return 0.0
    distance = math.hypot(*(team.positions[0] - disk.center))
    stride = distance / (disk.speed - team.speeds[0]) / steps
    low, high = 0.0, stride
    while outside(high):
        low, high = high, high + stride
    while low < 0.5 * (low + high) < high:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if outside(middle) else (low, middle)
    return high


def sequence_times(team, disk, turns, sequence):
    """Algorithm 1, with a general root finder for every capture."""
    times = []
    time, center, radius = 0.0, disk.center, disk.radius + disk.capture_radius
    for i in sequence:

        def outside(moment, i=i, center=center, radius=radius, start=time):
            return gap(team, turns, i, center, radius, start, disk.speed, moment)

        here = outside(time)
        if here > 0.0:
            latest = time + 1.001 * here / (disk.speed - team.speeds[i])
            time = brentq(outside, time, latest, xtol=FINEST * latest, rtol=4.0 * FINEST)
        times.append(time)
        center, radius = place(team, turns, i, time), 2.0 * disk.capture_radius
    return np.array(times)


def every_sequence(count):
    """All N! capture sequences."""
    return list(itertools.permutations(range(count)))
