"""All N! capture sequences at once, in NumPy: their times (Algorithm 1) and exact gradients.

Sequences that begin alike share what they begin with, so the captures form a tree: N first ones,
N (N - 1) second ones, and so on. Each level of it is one set of array operations.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

_MOST_STEPS = 100


@dataclass
class Sequences:
    """The tree of all capture sequences of `count` evaders."""

    count: int
    parents: list[np.ndarray] = field(default_factory=list)  # by level, (nodes,) one level up
    evaders: list[np.ndarray] = field(default_factory=list)  # by level, (nodes,) who is captured

    def __post_init__(self):
        begun = [()]
        for _ in range(self.count):
            grown = [
                (parent, (*sequence, i))
                for parent, sequence in enumerate(begun)
                for i in range(self.count)
                if i not in sequence
            ]
            begun = [sequence for _, sequence in grown]
            self.parents.append(np.array([parent for parent, _ in grown]))
            self.evaders.append(np.array([sequence[-1] for sequence in begun]))


def capture_times(sequences, team, disk, turns):
    """Return, level by level, the (nodes,) times of all captures; those of the last are f_s."""
    return [times for times, *_ in _captures(sequences, _Paths(team, turns), disk)]


def times_and_gradients(sequences, team, disk, turns):
    """Return the (N!,) times f_s and their (N!, N) derivatives by the turns."""
    paths, n = _Paths(team, turns), sequences.count
    time_slopes, place_slopes = np.zeros((1, n)), np.zeros((1, n, 2))
    for level, (times, velocities, normals) in enumerate(_captures(sequences, paths, disk)):
        parents, i = sequences.parents[level], sequences.evaders[level]
        time_slopes, place_slopes = time_slopes[parents], place_slopes[parents]
        nodes, swings = np.arange(len(i)), paths.swings(i, times)
        # |P_k - P_{k-1}| - v_p (T_k - T_{k-1}) - r_k = 0, differentiated.
        along = np.einsum("sjx,sx->sj", place_slopes, normals)
        time_slopes = disk.speed * time_slopes - along
        time_slopes[nodes, i] += np.einsum("sx,sx->s", normals, swings)
        time_slopes /= (disk.speed - np.einsum("sx,sx->s", normals, velocities))[:, None]
        place_slopes = velocities[:, None, :] * time_slopes[:, :, None]
        place_slopes[nodes, i] += swings
    return times, time_slopes


def _captures(sequences, paths, disk):
    """Yield the times of each level, the velocities there, and the directions of flight there."""
    places, times = disk.center[None, :], np.zeros(1)
    radius = disk.radius + disk.capture_radius
    for parents, i in zip(sequences.parents, sequences.evaders, strict=True):
        before, start = places[parents], times[parents]
        times = _earliest(paths, i, before, radius, start, disk.speed)
        places = paths.places(i, times)
        ways = places - before
        lengths = np.hypot(ways[:, 0], ways[:, 1])
        flown = (lengths > 0.0) & ((times > start) | (lengths >= radius))
        normals = np.where(flown[:, None], ways / np.where(flown, lengths, 1.0)[:, None], 0.0)
        yield times, paths.velocities(i, times), normals
        radius = 2.0 * disk.capture_radius


class _Paths:
    """Where the evaders are (eq. 5): a turn at the full rate, which is finite, then straight."""

    def __init__(self, team, turns):
        self.starts, self.headings, self.speeds = team.positions, team.headings, team.speeds
        self.rates, self.goals = np.copysign(team.turn_rates, turns), team.headings + turns
        self.ends = np.abs(turns) / team.turn_rates
        self.directions = np.column_stack([np.cos(self.goals), np.sin(self.goals)])
        self.corners = self._turning(np.arange(len(turns)), self.ends)

    def _turning(self, i, times):
        half = 0.5 * self.rates[i] * times
        chords = self.speeds[i] * times * np.sinc(half / math.pi)
        bearings = self.headings[i] + half
        ways = np.column_stack([np.cos(bearings), np.sin(bearings)])
        return self.starts[i] + chords[:, None] * ways

    def places(self, i, times):
        straight = times - self.ends[i]
        places = self.corners[i] + (self.speeds[i] * straight)[:, None] * self.directions[i]
        turning = np.flatnonzero(straight < 0.0)
        if len(turning):
            places[turning] = self._turning(i[turning], times[turning])
        return places

    def velocities(self, i, times):
        velocities = self.speeds[i][:, None] * self.directions[i]
        turning = np.flatnonzero(times < self.ends[i])
        if len(turning):
            k = i[turning]
            headings = self.headings[k] + self.rates[k] * times[turning]
            ways = np.column_stack([np.cos(headings), np.sin(headings)])
            velocities[turning] = self.speeds[k][:, None] * ways
        return velocities

    def swings(self, i, times):
        """Return how places move with the turn: across the heading, with the distance flown."""
        flown = self.speeds[i] * np.maximum(times - self.ends[i], 0.0)
        across = np.column_stack([-self.directions[i, 1], self.directions[i, 0]])
        return flown[:, None] * across


def _earliest(paths, i, centers, radius, start, pursuer_speed):
    """`mincap` for many at once: eq. (7), closed form after the turn, Newton's method in it."""
    velocities = paths.speeds[i][:, None] * paths.directions[i]
    gaps = paths.corners[i] + (start - paths.ends[i])[:, None] * velocities - centers
    b = np.einsum("sx,sx->s", gaps, velocities) - pursuer_speed * radius
    closing = pursuer_speed**2 - paths.speeds[i] ** 2
    outside = np.einsum("sx,sx->s", gaps, gaps) - radius**2
    times = start + (b + np.sqrt(b * b + np.maximum(outside, 0.0) * closing)) / closing
    times = np.where(outside > 0.0, times, start)
    turning = np.flatnonzero(times < paths.ends[i])
    if len(turning):
        times[turning] = _earliest_in_turn(
            paths, i[turning], centers[turning], radius, start[turning], pursuer_speed
        )
    return times


def _earliest_in_turn(paths, i, centers, radius, start, pursuer_speed):
    low, high, times = start.copy(), np.maximum(paths.ends[i], start), start.copy()
    for _ in range(_MOST_STEPS):
        ways = paths.places(i, times) - centers
        lengths = np.hypot(ways[:, 0], ways[:, 1])
        gaps = lengths - radius - pursuer_speed * (times - start)
        low, high = np.where(gaps > 0.0, times, low), np.where(gaps > 0.0, high, times)
        away = np.einsum("sx,sx->s", ways, paths.velocities(i, times))
        slopes = pursuer_speed - away / np.where(lengths > 0.0, lengths, 1.0)
        closer = np.clip(times + gaps / slopes, low, high)
        if np.abs(closer - times).max() <= 1e-15 * closer.max():
            break
        times = closer
    return times
