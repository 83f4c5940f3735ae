"""What a scenario file means: its defaults, what overrides what, teams placed at random."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from covey.scenarios import load_scenario
from covey.scenarios.strategies import EVADERS, OBJECTIVES, PURSUERS, Named
from scenarios.scenario_files import ONE_EVADER, loaded


def test_one_position_is_a_scenario(tmp_path):
    scenario = loaded(tmp_path, ONE_EVADER)
    assert scenario.team.positions.tolist() == [[0.3, 0.4]]
    assert scenario.team.headings.tolist() == [math.atan2(0.4, 0.3)]
    assert scenario.team.speeds.tolist() == [0.25]
    assert scenario.team.turn_rates.tolist() == [math.pi / 2]
    assert scenario.disk.center.tolist() == [0.0, 0.0]
    assert (scenario.disk.radius, scenario.disk.speed, scenario.disk.capture_radius) == (0, 1, 0)
    assert (scenario.sensing, scenario.update_time) == ("hidden", 0.01)
    assert (scenario.seed, scenario.time_limit) == (0, None)
    assert scenario.evaders == covey.IterativeOpenLoop()
    assert scenario.pursuer == covey.CommittedPursuer()


def test_a_game_is_stopped_at_the_time_limit_of_its_file(tmp_path):
    game = loaded(tmp_path, f"{ONE_EVADER}[game]\ntime_limit = 0.1").simulate()
    assert game.status is covey.GameStatus.TIME_LIMIT
    assert game.times[-1] == pytest.approx(0.1)


def test_everything_can_be_said(tmp_path):
    scenario = loaded(
        tmp_path,
        """
        unit = "km"
        [pursuer]
        center = [1, 2]
        radius = 0.5
        speed = 2
        capture_radius = 0.1
        strategy = { name = "fixed-sequence", sequence = [1, 0] }
        [team]
        speed = 0.5
        turn_rate = "90 deg"
        heading = "pi"
        strategy = { name = "open-loop", starts = 4 }
        evaders = [
            { position = [3, 4] },
            { position = [5, 6], heading = "away", speed = 0, turn_rate = inf },
        ]
        [game]
        sensing = "visible"
        update_time = 0.5
        seed = 3
        time_limit = inf
        """,
    )
    assert scenario.team.positions.tolist() == [[3.0, 4.0], [5.0, 6.0]]
    assert scenario.team.headings.tolist() == [math.pi, math.pi / 4]
    assert scenario.team.unit == scenario.disk.unit == "km"
    assert "<td>update_time (s)</td>" in scenario._repr_html_()
    assert scenario.team.speeds.tolist() == [0.5, 0.0]
    assert scenario.team.turn_rates.tolist() == [math.pi / 2, math.inf]
    assert scenario.disk.center.tolist() == [1.0, 2.0]
    assert (scenario.disk.radius, scenario.disk.speed) == (0.5, 2.0)
    assert scenario.disk.capture_radius == 0.1
    assert (scenario.sensing, scenario.update_time) == ("visible", 0.5)
    assert (scenario.seed, scenario.time_limit) == (3, math.inf)
    assert scenario.evaders == covey.OpenLoop(starts=4)
    assert scenario.pursuer == covey.FixedSequence([1, 0])


def test_a_turning_radius_stands_for_the_turn_rate(tmp_path):
    """That of an evader comes before that of the team, whichever of the two they give."""
    text = "[team]\nspeed = 0.2\nturn_radius = 0.4\n" + "".join(
        f"[[team.evaders]]\nposition = [1, {k}]\n{keys}\n"
        for k, keys in enumerate(["", "speed = 0.1", "turn_rate = 3", "turn_radius = 0"])
    )
    assert loaded(tmp_path, text).team.turn_rates.tolist() == [0.5, 0.25, 3.0, math.inf]


def test_a_pursuer_may_have_been_seen_a_while_ago(tmp_path):
    text = "[pursuer]\nspeed = 45\nlast_seen = { position = [1, 2], within = 150, ago = 12 }\n"
    scenario = loaded(tmp_path, text + "[[team.evaders]]\nposition = [4, 2]\n")
    assert (*scenario.disk.center, scenario.disk.radius) == (1.0, 2.0, 690.0)
    assert scenario.team.headings.tolist() == [0.0]


def test_a_random_team_stands_in_a_square_around_the_pursuer_and_flies_away(tmp_path):
    text = "[pursuer]\ncenter = [10, 20]\n[team.random]\ncount = 18\nside = 3.0\nseed = 1\n"
    team = loaded(tmp_path, text).team
    offsets = team.positions - [10.0, 20.0]
    assert len(team) == 18
    assert np.abs(offsets).max() <= 1.5
    assert np.abs(offsets).max() > 1.0
    np.testing.assert_allclose(team.headings, np.arctan2(offsets[:, 1], offsets[:, 0]), rtol=1e-12)


def test_away_is_away_from_the_centre_of_the_disk_wherever_that_is(tmp_path):
    positions = [(4.0, 1.0), (3.0, 3.0), (1.0, 1.0), (3.0, 0.0), (0.0, 0.0)]
    evaders = "".join(f"[[team.evaders]]\nposition = [{x}, {y}]\n" for x, y in positions)
    team = loaded(tmp_path, "[pursuer]\ncenter = [3, 1]\n" + evaders).team
    headings = [0.0, math.pi / 2, math.pi, -math.pi / 2, math.atan2(-1.0, -3.0)]
    assert team.headings.tolist() == headings


def test_at_the_centre_of_the_disk_wherever_that_is_nothing_is_away(tmp_path):
    there = "[pursuer]\ncenter = [3, 1]\n[[team.evaders]]\nposition = [3, 1]\n"
    with pytest.raises(covey.InputError, match="heading: expected a heading in radians, got"):
        loaded(tmp_path, there)


def test_the_seed_of_the_game_places_a_team_without_one_of_its_own(tmp_path):
    free = "[team.random]\ncount = 2\n[game]\nseed = 7\n"
    fixed = free.replace("count", "seed = 1\ncount")

    def positions(text, seed=None):
        return loaded(tmp_path, text, seed=seed).team.positions.tolist()

    assert positions(free) == positions(free, seed=7) != positions(free, seed=8)
    assert positions(fixed) == positions(fixed, seed=8)
    assert loaded(tmp_path, fixed, seed=8).seed == 8


def test_a_seed_that_is_none_is_refused(tmp_path):
    with pytest.raises(covey.InputError, match="seed: expected a whole number >= 0, got -1"):
        loaded(tmp_path, ONE_EVADER, seed=-1)


def test_a_byte_order_mark_does_no_harm(tmp_path):
    assert len(loaded(tmp_path, "\ufeff" + ONE_EVADER).team) == 1


def test_a_scenario_plans_and_plays_what_it_says(tmp_path):
    text = (
        '[pursuer]\nstrategy = { name = "fixed-sequence", sequence = [1, 0] }\n'
        "[team.random]\ncount = 2\n[game]\nupdate_time = 0.1\nseed = 5\n"
    )
    scenario = loaded(tmp_path, text)
    game = scenario.simulate()
    assert (game.seed, game.update_time, game.sensing) == (5, 0.1, "hidden")
    assert game.capture_sequence.tolist() == [1, 0]
    assert game.guarantee == pytest.approx(scenario.plan().survival_time, rel=1e-9)


@pytest.mark.parametrize("known", [EVADERS, PURSUERS, OBJECTIVES])
def test_what_has_parameters_describes_itself_as_a_file_would(known):
    for name in known:
        strategy = Named(known).read(name)
        assert strategy.describe()["name"] == name
        assert Named(known).read(dict(strategy.describe())) == strategy


def test_an_objective_is_planned_and_played_for(tmp_path):
    text = """
        [pursuer]
        strategy = { name = "random-sequence", sequences = [[0, 1], [1, 0]], weights = [1, 3] }
        [team]
        evaders = [{ position = [0.3, 0.4] }, { position = [-0.2, 0.1] }]
        [game]
        objective = """
    expected = '{ name = "expected-survival", sequences = [[0, 1], [1, 0]], weights = [1, 3] }'
    scenario = loaded(tmp_path, text + expected)
    assert scenario.objective == covey.ExpectedSurvival([(0, 1), (1, 0)], [1, 3])
    assert scenario.pursuer == covey.RandomSequence([(0, 1), (1, 0)], [1, 3])
    assert scenario.plan().objective == scenario.objective
    summed = loaded(tmp_path, text + '"total-survival"')
    game = summed.simulate()
    assert game.objective == {"name": "total-survival"}
    assert game.value == game.capture_times.sum() >= summed.plan().value * (1.0 - 1e-9)
    assert game.value >= summed.worst_case().value * (1.0 - 1e-9)


def test_a_path_may_be_text(tmp_path):
    path = tmp_path / "game.toml"
    path.write_text(ONE_EVADER)
    assert len(load_scenario(str(path)).team) == 1


def test_the_heading_of_all_may_also_be_written_in_plural(tmp_path):
    evaders = "[[team.evaders]]\nposition = [0, 0]\n"  # the disk's centre: "away" is no heading
    singular, plural = (
        loaded(tmp_path, f"[team]\n{key} = 2.0\n{evaders}") for key in ("heading", "headings")
    )
    assert singular == plural
    assert singular.team.headings.tolist() == [2.0]
    with pytest.raises(covey.InputError, match=r"team.headings: unknown key; did you mean"):
        loaded(tmp_path, f"[team]\nheading = 2.0\nheadings = 1.0\n{evaders}")


@pytest.mark.parametrize("unit", ["3", '"two words"', '"thirteen-long"'])
def test_a_unit_is_a_short_word(tmp_path, unit):
    with pytest.raises(covey.InputError, match=r'unit: expected a short word such as "m", got'):
        loaded(tmp_path, f"unit = {unit}\n[[team.evaders]]\nposition = [1, 0]\n")
