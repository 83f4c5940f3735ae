"""From the tables of a file without mistakes to the values that a game is played with."""

from __future__ import annotations

import math

import numpy as np

from covey.model import PursuerDisk, Team
from covey.scenarios.scenario import Scenario
from covey.scenarios.schema import EvaderSection, RandomSection, ScenarioFile, TeamSection
from covey.scenarios.values import AWAY

Point = tuple[float, float]


def build(file: ScenarioFile, seed: int | None = None) -> Scenario:
    """Make the scenario; `seed` replaces the seed of the file."""
    chosen = file.game.seed if seed is None else seed
    pursuer = file.pursuer
    return Scenario(
        team=_team(file.team, pursuer.center, chosen),
        disk=PursuerDisk(pursuer.center, pursuer.radius, pursuer.speed, pursuer.capture_radius),
        evaders=file.team.strategy,
        pursuer=pursuer.strategy,
        sensing=file.game.sensing,
        update_time=file.game.update_time,
        seed=chosen,
        time_limit=file.game.time_limit,
        objective=file.game.objective,
    )


def _team(section: TeamSection, center: Point, seed: int) -> Team:
    evaders = list(section.evaders)
    if section.random is not None:
        evaders = _random_evaders(section.random, center, seed)
    return Team(
        [evader.position for evader in evaders],
        [_heading(evader, section, center) for evader in evaders],
        [section.speed if evader.speed is None else evader.speed for evader in evaders],
        [section.turn_rate if evader.turn_rate is None else evader.turn_rate for evader in evaders],
    )


def _heading(evader: EvaderSection, section: TeamSection, center: Point) -> float:
    heading = section.headings if evader.heading is None else evader.heading
    if heading == AWAY:
        x, y = evader.position
        return math.atan2(y - center[1], x - center[0])
    return float(heading)


def _random_evaders(section: RandomSection, center: Point, seed: int) -> list[EvaderSection]:
    """Place evaders as section V.B of the paper does: uniformly in a square."""
    generator = np.random.default_rng(seed if section.seed is None else section.seed)
    offsets = generator.uniform(-section.side / 2, section.side / 2, (section.count, 2))
    positions = (offsets + np.array(center)).tolist()
    return [EvaderSection.model_construct(position=(x, y)) for x, y in positions]
