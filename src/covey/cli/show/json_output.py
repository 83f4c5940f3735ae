"""Plans and games as JSON, for programs that read what `covey` prints."""

from __future__ import annotations

import json
import math
from dataclasses import asdict
from typing import Any

import covey


def plan_as_json(
    scenario: covey.Scenario, plan: covey.Plan, bracket: covey.Bracket | None
) -> dict[str, Any]:
    """Return a plan, angles in radians, and a time that no team could be sure to exceed."""
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
        "unit": scenario.team.unit,
    }


def game_as_json(game: covey.Game) -> dict[str, Any]:
    """Return what happened in a game."""
    return {
        "guarantee": game.guarantee,
        "survival_time": game.survival_time,
        "objective": dict(game.objective),
        "planned_value": game.planned_value,
        "value": game.value,
        "status": str(game.status),
        "captures": _captures(game),
        "sensing": game.sensing,
        "update_time": game.update_time,
        "seed": game.seed,
        "unit": game.team.unit,
        "strategies": {side: dict(strategy) for side, strategy in game.strategies.items()},
    }


def worst_case_as_json(worst: covey.WorstCase) -> dict[str, Any]:
    """Return the worst case, and over which pursuers it was taken."""
    return {**asdict(worst), "scope": str(worst.scope)}


def _captures(game: covey.Game) -> list[dict[str, Any]]:
    """Return who was captured, when, and where, in the order of capture."""
    order = game.capture_sequence.tolist()
    # A captured evader stays where it was captured.
    positions = game.evader_positions[-1, order].tolist()
    rows = zip(order, game.capture_times.tolist(), positions, strict=True)
    return [{"evader": evader, "time": time, "place": position} for evader, time, position in rows]


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
