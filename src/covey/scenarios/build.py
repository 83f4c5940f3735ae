"""From the tables of a file without mistakes to the values that a game is played with."""

from __future__ import annotations

import math

import numpy as np

from covey.model import PursuerDisk, Team
from covey.model.team import rates_of_radii
from covey.scenarios.scenario import Scenario
from covey.scenarios.schema import (
    EvaderSection,
    RandomSection,
    ScenarioFile,
    TeamSection,
)
from covey.scenarios.values.kinds import AWAY

Point = tuple[float, float]


def build(file: ScenarioFile, seed: int | None = None) -> Scenario:
    """Make the scenario; `seed` replaces the seed of the file."""
    chosen = file.game.seed if seed is None else seed
    disk = _disk(file)
    return Scenario(
        team=_team(file, disk, chosen),
        disk=disk,
        evaders=file.team.strategy,
        pursuer=file.pursuer.strategy,
        sensing=file.game.sensing,
        update_time=file.game.update_time,
        seed=chosen,
        time_limit=file.game.time_limit,
        objective=file.game.objective,
    )


def _disk(file: ScenarioFile) -> PursuerDisk:
    section, seen = file.pursuer, file.pursuer.last_seen
    speed, reach = section.speed, section.capture_radius
    if seen is None:
        return PursuerDisk(section.center, section.radius, speed, reach, unit=file.unit)
    return PursuerDisk.last_seen(
        seen.position,
        within=seen.within,
        ago=seen.ago,
        speed=speed,
        capture_radius=reach,
        unit=file.unit,
    )


def _team(file: ScenarioFile, disk: PursuerDisk, seed: int) -> Team:
    section, (x, y) = file.team, disk.center.tolist()
    center, evaders = (x, y), list(section.evaders)
    if section.random is not None:
        evaders = _random_evaders(section.random, center, seed)
    speeds = [section.speed if evader.speed is None else evader.speed for evader in evaders]
    return Team(
        [evader.position for evader in evaders],
        [_heading(evader, section, center) for evader in evaders],
        speeds,
        [_turn_rate(*each, section) for each in zip(evaders, speeds, strict=True)],
        unit=file.unit,
    )


def _turn_rate(evader: EvaderSection, speed: float, section: TeamSection) -> float:
    if evader.turn_rate is not None:
        return evader.turn_rate
    radius = section.turn_radius if evader.turn_radius is None else evader.turn_radius
    return section.turn_rate if radius is None else float(rates_of_radii(speed, radius))


def _heading(evader: EvaderSection, section: TeamSection, center: Point) -> float:
    heading = section.heading if evader.heading is None else evader.heading
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
