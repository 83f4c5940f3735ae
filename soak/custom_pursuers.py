"""Pursuers that don't come with the package: each is made from a seed, for one game."""

from __future__ import annotations

import math

import numpy as np

import covey

HESITATION = 2.0
"""Time after which even the pursuers that dawdle go hunting, so that games end."""


def redrawing(seed):
    """Draws a new sequence at every decision."""
    generator = np.random.default_rng(seed)
    return lambda situation: covey.Chase(tuple(generator.permutation(situation.evaders)))


def nearest_first(seed):
    """Makes for whoever is nearest just now."""

    def decide(situation):
        off = situation.team.positions - situation.disk.center
        return covey.Chase((situation.evaders[np.hypot(off[:, 0], off[:, 1]).argmin()],))

    return decide


def farthest_first(seed):
    """Makes for whoever is farthest, and declines all captures on the way."""

    def decide(situation):
        off = situation.team.positions - situation.disk.center
        return covey.Chase((situation.evaders[np.hypot(off[:, 0], off[:, 1]).argmax()],))

    return decide


def waiting(seed, hesitation=HESITATION):
    """Waits every other time, while its disk grows over evaders that it doesn't take."""
    generator = np.random.default_rng(seed)

    def decide(situation):
        if situation.time < hesitation and generator.random() < 0.5:
            return covey.Fly()
        return covey.Chase(tuple(sorted(situation.evaders)))

    return decide


def roaming(seed, hesitation=HESITATION):
    """Flies about at random speeds and in random directions, then chases at random."""
    generator = np.random.default_rng(seed)

    def decide(situation):
        if situation.time < hesitation:
            speed = situation.disk.speed * generator.choice([0.5, 1.0])
            angle = generator.uniform(-math.pi, math.pi)
            return covey.Fly((speed * math.cos(angle), speed * math.sin(angle)))
        return covey.Chase(tuple(generator.permutation(situation.evaders)))

    return decide


def in_numerical_order(seed):
    """Captures by the evaders' numbers."""
    return lambda situation: covey.Chase(tuple(sorted(situation.evaders)))


class Unseen:
    """Roams like `roaming`, but hidden, from a place at the edge of the disk."""

    def __init__(self, seed=0, hesitation=HESITATION):
        self.seed, self.hesitation = seed, hesitation

    def start(self, seed):
        return roaming(self.seed, self.hesitation)

    def place(self, disk):
        return disk.center + disk.radius * np.array([math.cos(self.seed), math.sin(self.seed)])


class Steered:
    """Is at the disk's centre and goes from there, hidden or not, as a function says."""

    def __init__(self, decide):
        self.decide = decide

    def start(self, seed):
        return self.decide

    def place(self, disk):
        return disk.center
