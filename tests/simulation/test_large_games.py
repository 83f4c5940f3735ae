"""Games of more evaders than have an exact minimum at every row."""

import numpy as np
import pytest

import covey
from random_games import random_game


def slow_team(count):
    """A team and a disk: of slow evaders few sequences are nearly equal, so all takes a moment."""
    team, disk = random_game(np.random.default_rng(4), count)
    slow = covey.Team(team.positions, team.headings, 0.05, team.turn_rates)
    return slow, disk


@pytest.fixture
def game(without_tables):
    team, disk = random_game(np.random.default_rng(6), 7)
    without_tables()
    evaders = covey.IterativeOpenLoop(starts=4, replan_time=0.1)
    return covey.simulate(team, disk, evaders=evaders, update_time=0.02)


def test_a_team_survives_what_its_plan_guarantees(game):
    assert game.status is covey.GameStatus.ALL_CAPTURED
    assert game.survival_time >= game.guarantee


def test_the_guarantee_never_falls_along_the_game(game):
    lasting = game.guarantees + game.times
    assert (np.diff(lasting)[:-1] >= -1e-9).all()


def test_each_row_guarantees_no_more_than_its_worst_sequence_known(game):
    for row in range(0, len(game.times) - 1, 10):
        alive = game.critical_sequences[row][game.critical_sequences[row] >= 0]
        living = np.sort(alive)
        team = covey.Team(
            game.evader_positions[row, living],
            game.evader_headings[row, living],
            game.team.speeds[living],
            game.team.turn_rates[living],
        )
        disk = covey.PursuerDisk(game.disk_centers[row], game.disk_radii[row])
        sequence = np.searchsorted(living, alive)
        times = covey.capture_times(team, disk, game.evader_turns[row, living], sequence)
        assert game.guarantees[row] <= times[-1] * (1 + 1e-9)


def test_a_record_is_read_again(game, tmp_path):
    covey.save_game(game, tmp_path / "game.parquet")
    again = covey.load_game(tmp_path / "game.parquet")
    assert np.array_equal(again.evader_positions, game.evader_positions)


def test_strategies_in_python_play_too():
    team, disk = slow_team(22)
    game = covey.simulate(
        team, disk, evaders="straight-away", pursuer="nearest-first", update_time=1.0
    )
    assert game.survival_time >= game.guarantee > 0.0
