"""Plays against a plan that answers captures, each capture put off, flown by the book."""

from __future__ import annotations

import functools

import numpy as np

from soak.reference_flight import fly

HALVINGS = 80
"""Of the interval in which an interception is sought: more than a float has digits."""


def ends(tree, sequences, delays):
    """Last captures (K,) of plays in orders `sequences` (K, n), with `delays` (K, n) of captures.

    After a capture those left begin the turns of the plan that answers it, from where they are.
    """
    team, disk, plays = tree.team, tree.disk, np.arange(len(sequences))
    places, headings, turns = (
        np.tile(each, (len(plays), *np.ones(each.ndim, int)))
        for each in (team.positions, team.headings, tree.turns)
    )
    center, radius = np.tile(disk.center, (len(plays), 1)), disk.radius + disk.capture_radius
    answer, now = functools.cache(lambda captured: _answer(tree, captured)), np.zeros(len(plays))
    for k in range(len(team)):
        i = sequences[:, k]
        one = places[plays, i], headings[plays, i], team.speeds[i], team.turn_rates[i]
        waited = _interception(*one, turns[plays, i], center, radius, disk.speed) + delays[:, k]
        now += waited
        places, goals = fly(
            places, headings, team.speeds, team.turn_rates, turns, waited[:, np.newaxis]
        )
        turns, headings = turns - (goals - headings), goals
        center, radius = places[plays, i], 2.0 * disk.capture_radius
        if k < tree.depth:
            turns = np.array([answer(tuple(row)) for row in sequences[:, : k + 1].tolist()])
    return now


def _answer(tree, captured):
    """The turns (n,) that answer these captures; of the captured 0."""
    turns = np.zeros(len(tree.evaders))
    for i in captured:
        tree = tree.after(i)
    turns[list(tree.evaders)] = tree.turns
    return turns


def _interception(places, headings, speeds, turn_rates, turns, center, radius, speed):
    """When a disk that grows at `speed` reaches each of (K,) evaders, by halving an interval."""
    distance = np.hypot(*(places - center).T)
    low, high = np.zeros(len(places)), distance / (speed - speeds)
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        there, _ = fly(places, headings, speeds, turn_rates, turns, middle)
        reached = np.hypot(*(there - center).T) <= radius + speed * middle
        low, high = np.where(reached, low, middle), np.where(reached, middle, high)
    return high
