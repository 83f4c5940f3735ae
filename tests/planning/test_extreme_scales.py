"""No promise is broken by more than 1e-9, wherever a game is, however large, however fast."""

import itertools

import numpy as np
import pytest

import covey
from random_games import random_game

SPEEDS = np.array([0.0, 1e-6, 0.5, 0.99, 0.999999])  # over the pursuer's
TURN_RATES = np.array([0.0, 1e-9, 1.0, 50.0, np.inf])  # radians, while the pursuer crosses the team
PLACES = [(0.0, 0.0), (1e5, -3e5), (2e7, 7e7)]  # in sizes of the team


def extreme_game(generator, size, place, pursuer_speed):
    count = int(generator.integers(1, 6))
    distances = size * 10.0 ** generator.uniform(-4.5, 0.0, (count, 1))
    center = size * np.array(place)
    team = covey.Team(
        center + distances * generator.uniform(-1.0, 1.0, (count, 2)),
        generator.uniform(-3.0, 3.0, count),
        pursuer_speed * generator.choice(SPEEDS, count),
        generator.choice(TURN_RATES, count) * pursuer_speed / size,
    )
    radius, reach = size * generator.choice([0.0, 1e-6, 1.0], 2)
    return team, covey.PursuerDisk(center, radius, pursuer_speed, 1e-3 * reach)


def shortfalls(team, disk, sensing):
    """Return by how much a game, and promises on the way, fall short of the first, relative."""
    planned = covey.plan(team, disk, starts=2).survival_time
    if planned == 0.0:
        return [0.0]
    evaders = covey.IterativeOpenLoop(starts=2, restarts=1)
    game = covey.simulate(team, disk, evaders=evaders, sensing=sensing, update_time=0.05 * planned)
    promised = game.times + game.guarantees
    return [1.0 - game.survival_time / planned, *(1.0 - promised[1:] / promised[:-1])]


@pytest.mark.parametrize("place", PLACES, ids=str)
@pytest.mark.parametrize("size", [1e-9, 1.0, 1e9])
def test_no_promise_is_broken(size, place):
    generator = np.random.default_rng(0)
    for _, sensing in itertools.product(range(15), ["hidden", "visible"]):
        speed = 10.0 ** generator.uniform(-3.0, 3.0)
        game = extreme_game(generator, size, place, speed)
        assert max(shortfalls(*game, sensing)) <= 1e-9


@pytest.mark.parametrize("by", [np.array([1e5, 1e5]), np.array([-2e7, 3e6])])
def test_a_guarantee_does_not_depend_on_where_the_origin_is(by):
    """Grid points, so that the positions themselves are moved without rounding."""
    generator = np.random.default_rng(1)
    for _ in range(20):
        team, disk = random_game(generator, 4, radius=0.125)
        team = covey.Team(np.round(team.positions * 64.0) / 64.0, team.headings)
        there = (
            covey.Team(team.positions + by, team.headings),
            covey.PursuerDisk(disk.center + by, disk.radius),
        )
        turns = generator.uniform(-3.0, 3.0, 4)
        here = covey.guaranteed_survival(team, disk, turns)
        assert here == covey.guaranteed_survival(*there, turns)
        assert covey.plan(*there, starts=4).value == covey.plan(team, disk, starts=4).value


def test_strategies_of_ones_own_see_their_own_coordinates():
    seen = []

    def evaders(situation):
        seen.append((situation.team.positions[0], situation.disk.center))
        return np.zeros(len(situation.evaders))

    by = np.array([3.0, -2.0])
    team, disk = covey.Team([[4.0, -2.0]], [0.0]), covey.PursuerDisk(by)
    game = covey.simulate(team, disk, evaders=evaders, pursuer=covey.CommittedPursuer())
    assert np.array_equal(seen[0], (team.positions[0], by))
    assert np.allclose([position for position, _ in seen], game.evader_positions[: len(seen), 0])
