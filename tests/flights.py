"""Flights of turn-limited evaders, step by step, and a pursuer that follows them."""

from __future__ import annotations

import numpy as np

STEPS = 64


def random_flight(team, time, generator):
    """Positions (STEPS + 1, N, 2) of evaders that turn at random, up to their rate."""
    kept = generator.integers(1, STEPS)  # steps for which a rate is kept
    rates = generator.uniform(-1.0, 1.0, (STEPS // kept + 1, len(team))).round()
    places, headings = [team.positions], team.headings
    for step in range(STEPS):
        turns = rates[step // kept] * np.minimum(team.turn_rates * (time / STEPS), np.pi)
        place, headings = fly(places[-1], headings, team, turns, time / STEPS)
        places.append(place)
    return np.array(places)


def fly(positions, headings, team, turns, time):
    """The positions and headings after turns at the full rate, and straight flight from then on."""
    with np.errstate(divide="ignore", invalid="ignore"):
        turning = np.where(turns == 0.0, 0.0, np.abs(turns) / team.turn_rates)
    chords = team.speeds * turning * np.sinc(turns / (2.0 * np.pi))
    straight = team.speeds * (time - turning)
    ends = headings + turns
    moved = chords * _unit(headings + 0.5 * turns) + straight * _unit(ends)
    return positions + moved.T, ends


def _unit(angles):
    return np.array([np.cos(angles), np.sin(angles)])


class ConstantBearing:
    """A pursuer that holds the line of sight to each evader of a sequence at a constant bearing.

    Between two calls the evaders fly straight; an evader counts as captured when it is met, the
    last one within `reach`. `captures` are the times of the captures so far.
    """

    def __init__(self, place, speed, sequence, reach=0.0):
        self.place, self.speed, self.left, self.reach = place, speed, list(sequence), reach
        self.time, self.captures = 0.0, []

    def follow(self, start, end, duration):
        """Fly while the evaders go from `start` to `end`, each (N, 2)."""
        flown = 0.0
        while self.left and flown < 1.0:
            target = self.left[0]
            here = start[target] + flown * (end[target] - start[target])
            rest = (1.0 - flown) * duration
            met = self._meeting(here, (end[target] - here) / rest)
            if met > rest:
                self.place = end[target] - self._remaining(here, end[target], rest)
                break
            self.place = here + met / rest * (end[target] - here)
            flown += met / duration
            self.captures.append(self.time + flown * duration)
            self.left.pop(0)
        self.time += duration if self.left else flown * duration

    def _meeting(self, place, velocity):
        """The time until an evader of constant velocity is met, or within reach if it is last."""
        reach = self.reach if len(self.left) == 1 else 0.0
        off = place - self.place
        if np.hypot(*off) <= reach:
            return 0.0
        # |off + velocity t| = reach + speed t
        closing = self.speed**2 - velocity @ velocity
        half = off @ velocity - reach * self.speed
        return (half + np.sqrt(half**2 + closing * (off @ off - reach**2))) / closing

    def _remaining(self, place, end, duration):
        """The line of sight at the end: a share of the one at the beginning."""
        off, ahead = place - self.place, end - self.place
        # |ahead - share off| = speed duration, share < 1
        a, b = off @ off, ahead @ off
        c = ahead @ ahead - (self.speed * duration) ** 2
        return (b - np.sqrt(max(b * b - a * c, 0.0))) / a * off
