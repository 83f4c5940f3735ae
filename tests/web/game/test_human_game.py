"""A game that a person plays, without a person and without a page."""

from __future__ import annotations

import math
from typing import get_args

import numpy as np
import pytest

import covey
from covey.web.game import human_game
from covey.web.game.choices import Choices
from covey.web.game.game_json import frame, header
from covey.web.game.human_game import LONGEST_GUARANTEE, UPDATE_TIME, HumanGame
from web.chase_pages import aim

BOTH = pytest.mark.parametrize("sensing", ["visible", "hidden"])


def played(choices):
    game = HumanGame(choices)
    while not game.over:
        record = game.record()
        game.pursuer.steer(aim(frame(record, -1), header(record)), None)
        game.advance(4)
    return game


@BOTH
def test_a_whole_game_keeps_the_rules(sensing):
    game = played(Choices(evaders=4, sensing=sensing, seed=2))
    record = game.record()
    assert record.status is covey.GameStatus.ALL_CAPTURED
    assert record.survival_time >= record.guarantee - 1e-9
    assert record.strategies["pursuer"] == {"name": "person"}
    flown = np.hypot(*np.diff(record.pursuer_positions, axis=0).T)
    assert (flown <= np.diff(record.times) * (1.0 + 1e-9) + 1e-12).all()
    for i, time in zip(record.capture_sequence, record.capture_times, strict=True):
        row = int(np.argmax(record.times == time)) + (record.times == time).sum() - 1
        off = record.evader_positions[row, i] - record.pursuer_positions[row]
        assert np.hypot(*off) <= record.disk.capture_radius * (1.0 + 1e-9)


@pytest.mark.parametrize("team", get_args(Choices.model_fields["team"].annotation))
def test_every_team_can_be_chased_to_the_end(team):
    game = played(Choices(evaders=3, team=team, sensing="hidden", seed=2, capture_radius=0.05))
    assert game.record().status is covey.GameStatus.ALL_CAPTURED
    assert header(game.record())["sure"] == (team in {"open-loop", "iterative-open-loop"})
    assert game.score().share > 0.0


def test_a_hidden_pursuer_is_always_in_the_disk_and_the_team_sees_nothing_else():
    record = played(Choices(evaders=4, sensing="hidden", seed=2)).record()
    off = np.hypot(*(record.pursuer_positions - record.disk_centers).T)
    assert (off <= record.disk_radii + 1e-9).all()
    # It grows as fast as the pursuer flies, and collapses to a disk of ρ at a capture.
    captures = np.diff((record.critical_sequences >= 0).sum(axis=1)) < 0
    grown = np.diff(record.disk_radii)
    assert grown[~captures] == pytest.approx(np.diff(record.times)[~captures], abs=1e-9)
    assert record.disk_radii[1:][captures] == pytest.approx(record.disk.capture_radius)


def test_until_the_first_capture_a_hidden_pursuer_changes_nothing():
    one, other = (HumanGame(Choices(sensing="hidden", seed=5, capture_radius=0.01)) for _ in "ab")
    one.pursuer.steer(None, 0.3)
    one.advance(20)
    other.advance(20)
    assert np.array_equal(one.record().evader_positions, other.record().evader_positions)
    assert not np.array_equal(one.record().pursuer_positions, other.record().pursuer_positions)


def test_a_visible_pursuer_is_seen():
    one, other = (HumanGame(Choices(sensing="visible", seed=5, capture_radius=0.01)) for _ in "ab")
    one.pursuer.steer(None, 0.3)
    one.advance(20)
    other.advance(20)
    assert not np.array_equal(one.record().evader_positions, other.record().evader_positions)


def test_a_near_target_is_flown_to_and_not_past():
    game = HumanGame(Choices(evaders=1, seed=1))
    game.pursuer.steer((0.0, 0.0125), None)
    game.advance(5)
    assert game.record().pursuer_positions[-1] == pytest.approx([0.0, 0.0125], abs=1e-12)
    game.pursuer.steer(None, math.pi)
    game.advance(1)
    assert game.record().pursuer_positions[-1] == pytest.approx([-UPDATE_TIME, 0.0125], abs=1e-12)
    game.pursuer.steer(None, None)
    game.advance(1)
    assert game.record().pursuer_positions[-1] == pytest.approx([-UPDATE_TIME, 0.0125], abs=1e-12)


@BOTH
def test_the_score_sets_the_person_beside_the_best_pursuer(sensing):
    choices = Choices(evaders=3, sensing=sensing, seed=4)
    game = played(choices)
    team, disk = choices.game()
    reference = min(
        covey.simulate(
            team, disk, pursuer=pursuer, sensing=sensing, update_time=UPDATE_TIME, seed=4
        ).survival_time
        for pursuer in (covey.CommittedPursuer(), covey.BestSequence())
    )
    score, record = game.score(), game.record()
    assert game.reference.seed == choices.seed
    assert score.time == record.survival_time
    assert score.share == reference / record.survival_time
    assert record.guarantee == covey.plan(team, disk, seed=4).survival_time


def test_the_committed_pursuer_is_stopped_once_it_is_not_the_best(monkeypatch):
    games = []

    def noted(*arguments, **options):
        games.append(covey.simulate(*arguments, **options))
        return games[-1]

    monkeypatch.setattr(human_game, "simulate", noted)
    reference = HumanGame(Choices(evaders=4, seed=0, team="contingent")).reference
    in_order, committed = games
    assert reference is in_order
    assert committed.status is covey.GameStatus.TIME_LIMIT
    assert committed.times[-1] == pytest.approx(in_order.survival_time)


def test_no_reference_survives_the_assured_time():
    visible = HumanGame(Choices(evaders=4, seed=6))
    assert visible.reference.survival_time <= visible.assurance * (1.0 + 1e-9)
    assert visible.reference.guarantee <= visible.assurance


def test_who_gives_up_scores_nothing(monkeypatch):
    monkeypatch.setattr(human_game, "TIME_LIMIT", 2.0)
    game = HumanGame(Choices(evaders=1))
    game.advance(10**6)
    assert game.over
    assert game.record().times[-1] == pytest.approx(2.0)
    assert game.record().status is covey.GameStatus.TIME_LIMIT
    assert game.score() == (None, 0.0)


def test_a_team_that_is_sure_to_outlive_the_person_is_refused():
    with pytest.raises(covey.InputError, match=f"more than {LONGEST_GUARANTEE:.0f}"):
        HumanGame(Choices(evaders=10, speed=0.6, pursuer_speed=0.7))


def test_somebody_within_reach_at_the_start_is_captured_at_once():
    seed = next(
        s for s in range(500) if np.hypot(*Choices(evaders=1, seed=s).game()[0].positions[0]) < 0.1
    )
    game = HumanGame(Choices(evaders=1, seed=seed, capture_radius=0.1))
    game.advance(1)
    assert game.over
    assert game.score() == (0.0, 1.0)
