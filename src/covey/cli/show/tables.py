"""Plans, games and worst cases on the screen: a few lines and a table."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table

import covey
from covey.model.units import Units, counted, titled, with_unit

_MOST_SEQUENCES = 6


def print_plan(scenario: covey.Scenario, plan: covey.Plan, bracket: covey.Bracket | None) -> None:
    """Print a plan's value, the bound on any team's value if it is known, and all headings."""
    console, units = new_console(), scenario.team.units
    if bracket is not None:
        console.print(
            f"survives at least {number(bracket.lower, units.time)}; "
            f"no team could be sure of more than {number(bracket.upper, units.time)}"
        )
    cost = f"{counted(plan.starts, 'start')}, {counted(plan.steps, 'step')}"
    facts = [
        *_objective(plan.objective.describe(), number(plan.value, units.time), ""),
        ("guaranteed survival time", number(plan.survival_time, units.time)),
        *_sequences(plan),
        ("search", f"{plan.status} ({cost})"),
    ]
    console.print(new_facts(facts))
    table = new_plan_table(units)
    for i, position in enumerate(points(scenario.team.positions.tolist())):
        table.add_row(
            str(i),
            position,
            *angle(float(plan.turns[i])),
            *angle(float(plan.goal_headings[i])),
        )
    console.print(table)


def print_game(game: covey.Game) -> None:
    """Print what was guaranteed, how long the team survived, and its captures."""
    console = new_console()
    console.print(new_facts(_outcome(game)))
    console.print(_capture_table(game))


def print_worst_case(scenario: covey.Scenario, worst: covey.WorstCase) -> None:
    """Print the least survival time, over which pursuers it was taken, and its captures."""
    console, time_unit = new_console(), scenario.team.units.time
    quantity = "survival time" if worst.value == worst.survival_time else "sum of survival times"
    console.print(
        new_facts(
            [
                (f"least {quantity}", number(worst.value, time_unit)),
                ("over", str(worst.scope)),
                ("played", f"{counted(worst.flights, 'flight')} from one capture to the next"),
            ]
        )
    )
    table = new_table("capture", "evader", *(titled(t, time_unit) for t in ("time", "waited")))
    rows = zip(worst.sequence, aligned(worst.capture_times, 6), worst.delays, strict=True)
    for k, (evader, time, delay) in enumerate(rows, start=1):
        table.add_row(str(k), str(evader), time, number(delay))
    console.print(table)


def _outcome(game: covey.Game) -> list[tuple[str, str]]:
    """Return the facts of a game, by their names."""
    time_unit, guaranteed = game.team.units.time, game.objective["name"] == "last-capture"
    survived = number(game.survival_time, time_unit)
    if math.isinf(game.survival_time):
        survived = f"more than {number(float(game.times[-1]), time_unit)}: {game.status}"
    elif game.guarantee > 0.0 and guaranteed:
        survived += f"  ({game.survival_time / game.guarantee:.2f} times the guarantee)"
    return [
        ("pursuer", f"{game.sensing}, {_strategy(game, 'pursuer')}"),
        ("evaders", f"{len(game.team)}, {_strategy(game, 'evaders')}"),
        *_objective(
            game.objective, number(game.planned_value, time_unit), number(game.value, time_unit)
        ),
        *([("guaranteed survival time", number(game.guarantee, time_unit))] if guaranteed else []),
        ("survival time", survived),
    ]


def _objective(objective: Mapping[str, Any], planned: str, value: str) -> list[tuple[str, str]]:
    """Return the planned value of an objective, and a game's; nothing for the last capture."""
    if objective["name"] == "last-capture":
        return []
    expected = objective["name"] == "expected-survival"
    words = "last capture" if objective.get("measure") == "last" else "sum of survival times"
    facts = [(f"{'expected' if expected else 'guaranteed'} {words}", planned)]
    return [*facts, (words, value)] if value else facts


def _capture_table(game: covey.Game) -> Table:
    """Return the captures in their order: who, when, where."""
    units = game.team.units
    table = new_table(
        "capture", "evader", titled("time", units.time), titled("place", units.length)
    )
    order = game.capture_sequence.tolist()
    times = aligned(game.capture_times.tolist(), 6)
    # A captured evader stays where it was captured.
    positions = points(game.evader_positions[-1, order].tolist())
    for k, (i, time, position) in enumerate(zip(order, times, positions, strict=True), start=1):
        table.add_row(str(k), str(i), time, position)
    return table


def number(value: float, unit: str = "") -> str:
    """Write a number as a person reads it, with its unit; `--json` has all digits."""
    return with_unit(f"{value:.6g}", unit)


def angle(radians: float) -> tuple[str, str]:
    """Write an angle in radians and in degrees."""
    return f"{radians:+.4f}", f"{math.degrees(radians):+.1f}"


def aligned(values: Sequence[float], digits: int) -> list[str]:
    """Write numbers with the same decimals, which give the largest one `digits` digits."""
    largest = max((abs(value) for value in values), default=0.0)
    before_point = math.floor(math.log10(largest)) + 1 if largest > 0.0 else 1
    decimals = max(0, digits - before_point)
    return [f"{value:.{decimals}f}" for value in values]


def points(positions: Sequence[Sequence[float]]) -> list[str]:
    """Write points, x under x and y under y."""
    texts = aligned([coordinate for position in positions for coordinate in position], 4)
    columns = texts[::2], texts[1::2]
    widths = [max((len(text) for text in column), default=0) for column in columns]
    return [f"({x:>{widths[0]}}, {y:>{widths[1]}})" for x, y in zip(*columns, strict=True)]


def _sequences(plan: covey.Plan) -> list[tuple[str, str]]:
    sequences = plan.critical_sequences
    expected = isinstance(plan.objective, covey.ExpectedSurvival)
    name = "sequences" if expected else "critical sequences"
    shown = [" ".join(map(str, sequence)) for sequence in sequences[:_MOST_SEQUENCES]]
    if len(sequences) > _MOST_SEQUENCES:
        shown.append(f"and {len(sequences) - _MOST_SEQUENCES} more")
    return [("" if k else name, text) for k, text in enumerate(shown)]


def _strategy(game: covey.Game, side: str) -> str:
    strategy = dict(game.strategies[side])
    name = str(strategy.pop("name"))
    parameters = ", ".join(f"{key} {value}" for key, value in strategy.items())
    return f"{name} ({parameters})" if parameters else name


def new_facts(facts: Iterable[tuple[str, str]]) -> Table:
    """Return facts under each other, each beside its name."""
    table = Table.grid(padding=(0, 2))
    for name, value in facts:
        table.add_row(name, value)
    return table


def new_table(*columns: str) -> Table:
    """Return an empty table with these columns."""
    table = Table(box=SIMPLE_HEAD, pad_edge=False)
    for column in columns:
        table.add_column(column, justify="right", no_wrap=True)
    return table


def new_plan_table(units: Units) -> Table:
    """Return an empty table of evaders, with where each one is and how it turns."""
    position = titled("position", units.length)
    return new_table("evader", position, "turn (rad)", "(°)", "goal heading (rad)", "(°)")


def new_console() -> Console:
    """Return where results are printed."""
    return Console(highlight=False)
