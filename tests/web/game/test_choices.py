"""What can be chosen, and the game that comes of it."""

from __future__ import annotations

from importlib.resources import files
from typing import get_args

import numpy as np
import pytest
from pydantic import ValidationError

import covey
from covey.scenarios import example_path
from covey.web.game.choices import Choices


@pytest.mark.parametrize("start", ["random", "formation"])
def test_the_seed_alone_decides_where_the_team_starts(start):
    one, _ = Choices(start=start, seed=3).game()
    same, _ = Choices(start=start, seed=3, speed=0.5, sensing="hidden").game()
    other, _ = Choices(start=start, seed=4).game()
    assert np.array_equal(one.positions, same.positions)
    assert np.array_equal(one.headings, same.headings)
    assert not np.array_equal(one.positions, other.positions)


def test_fig3_is_the_scenario_of_that_name():
    team, disk = Choices(start="fig3", speed=0.3).game()
    known = covey.load_scenario(example_path("fig3")).team
    assert np.array_equal(team.positions, known.positions)
    assert np.array_equal(team.headings, known.headings)
    assert team.speeds.tolist() == [0.3] * 5
    assert disk.radius == 0.0


def test_what_is_chosen_is_what_is_played():
    choices = Choices(evaders=3, speed=0.4, pursuer_speed=1.5, turn_rate=2.0, capture_radius=0.05)
    team, disk = choices.game()
    assert len(team) == 3
    assert set(team.speeds) == {0.4}
    assert set(team.turn_rates) == {2.0}
    assert (disk.speed, disk.capture_radius) == (1.5, 0.05)
    assert choices.team_strategy() == covey.IterativeOpenLoop()
    assert Choices(team="open-loop").team_strategy() == covey.OpenLoop()


def test_the_page_offers_every_team():
    names = get_args(Choices.model_fields["team"].annotation)
    page = files("covey.web").joinpath("page/index.html").read_text(encoding="utf-8")
    assert all(f'<option value="{name}">' in page for name in names)
    assert [Choices(team=name).team_strategy().describe()["name"] for name in names] == list(names)


@pytest.mark.parametrize(
    "wrong",
    [
        {"evaders": 0},
        {"evaders": 11},
        {"evaders": 2.5},
        {"speed": 0.7},
        {"speed": float("nan")},
        {"pursuer_speed": 0.6},
        {"turn_rate": float("inf")},
        {"capture_radius": 0.0},
        {"sensing": "blind"},
        {"team": "committed"},
        {"start": "fig3", "evaders": 4},
        {"team": "contingent", "evaders": 9},
        {"seed": -1},
        {"seed": 2**31},
        {"colour": "red"},
    ],
)
def test_choices_out_of_range_are_refused(wrong):
    with pytest.raises(ValidationError):
        Choices(**wrong)
