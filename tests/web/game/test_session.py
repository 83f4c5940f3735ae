"""A page's session: how its game is set up, runs, ends and is scored."""

from __future__ import annotations

import json

import numpy as np
import pytest

import covey
from covey.simulation.storage import read_game
from covey.web.game.choices import Choices
from web.session_pages import Page


def test_a_game_is_set_up_with_its_plan_and_the_reference_game_follows():
    page = Page(evaders=4, seed=6)
    assert page.game["type"] == "game"
    assert page.game["picture"]["time"] == 0.0
    assert sorted(page.game["picture"]["sequence"]) == [0, 1, 2, 3]
    # The first plan: its last expected capture is what is guaranteed.
    assert page.game["picture"]["expected"][-1] == pytest.approx(page.game["cast"]["guarantee"])
    assert page.reference["survival_time"] >= page.game["cast"]["guarantee"] - 1e-9
    assert page.wait(1.0) == []  # nothing runs before it is asked to


@pytest.mark.parametrize("pace", [0.25, 1.0, 2.0])
def test_the_game_runs_at_its_pace(pace):
    page = Page(evaders=2, seed=1, capture_radius=0.01)
    page.ask(type="run", pace=pace)
    frames = [frame for _ in range(20) for frame in page.wait(1 / 60) if frame["type"] == "frame"]
    assert frames[-1]["time"] == pytest.approx(pace * 20 / 60, abs=0.006)
    assert frames[-1]["rate"] == pytest.approx(pace / 0.005, rel=0.15)


def test_a_machine_that_is_too_slow_plays_slower_and_says_so():
    page = Page(evaders=2, seed=1, capture_radius=0.01)
    page.ask(type="run", pace=1.0)
    frames = [frame for _ in range(20) for frame in page.wait(0.1)]
    assert frames[-1]["time"] == pytest.approx(20 / 30, abs=0.01)
    assert frames[-1]["rate"] == pytest.approx(200 / 3, rel=0.1)


def test_pause_and_step():
    page = Page(evaders=2, seed=1)
    page.ask(type="run", pace=1.0)
    page.wait(1 / 60)
    page.ask(type="pause")
    assert page.wait(1.0) == []
    (frame,) = page.ask(type="step")
    assert frame["time"] == pytest.approx(0.015 + 0.05)
    assert page.wait(1.0) == []


def test_between_two_updates_others_may_have_a_turn():
    page = Page(evaders=2, seed=1, capture_radius=0.01)
    page.ask(type="run", pace=1.0)
    assert [reply and reply["type"] for reply in page.session.advance(0.0151)] == [
        *[None] * 3,
        "frame",
    ]
    step = page.session.receive('{"type": "step"}', 0.02)
    assert [reply and reply["type"] for reply in step] == [*[None] * 10, "frame"]


def test_a_new_game_stands_still_although_the_last_one_ran():
    page = Page(evaders=2, seed=1)
    page.ask(type="run", pace=1.0)
    page.wait(1 / 60)
    page.ask(type="new", choices={"evaders": 2, "seed": 2})
    assert [reply["type"] for reply in page.wait(1.0)] == ["reference"]
    assert page.wait(1.0) == []


def test_played_to_the_end_it_is_scored_saved_and_shown():
    page = Page(evaders=3, seed=8, sensing="hidden")
    assert "isn't over" in page.error('{"type": "save", "game": "yours"}')
    score = page.play()
    assert score["type"] == "over"
    assert score["share"] == pytest.approx(page.reference["survival_time"] / score["time"])
    (content,) = page.ask(type="save", game="yours")
    record = read_game(content, "saved")
    assert record.survival_time == score["time"]
    (film,) = page.ask(type="film", game="yours")
    assert film["survival_time"] == score["time"]
    assert film["pictures"][0] == page.game["picture"]
    assert [i for i, _ in film["pictures"][-1]["captured"]] == record.capture_sequence.tolist()
    assert page.ask(type="run") == []
    assert page.wait(1.0) == []  # over is over


def test_the_reference_game_is_there_from_the_start():
    page = Page(evaders=3, seed=8)
    (content,) = page.ask(type="save", game="reference")
    record = read_game(content, "saved")
    assert record.strategies["pursuer"]["name"] == "committed"
    assert record.survival_time == page.reference["survival_time"]
    (film,) = page.ask(type="film", game="reference")
    assert film["pictures"][-1]["time"] == record.survival_time


def test_a_page_without_a_game_is_told_so():
    for message in (
        {"type": "steer"},
        {"type": "run"},
        {"type": "pause"},
        {"type": "step"},
        {"type": "film", "game": "yours"},
        {"type": "save", "game": "reference"},
    ):
        page = Page()
        assert "no game yet" in page.error(json.dumps(message))
        assert not page.session.busy
        assert page.wait(1.0) == []


def test_expected_captures_are_those_of_algorithm_1():
    page = Page(evaders=4, seed=2)
    team, disk = Choices(evaders=4, seed=2).game()
    plan = covey.plan(team, disk, seed=2)
    picture = page.game["picture"]
    times = covey.capture_times(team, disk, plan.turns, picture["sequence"])
    assert np.array(picture["expected"]) == pytest.approx(times, rel=1e-12)
