"""The texts of the two files of a game: numbers with all their digits, which read back exactly."""

from __future__ import annotations

from collections.abc import Iterable

from covey.instances.instance import KnownBracket, KnownPlan
from covey.model import PursuerDisk, Team


def game_text(about: str, team: Team, disk: PursuerDisk) -> str:
    """Return a scenario in which nothing is left to a default."""
    lines = [f"# {about}"]
    if team.unit:
        lines += ["", f'unit = "{team.unit}"']
    lines += [
        "",
        "[pursuer]",
        f"center = {_row(disk.center.tolist())}",
        f"radius = {disk.radius!r}",
        f"speed = {disk.speed!r}",
        f"capture_radius = {disk.capture_radius!r}",
    ]
    for x, y, heading, speed, turn_rate in team.as_rows().tolist():
        lines += [
            "",
            "[[team.evaders]]",
            f"position = {_row([x, y])}",
            f"heading = {heading!r}",
            f"speed = {speed!r}",
            f"turn_rate = {turn_rate!r}",
        ]
    return "\n".join([*lines, ""])


def values_text(name: str, plan: KnownPlan, bracket: KnownBracket) -> str:
    """Return what is known about a game."""
    return "\n".join(
        [
            f"# What is known about the game {name}. Evaders are numbered from 0, in the order of",
            "# the game's file; angles are radians.",
            "",
            "[plan]",
            f"survival_time = {plan.survival_time!r}",
            f"exact = {str(plan.exact).lower()}",
            f"upper = {plan.upper!r}",
            f"worst_sequence = {_row(plan.worst_sequence)}",
            f"turns = {_column(plan.turns.tolist())}",
            f"goal_headings = {_column(plan.goal_headings.tolist())}",
            "",
            "[bracket]",
            f"lower = {bracket.lower!r}",
            f'lower_by = "{bracket.lower_by}"',
            f"depth = {bracket.depth}",
            f"upper = {bracket.upper!r}",
            f'upper_by = "{bracket.upper_by}"',
            f"sequence = {_row(bracket.sequence)}",
            f"start = {_row(bracket.start.tolist())}",
            "",
        ]
    )


def _row(numbers: Iterable[float]) -> str:
    return f"[{', '.join(map(repr, numbers))}]"


def _column(numbers: Iterable[float]) -> str:
    """Write a number a line, so that a change shows which evader's it is."""
    return "\n".join(["[", *(f"    {number!r}," for number in numbers), "]"])
