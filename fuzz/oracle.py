"""What must hold, whatever the input: one short message, or a result that keeps its promises."""

from __future__ import annotations

import math

import numpy as np

import covey

LONGEST_MESSAGE = 4000
"""Characters: what a screen shows."""
ROUNDING = 1e-6
"""Relative. The largest that the rounding of nearly equal speeds makes of a time."""


class FindingError(AssertionError):
    """A promise that wasn't kept."""


def require(holds, text):
    """Raise FindingError unless a promise is kept."""
    if not holds:
        raise FindingError(text)


def refusal(error):
    """Return the text of a documented error, if it is short."""
    text = str(error)
    require(len(text) <= LONGEST_MESSAGE, f"a message of {len(text)} characters: {text[:200]}...")
    return text


def require_finite(name, *values):
    """Raise FindingError if a number is nan or infinite."""
    for value in values:
        require(np.isfinite(value).all(), f"{name}: not finite: {value}")


def require_plan(team, disk, plan):
    """Raise FindingError unless a plan is legal and worth what it says."""
    n = len(team)
    require_finite("plan", plan.turns, plan.goal_headings, plan.survival_time, plan.value)
    require(plan.turns.shape == (n,) == plan.goal_headings.shape, "plan: shape")
    require((np.abs(plan.turns) <= math.pi).all(), f"plan: turns {plan.turns}")
    require(plan.survival_time >= 0.0, f"plan: survival time {plan.survival_time}")
    everybody = list(range(n))
    require(all(sorted(s) == everybody for s in plan.critical_sequences), "plan: sequences")
    require(all(weight >= 0.0 for weight in plan.weights), f"plan: weights {plan.weights}")
    again = covey.guaranteed_survival(team, disk, plan.turns)
    require_same("plan: guaranteed again", again.time, plan.survival_time)
    times = covey.capture_times(team, disk, plan.turns, again.sequence)
    require_same("plan: its worst sequence", times[-1], plan.survival_time)


def require_game(game):
    """Raise FindingError unless the course of a game is finite and its promise is kept."""
    require_finite("game: times", game.times, game.capture_times, game.guarantees)
    require_finite("game: evaders", game.evader_positions, game.evader_headings, game.evader_turns)
    require_finite("game: pursuer", game.pursuer_positions, game.disk_centers, game.disk_radii)
    require((np.diff(game.times) >= 0.0).all(), "game: time runs back")
    order = game.capture_sequence.tolist()
    require(len(set(order)) == len(order), f"game: captured twice {order}")
    everybody = len(order) == len(game.team)
    require(math.isfinite(game.survival_time) == everybody, f"game: {game.survival_time}")
    keeps = game.strategies["evaders"]["name"] in ("open-loop", "iterative-open-loop")
    if keeps and game.objective["name"] == "last-capture":
        require_at_least("game: guarantee", game.survival_time, game.guarantee)


def require_same(name, one, other):
    """Raise FindingError unless two times are equal up to rounding."""
    require_at_least(name, one, other)
    require_at_least(name, other, one)


def require_at_least(name, value, least):
    """Raise FindingError if a time is below another by more than rounding."""
    require(value >= least - ROUNDING * abs(least), f"{name}: {value!r} is not >= {least!r}")
