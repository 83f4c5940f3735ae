"""Games of the covey set, and scores on them: tables on the screen, JSON for programs."""

from __future__ import annotations

from statistics import fmean
from typing import Any

import covey
from covey import instances
from covey.cli.show.tables import new_console, new_table, number


def print_instances(chosen: list[covey.Instance]) -> None:
    """Print a line for each game."""
    table = new_table("game", "evaders", "guaranteed", "exact", "lower bound", "upper bound")
    table.columns[0].justify = "left"
    for each in chosen:
        plan, bracket, unit = each.plan, each.bracket, each.team.units.time
        table.add_row(
            each.name,
            str(len(each.team)),
            number(plan.survival_time, unit),
            "yes" if plan.exact else "no",
            number(bracket.lower, unit),
            number(bracket.upper, unit),
        )
    new_console().print(table)


def instance_as_json(instance: covey.Instance) -> dict[str, Any]:
    """Return the state of a game and what is known about it."""
    team, disk, plan, bracket = instance.parts()
    return {
        "name": instance.name,
        "unit": team.unit,
        "pursuer": {
            "center": disk.center.tolist(),
            "radius": disk.radius,
            "speed": disk.speed,
            "capture_radius": disk.capture_radius,
        },
        "evaders": {
            "positions": team.positions.tolist(),
            "headings": team.headings.tolist(),
            "speeds": team.speeds.tolist(),
            "turn_rates": team.turn_rates.tolist(),
        },
        "plan": {
            "survival_time": plan.survival_time,
            "exact": plan.exact,
            "upper": plan.upper,
            "worst_sequence": list(plan.worst_sequence),
            "turns": plan.turns.tolist(),
            "goal_headings": plan.goal_headings.tolist(),
        },
        "bracket": {
            **vars(bracket),
            "sequence": list(bracket.sequence),
            "start": bracket.start.tolist(),
        },
    }


def print_scores(scores: dict[str, list[instances.Score]]) -> None:
    """Print for each game the least share of each strategy, then their mean and the least one."""
    least = {name: _least_shares(each) for name, each in scores.items()}
    table = new_table("game", *least)
    table.columns[0].justify = "left"
    for column in table.columns[1:]:  # where the heads are too wide, they take several lines
        column.no_wrap, column.overflow = False, "fold"
    for game in next(iter(least.values())):
        table.add_row(game, *(f"{shares[game]:.3f}" for shares in least.values()))
    table.add_section()
    table.add_row("mean", *(f"{fmean(shares.values()):.3f}" for shares in least.values()))
    table.add_row("least", *(f"{min(shares.values()):.3f}" for shares in least.values()))
    console = new_console()
    console.print(
        "survival time over what the best plan known guarantees, the least of four games:"
    )
    console.print(table)


def _least_shares(scores: list[instances.Score]) -> dict[str, float]:
    """Return the least share in each game, in the order in which the games were played."""
    least: dict[str, float] = {}
    for each in scores:
        least[each.instance] = min(each.share, least.get(each.instance, each.share))
    return least
