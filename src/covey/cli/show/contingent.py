"""Contingent plans on the screen and as JSON."""

from __future__ import annotations

from typing import Any

import covey
from covey.cli.show.tables import (
    aligned,
    angle,
    new_console,
    new_facts,
    new_plan_table,
    new_table,
    number,
    points,
)
from covey.model.units import counted, titled


def print_tree(
    scenario: covey.Scenario, tree: covey.ContingentPlan, bracket: covey.Bracket
) -> None:
    """Print what a contingent plan guarantees, the turns now, and those after each capture."""
    console, open_loop, units = new_console(), bracket.plan.survival_time, scenario.team.units
    gain = 100.0 * (tree.survival_time / open_loop - 1.0)
    critical, with_delays = tree.critical_sequences, tree.with_delays.survival_time
    cost = f"{counted(tree.starts, 'ascent')}, {counted(tree.steps, 'step')}"
    leaving = f"{counted(len(tree.evaders) - 1, 'capture')} after which somebody lives"
    alone = len(tree.evaders) == 1
    answers = (
        "none, as the only capture is the last" if alone else f"the first {tree.depth} of {leaving}"
    )
    facts = [
        ("guaranteed survival time", number(tree.survival_time, units.time)),
        ("if captures are put off", f"{number(with_delays, units.time)} at least"),
        ("without answers", f"{number(open_loop, units.time)}; the answers gain {gain:.3g} %"),
        ("no team could be sure of", f"more than {number(bracket.upper, units.time)}"),
        ("answers", answers),
        ("worst sequence", " ".join(map(str, critical[0]))),
        ("search", f"{tree.status} ({cost})"),
    ]
    console.print(new_facts(facts))
    table = new_plan_table(units)
    for i, position in enumerate(points(scenario.team.positions.tolist())):
        turn, goal = float(tree.turns[i]), float(tree.goal_headings[i])
        table.add_row(str(i), position, *angle(turn), *angle(goal))
    console.print(table)
    if len(tree.evaders) > 1:
        console.print("goal headings (°) after the first capture, by who is captured:")
        console.print(_answers(tree))


def _answers(tree: covey.ContingentPlan) -> Any:
    """Return the table of goal headings after each first capture, a row a capture."""
    table = new_table(
        "captured", *(str(i) for i in tree.evaders), titled("then survives", tree.team.units.time)
    )
    branches = [tree.after(i) for i in tree.evaders]
    times = aligned([each.survival_time for each in branches], 6)
    for i, after, time in zip(tree.evaders, branches, times, strict=True):
        headings = dict(zip(after.evaders, after.goal_headings.tolist(), strict=True))
        cells = [angle(headings[j])[1] if j in headings else "-" for j in tree.evaders]
        table.add_row(str(i), *cells, time)
    return table


def tree_as_json(
    scenario: covey.Scenario, tree: covey.ContingentPlan, bracket: covey.Bracket
) -> dict[str, Any]:
    """Return a contingent plan with all its answers, angles in radians."""
    return {
        "survival_time": tree.survival_time,
        "with_delays": tree.with_delays.survival_time,
        "resolution": tree.with_delays.resolution,
        "open_loop_survival_time": bracket.plan.survival_time,
        "upper_bound": bracket.upper,
        "depth": tree.depth,
        "critical_sequences": [list(sequence) for sequence in tree.critical_sequences],
        "status": str(tree.status),
        "starts": tree.starts,
        "steps": tree.steps,
        "seed": scenario.seed,
        "unit": scenario.team.unit,
        **_node(tree),
    }


def _node(tree: covey.ContingentPlan) -> dict[str, Any]:
    """Return the turns of a node, and of those that answer each capture after it."""
    node: dict[str, Any] = {
        "evaders": list(tree.evaders),
        "turns": tree.turns.tolist(),
        "goal_headings": tree.goal_headings.tolist(),
    }
    if tree.depth > 0:
        node["after"] = {str(i): _node(tree.after(i)) for i in tree.evaders}
    return node
