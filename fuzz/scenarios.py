"""Scenario files: what loads can be planned, bracketed and played."""

from __future__ import annotations

import covey
from covey.model.validation import LARGEST
from covey.scenarios import example_names, example_path
from covey.scenarios.schema import ScenarioFile
from fuzz.oracle import refusal, require, require_game, require_plan
from fuzz.target import Target, corpus
from fuzz.toml_files import file_with, toml_cases

MOST_EVADERS = 6
"""Larger teams are loaded only: their plans take long by right."""


def check(content):
    """Load a scenario; play its first updates."""
    with file_with(content, ".toml") as file:
        try:
            scenario = covey.load_scenario(file)
        except covey.InputError as error:
            return refusal(error)
    team, disk = scenario.team, scenario.disk
    require((team.speeds < disk.speed).all(), "an evader as fast as the pursuer")
    if len(team) > MOST_EVADERS or _searches(scenario.evaders) > 50:
        return "loaded"
    plan = covey.plan(team, disk, objective=scenario.objective, seed=scenario.seed, starts=2)
    require_plan(team, disk, plan)
    game = covey.simulate(
        team,
        disk,
        evaders=scenario.evaders,
        pursuer=scenario.pursuer,
        sensing=scenario.sensing,
        update_time=scenario.update_time,
        seed=scenario.seed,
        time_limit=min(3.0 * scenario.update_time, LARGEST),
        objective=scenario.objective,
    )
    require_game(game)
    return f"played: {game.status.name}"


def _searches(strategy):
    """Return how many ascents a plan of this strategy may take."""
    return max(getattr(strategy, "starts", 1), getattr(strategy, "restarts", 1))


FILES = [*map(example_path, example_names()), *corpus("scenarios")]
TARGET = Target("scenarios", ".toml", toml_cases(FILES, ScenarioFile), check)
