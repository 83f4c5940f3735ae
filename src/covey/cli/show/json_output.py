"""Plans and games as JSON, for programs that read what `covey` prints."""

from __future__ import annotations

import json
import math
from dataclasses import asdict
from typing import Any, NamedTuple

from covey.bounds import Bracket
from covey.planning import Plan
from covey.players import WorstCase
from covey.scenarios import Scenario
from covey.simulation import Game


class Capture(NamedTuple):
    """Who was captured, when, and where."""

    evader: int
    time: float
    place: list[float]


def plan_as_json(scenario: Scenario, plan: Plan, bracket: Bracket | None) -> dict[str, Any]:
    """Return a plan, angles in radians, and a bound on what any team can be sure of."""
    bound: dict[str, Any] = {}
    if bracket is not None:
        bound = {"upper_bound": bracket.upper, "announced_sequence": list(bracket.sequence)}
    return {
        "survival_time": plan.survival_time,
        **bound,
        "objective": plan.objective.describe(),
        "value": plan.value,
        "turns": plan.turns.tolist(),
        "goal_headings": plan.goal_headings.tolist(),
        "critical_sequences": [list(sequence) for sequence in plan.critical_sequences],
        "status": str(plan.status),
        "starts": plan.starts,
        "steps": plan.steps,
        "interceptions": plan.interceptions,
        "seed": scenario.seed,
    }


def game_as_json(game: Game) -> dict[str, Any]:
    """Return what happened in a game."""
    return {
        "guarantee": game.guarantee,
        "survival_time": game.survival_time,
        "objective": dict(game.objective),
        "planned_value": game.planned_value,
        "value": game.value,
        "status": str(game.status),
        "captures": [capture._asdict() for capture in captures(game)],
        "sensing": game.sensing,
        "update_time": game.update_time,
        "seed": game.seed,
        "strategies": {side: dict(strategy) for side, strategy in game.strategies.items()},
    }


def worst_case_as_json(worst: WorstCase) -> dict[str, Any]:
    """Return the worst case, and over which pursuers it was taken."""
    return {**asdict(worst), "scope": str(worst.scope)}


def captures(game: Game) -> list[Capture]:
    """Return the captures in their order."""
    order = game.capture_sequence.tolist()
    # A captured evader stays where it was captured.
    places = game.evader_positions[-1, order].tolist()
    return list(map(Capture, order, game.capture_times.tolist(), places))


def print_json(report: dict[str, Any]) -> None:
    """Print a report, to the last digit."""
    print(json.dumps(_strict(report), indent=2, allow_nan=False))


def _strict(value: Any) -> Any:
    """Replace infinity, which JSON doesn't know, by None."""
    if isinstance(value, float) and not math.isfinite(value):
        return None
    if isinstance(value, dict):
        return {key: _strict(part) for key, part in value.items()}
    if isinstance(value, list | tuple):
        return [_strict(part) for part in value]
    return value
