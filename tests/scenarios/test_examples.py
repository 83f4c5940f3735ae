"""The scenarios that come with covey play as their first lines tell."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import covey
from covey.scenarios import example_names, example_path, load_scenario


def example(name):
    return load_scenario(example_path(name))


@pytest.mark.parametrize("name", example_names())
def test_an_example_can_be_played_and_says_what_it_shows(name):
    game = example(name).simulate()
    assert game.status is covey.GameStatus.ALL_CAPTURED
    assert game.value >= game.planned_value - 1e-9
    assert "# To see: " in example_path(name).read_text(encoding="utf-8")


def test_a_game_about_everyone_is_fought_elsewhere():
    scenario = example("everyone")
    game = scenario.simulate()
    last = dataclasses.replace(scenario, objective=covey.LastCapture()).simulate()
    assert (game.value, game.survival_time) == pytest.approx((5.32, 2.72), abs=0.005)
    assert last.survival_time == pytest.approx(2.81, abs=0.005)
    assert (game.capture_sequence[-1], last.capture_sequence[0]) == (0, 0)


def test_fig3_is_set_as_the_paper_says():
    scenario = example("fig3")
    team, disk = scenario.team, scenario.disk
    assert len(team) == 5
    assert np.abs(team.positions).max() <= 0.5
    np.testing.assert_allclose(
        team.headings, np.arctan2(team.positions[:, 1], team.positions[:, 0]), atol=1e-15
    )
    assert (team.speeds == 0.25).all()
    assert (team.turn_rates == np.pi / 2).all()
    assert (*disk.center, disk.radius, disk.speed, disk.capture_radius) == (0, 0, 0, 1, 0)
    assert (scenario.sensing, scenario.update_time) == ("hidden", 0.01)


def test_fig3_tells_the_story_of_the_paper():
    game = example("fig3").simulate()
    assert game.guarantee == pytest.approx(6.55, abs=0.005)
    assert game.survival_time == pytest.approx(7.17, abs=0.005)
    assert game.capture_times[0] == pytest.approx(0.72, abs=0.005)
    # "The resulting trajectories of the rest of the game coincide with the predicted".
    after = int(np.searchsorted(game.times, 0.9))
    assert game.times[after] + game.guarantees[after] == pytest.approx(game.survival_time, 1e-6)
    points = game.evader_positions[-1]
    apart = np.hypot(*(points[:, None] - points[None]).T)[np.triu_indices(5, 1)]
    assert apart.min() > 0.5


def test_the_sequence_of_fig3_is_one_that_the_team_can_not_do_worse_against():
    scenario = example("fig3")
    survived = scenario.simulate().survival_time
    for sequence in ([4, 2, 0, 3, 1], [2, 0, 3, 1, 4], [1, 4, 2, 0, 3]):  # the next ones
        other = dataclasses.replace(scenario, pursuer=covey.FixedSequence(sequence))
        assert other.simulate().survival_time > survived + 0.1


def test_unequal_lives_longer_when_the_fast_one_faces_away():
    scenario = example("unequal")
    assert scenario.simulate().survival_time == pytest.approx(3.3, abs=0.05)
    x, y = scenario.team.positions[3]
    headings = [*scenario.team.headings[:3], np.arctan2(y, x)]
    team = covey.Team(
        scenario.team.positions, headings, scenario.team.speeds, scenario.team.turn_rates
    )
    away = dataclasses.replace(scenario, team=team)
    assert away.simulate().survival_time == pytest.approx(5.8, abs=0.05)


def test_visible_costs_little_to_hide():
    scenario = example("visible")
    seen = scenario.simulate().survival_time
    hidden = dataclasses.replace(scenario, sensing="hidden").simulate().survival_time
    assert hidden == pytest.approx(seen, rel=0.05)


def test_unseen_flies_in_the_disk_and_needs_longer_than_the_disk_itself():
    scenario = example("unseen")
    game = scenario.simulate()
    assert game.survival_time == pytest.approx(3.60, abs=0.005)
    assert np.allclose(game.pursuer_positions[0], [-0.09, 0.12])
    off = np.linalg.norm(game.pursuer_positions - game.disk_centers, axis=1)
    assert (off <= game.disk_radii + 1e-9).all()
    disk = dataclasses.replace(scenario, pursuer=covey.CommittedPursuer()).simulate()
    assert disk.survival_time == pytest.approx(3.49, abs=0.005)
