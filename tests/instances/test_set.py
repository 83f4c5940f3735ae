"""The files of the covey set: where the games came from, and what can be read from them."""

from __future__ import annotations

import math
import re
import tomllib
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import covey
from covey.bounds import solve_two_evaders
from covey.instances import instance_names, instance_path
from covey.instances.files import values_path
from covey.instances.generate import FAMILIES, games
from covey.instances.load import load_state
from covey.instances.text import game_text, values_text
from covey.kernels.arrays import MOST_EVADERS
from kernels import reference_game

GENERATED = {name: rest for name, *rest in games()}
NAMES = instance_names()


def test_every_game_has_a_file_of_its_state_and_one_of_values():
    assert set(NAMES) == set(GENERATED)
    assert {path.stem for path in values_path("any").parent.iterdir()} == set(NAMES)


@pytest.mark.parametrize("page", ["README.md", "docs/how-to/covey-set.md"])
def test_the_pages_tell_how_many_games_there_are_and_each_family(page):
    text = " ".join((Path(__file__).parents[2] / page).read_text("utf-8").split())
    assert f"has {len(NAMES)} games of 2 to 50 evaders" in text
    if "covey-set" in page:
        assert set(re.findall(r"`([a-z-]+)-\*`", text)) == set(FAMILIES)


def test_sizes_go_from_two_to_the_most_evaders_that_a_guarantee_takes():
    sizes = [len(team) for _, team, _ in GENERATED.values()]
    assert (min(sizes), max(sizes)) == (2, MOST_EVADERS)
    assert len(NAMES) >= 60


@pytest.mark.parametrize("name", NAMES)
def test_the_state_is_what_the_generator_gives(name):
    """Up to the last digits of sines and cosines, in which libraries differ."""
    about, team, disk = GENERATED[name]
    loaded, loaded_disk = load_state(name)
    assert loaded.as_rows() == pytest.approx(team.as_rows(), rel=1e-14, abs=1e-15)
    assert loaded_disk == disk
    assert loaded.unit == team.unit
    assert instance_path(name).read_text("utf-8") == game_text(about, loaded, disk)


@pytest.mark.parametrize("name", NAMES)
def test_the_values_read_back_exactly_and_belong_to_the_game(name):
    game = covey.load_instance(name)
    text = values_path(name).read_text("utf-8")
    assert text == values_text(name, game.plan, game.bracket)
    assert tomllib.loads(text)["plan"]["exact"] == game.plan.exact
    n = len(game.team)
    assert game.plan.turns.shape == game.plan.goal_headings.shape == (n,)
    assert sorted(game.plan.worst_sequence) == sorted(game.bracket.sequence) == [*range(n)]


@pytest.mark.parametrize("name", NAMES)
def test_no_bound_contradicts_another(name):
    game = covey.load_instance(name)
    plan, bracket = game.plan, game.bracket
    assert 0.0 < plan.survival_time <= plan.upper
    assert plan.survival_time <= bracket.lower <= bracket.upper * (1.0 + 1e-9)
    times = covey.capture_times(game.team, game.disk, plan.turns, plan.worst_sequence)
    assert times[-1] == pytest.approx(plan.upper, rel=1e-12)


@pytest.mark.parametrize("name", [name for name in NAMES if int(name.split("-")[-1]) <= 17])
def test_the_guarantee_of_a_small_team_is_exact(name):
    game = covey.load_instance(name)
    assert game.plan.exact
    found = covey.guaranteed_survival(game.team, game.disk, game.plan.turns)
    assert found.time == pytest.approx(game.plan.survival_time, rel=1e-12)


@pytest.mark.parametrize("name", [name for name in NAMES if len(load_state(name)[0]) <= 8])
def test_a_short_search_finds_no_better_plan(name):
    game = covey.load_instance(name)
    found = covey.plan(game.team, game.disk, starts=4, warm_start=game.plan.turns)
    assert found.survival_time <= game.plan.survival_time * (1.0 + 1e-6)


@pytest.mark.parametrize("name", NAMES)
def test_the_state_is_a_scenario(name):
    game, scenario = covey.load_instance(name), covey.load_scenario(instance_path(name))
    assert (scenario.team, scenario.disk) == (game.team, game.disk)


@pytest.mark.parametrize("name", ["paper-4", "mixed-3", "disk-2", "reach-3", "seen-4"])
def test_a_stranger_who_tries_every_sequence_comes_to_the_same_time(name):
    """From the files alone, by the reference of Algorithm 1 that knows no kernel."""
    state = tomllib.loads(instance_path(name).read_text("utf-8"))
    plan = tomllib.loads(values_path(name).read_text("utf-8"))["plan"]
    pursuer, evaders = state["pursuer"], state["team"]["evaders"]
    team = SimpleNamespace(
        positions=np.array([each["position"] for each in evaders]),
        headings=[each["heading"] for each in evaders],
        speeds=[each["speed"] for each in evaders],
        turn_rates=[each["turn_rate"] for each in evaders],
    )
    disk = SimpleNamespace(**{**pursuer, "center": np.array(pursuer["center"])})
    last = {
        sequence: reference_game.sequence_times(team, disk, plan["turns"], sequence)[-1]
        for sequence in reference_game.every_sequence(len(evaders))
    }
    assert min(last.values()) == pytest.approx(plan["survival_time"], rel=1e-9)
    assert last[tuple(plan["worst_sequence"])] == pytest.approx(plan["upper"], rel=1e-9)


def test_the_bracket_contains_the_value_that_is_known_for_two_who_turn_at_once():
    game = covey.load_instance("simple-2")
    value = solve_two_evaders((0.25, 0.25), cells=64).of(game.team, game.disk)
    bracket = game.bracket
    assert bracket.lower * (1.0 - 1e-3) <= value <= bracket.upper * (1.0 + 1e-3)


def test_evaders_on_a_circle_are_all_as_far_away():
    team, disk = load_state("circle-30")
    assert np.hypot(*(team.positions - disk.center).T) == pytest.approx(0.5)
    assert np.diff(np.sort(team.headings)) == pytest.approx(2 * math.pi / 30)


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("circle-31", 'lists all .*; did you mean "circle-30"'),
        ("xyz", "lists all [0-9]+$"),
        (3, "got 3"),
        ("../values/paper-2", "expected the name of a game"),
    ],
)
def test_an_unknown_name_is_told_with_the_nearest_one(name, said):
    with pytest.raises(covey.InputError, match=said):
        covey.load_instance(name)
