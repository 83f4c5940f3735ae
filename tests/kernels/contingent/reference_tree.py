"""Contingent plans once more, by recursion in plain Python: each capture begins a smaller game."""

from __future__ import annotations

import math

import numpy as np

import covey
from kernels import reference_game


def size(count, depth):
    """How many turns a tree of `count` evaders has that answers `depth` captures."""
    return count * (1 + (size(count - 1, depth - 1) if depth > 0 else 0))


def turned(team, turns, i, time):
    """By how much evader i has turned."""
    if reference_game.turn_end(team, turns, i) <= time:
        return turns[i] if team.turn_rates[i] > 0.0 else 0.0
    return math.copysign(team.turn_rates[i] * time, turns[i])


def after_capture(team, disk, turns, first, time):
    """Those left once an evader was captured, and the disk about the place of the capture."""
    left = [i for i in range(len(team)) if i != first]
    smaller = covey.Team(
        [reference_game.place(team, turns, i, time) for i in left],
        [team.headings[i] + turned(team, turns, i, time) for i in left],
        team.speeds[left],
        team.turn_rates[left],
    )
    center, reach = reference_game.place(team, turns, first, time), disk.capture_radius
    return smaller, covey.PursuerDisk(center, reach, disk.speed, reach)


def times(team, disk, tree, depth, sequence, delays=()):
    """Capture times in the order of `sequence`; the first captures are put off by the delays."""
    count, first = len(team), sequence[0]
    now = tree[:count]
    if depth == 0 or count == 1:
        return list(reference_game.sequence_times(team, disk, now, sequence))
    time = reference_game.sequence_times(team, disk, now, [first])[0] + sum(delays[:1])
    below = size(count - 1, depth - 1)
    begin = count + first * below
    smaller = after_capture(team, disk, now, first, time)
    rest = [i - (i > first) for i in sequence[1:]]
    later = times(*smaller, tree[begin : begin + below], depth - 1, rest, delays[1:])
    return [time, *(time + each for each in later)]


def value(team, disk, tree, depth):
    """The least last capture over all sequences."""
    every = reference_game.every_sequence(len(team))
    return min(times(team, disk, tree, depth, sequence)[-1] for sequence in every)


def random_tree(generator, team, depth):
    """Any turns in every node."""
    return generator.uniform(-math.pi, math.pi, size(len(team), depth)) * np.float64(0.9)
