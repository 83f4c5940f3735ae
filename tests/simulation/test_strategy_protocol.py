"""What a strategy of one's own is asked, what it is told, and what it may answer."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from random_games import random_game
from soak.reference_flight import flown, living

ROUNDING = 1e-12
"""Of an angle of about one."""

BOTH = pytest.mark.parametrize("sensing", ["hidden", "visible"])


class FleeStraightAway:
    """Each evader flees from the centre of the disk: a strategy in a few lines."""

    def start(self, seed):
        self.seed = seed
        return self.turns

    def turns(self, situation):
        away = situation.team.positions - situation.disk.center
        return covey.turns_to(situation.team, np.arctan2(away[:, 1], away[:, 0]))


class Recording:
    """Remembers every situation, and passes it on to another strategy."""

    def __init__(self, policy):
        self.policy, self.situations = policy, []

    def __call__(self, situation):
        self.situations.append(situation)
        return self.policy(situation)


def straight_on(situation):
    return np.zeros(len(situation.evaders))


@BOTH
def test_a_strategy_is_asked_for_the_policy_of_a_game(sensing):
    team, disk = random_game(np.random.default_rng(0), 4)
    strategy = FleeStraightAway()
    game = covey.simulate(team, disk, evaders=strategy, sensing=sensing, seed=5)
    assert strategy.seed == 5
    assert game.status is covey.GameStatus.ALL_CAPTURED
    away = team.positions - disk.center
    goals = covey.turns_to(team, np.arctan2(away[:, 1], away[:, 0]))
    assert np.array_equal(game.evader_turns[0], goals)
    assert game.guarantee == covey.guaranteed_survival(team, disk, goals).time


@BOTH
def test_a_plain_function_is_a_strategy(sensing):
    team, disk = random_game(np.random.default_rng(1), 3)
    game = covey.simulate(
        team,
        disk,
        evaders=straight_on,
        pursuer=lambda situation: covey.Chase(situation.evaders[::-1]),
        sensing=sensing,
    )
    assert game.capture_sequence.tolist() == [2, 1, 0]
    assert game.guarantee == covey.guaranteed_survival(team, disk, np.zeros(3)).time
    expected = covey.capture_times(team, disk, np.zeros(3), [2, 1, 0])
    assert game.capture_times == pytest.approx(expected, abs=1e-9)


@BOTH
def test_both_are_asked_at_every_update_and_at_once_after_a_capture(sensing):
    team, disk = random_game(np.random.default_rng(2), 4)
    evaders = Recording(covey.IterativeOpenLoop(starts=2).start(0))
    pursuer = Recording(covey.CommittedPursuer().start(0))
    game = covey.simulate(
        team, disk, evaders=evaders, pursuer=pursuer, sensing=sensing, update_time=0.1
    )
    for asked in (evaders, pursuer):
        assert [now.time for now in asked.situations] == game.times[:-1].tolist()
    between = np.diff(game.times)
    to_capture = np.isin(game.times[1:], game.capture_times)
    assert between[~to_capture] == pytest.approx(0.1, abs=ROUNDING)
    assert (between[to_capture] <= 0.1 + ROUNDING).all()


@BOTH
def test_a_situation_is_the_state_of_the_living(sensing):
    team, disk = random_game(
        np.random.default_rng(3), 5, radius=0.1, capture_radius=0.02, mixed=True
    )
    evaders = Recording(covey.IterativeOpenLoop(starts=2).start(0))
    game = covey.simulate(team, disk, evaders=evaders, sensing=sensing, update_time=0.1)
    for row, now in enumerate(evaders.situations):
        alive = living(game)[row]
        assert list(now.evaders) == np.flatnonzero(alive).tolist()
        assert np.array_equal(now.team.positions, game.evader_positions[row, alive])
        assert np.array_equal(now.team.headings, game.evader_headings[row, alive])
        assert np.array_equal(now.team.speeds, team.speeds[alive])
        assert np.array_equal(now.team.turn_rates, team.turn_rates[alive])
        assert np.array_equal(now.disk.center, game.disk_centers[row])
        assert now.disk.radius == game.disk_radii[row]
        assert (now.disk.speed, now.disk.capture_radius) == (disk.speed, disk.capture_radius)


@BOTH
def test_the_team_is_told_its_old_plan_and_the_pursuer_the_new_one(sensing):
    team, disk = random_game(np.random.default_rng(4), 4)
    evaders = Recording(covey.IterativeOpenLoop(starts=2).start(0))
    pursuer = Recording(covey.CommittedPursuer().start(0))
    game = covey.simulate(
        team, disk, evaders=evaders, pursuer=pursuer, sensing=sensing, update_time=0.1
    )
    assert (evaders.situations[0].turns == 0.0).all()
    _, (headings,) = flown(game, np.diff(game.times)[np.newaxis])
    goals = (game.evader_headings + game.evader_turns)[:-1]
    for row in range(1, len(game.times) - 1):
        alive = living(game)[row]
        left = (goals - headings)[row - 1, alive]
        assert evaders.situations[row].turns == pytest.approx(left, abs=ROUNDING)
        assert np.array_equal(pursuer.situations[row].turns, game.evader_turns[row, alive])


def test_what_a_strategy_is_told_cannot_be_changed():
    def cheat(situation):
        situation.turns[0] = 1.0
        return situation.turns

    team, disk = random_game(np.random.default_rng(5), 2)
    with pytest.raises(ValueError, match="read-only"):
        covey.simulate(team, disk, evaders=cheat)


def test_the_record_names_the_strategies():
    team, disk = random_game(np.random.default_rng(6), 2)
    game = covey.simulate(team, disk, time_limit=0.1)
    assert game.strategies == {
        "evaders": {
            "name": "iterative-open-loop",
            "starts": 32,
            "restarts": 8,
            "replan_time": 0.0,
        },
        "pursuer": {"name": "committed", "margin": 0.01},
    }
    game = covey.simulate(
        team,
        disk,
        evaders=straight_on,
        pursuer=covey.FixedSequence([1, 0]),
        time_limit=0.1,
    )
    assert game.strategies == {
        "evaders": {"name": "straight_on"},
        "pursuer": {"name": "fixed-sequence", "sequence": [1, 0]},
    }
    game = covey.simulate(team, disk, evaders=FleeStraightAway(), time_limit=0.1)
    assert game.strategies["evaders"] == {"name": "FleeStraightAway"}


BAD_TURNS = [
    (lambda now: [0.0], "expected an array of shape (2,), got shape (1,)"),
    (lambda now: 0.0, "expected an array of shape (2,), got shape ()"),
    (lambda now: [[0.0], [0.0]], "expected an array of shape (2,), got shape (2, 1)"),
    (lambda now: [0.0, math.nan], "expected finite numbers"),
    (lambda now: [math.inf, 0.0], "expected finite numbers"),
    (lambda now: [0.0, 3.2], "expected radians in [-π, π], got [0.0, 3.2]"),
    (lambda now: None, "expected numbers, got None"),
    (lambda now: ["left", "right"], "expected numbers, got ['left', 'right']"),
]


@pytest.mark.parametrize(("evaders", "message"), BAD_TURNS, ids=[text for _, text in BAD_TURNS])
@BOTH
def test_turns_that_cannot_be_flown(evaders, message, sensing):
    team, disk = random_game(np.random.default_rng(7), 2)
    with pytest.raises(covey.InputError) as error:
        covey.simulate(team, disk, evaders=evaders, sensing=sensing)
    assert str(error.value).startswith("turns returned by the team's strategy")
    assert message in str(error.value)


BAD_DECISIONS = [
    (lambda now: covey.Chase(()), "Chase: expected a sequence of living evaders [0, 1], got []"),
    (lambda now: covey.Chase((2,)), "Chase: expected a sequence of living evaders [0, 1], got [2]"),
    (lambda now: covey.Chase((-1,)), "Chase: expected a sequence of living evaders [0, 1], got [-"),
    (lambda now: covey.Chase((0.5,)), "Chase: expected a sequence of living evaders [0, 1], got ["),
    (lambda now: covey.Chase((1, 1)), "Chase: expected a sequence of living evaders [0, 1], got ["),
    (lambda now: covey.Fly((0.8, 0.7)), "Fly: expected a speed of at most 1, got 1.063"),
    (lambda now: covey.Fly((math.nan, 0.0)), "Fly.velocity: expected finite numbers"),
    (lambda now: covey.Fly((0.1, 0.1, 0.1)), "Fly.velocity: expected an array of shape (2,), got"),
    (lambda now: covey.Fly("north"), "Fly.velocity: expected numbers, got 'north'"),
    (
        lambda now: covey.Fly(sequence=(2,)),
        "Fly: expected a sequence of living evaders [0, 1], got",
    ),
    (lambda now: covey.Fly(offset=(0.1, 0.0)), "Fly.offset: expected a point at most 0 from"),
    (lambda now: covey.Fly(assurance=math.nan), "Fly.assurance: expected a finite number >= 0"),
    (
        lambda now: covey.Fly(assurance=1.0 + now.time),
        "assurance of the pursuer at time 0.01: expec",
    ),
    (lambda now: covey.Fly(assurance=0.015), "assurance of the pursuer at time 0.02: expected a"),
    (lambda now: None, "pursuer's decision: expected Chase or Fly, got None"),
    (lambda now: (0, 1), "pursuer's decision: expected Chase or Fly, got (0, 1)"),
]


@pytest.mark.parametrize(
    ("pursuer", "message"), BAD_DECISIONS, ids=[text for _, text in BAD_DECISIONS]
)
def test_decisions_that_make_no_sense(pursuer, message):
    team, disk = random_game(np.random.default_rng(8), 2)
    with pytest.raises(covey.InputError) as error:
        covey.simulate(team, disk, pursuer=pursuer, sensing="visible")
    assert str(error.value).startswith(message)


def test_the_dead_cannot_be_chased():
    team, disk = random_game(np.random.default_rng(9), 3)
    with pytest.raises(covey.InputError, match=r"living evaders \[0, 1\], got \[2\]"):
        covey.simulate(team, disk, pursuer=lambda now: covey.Chase((2,)))


def test_a_hidden_pursuer_can_wait_but_not_be_steered():
    team, disk = random_game(np.random.default_rng(10), 2)
    covey.simulate(team, disk, pursuer=lambda now: covey.Fly(), update_time=0.1, time_limit=0.3)
    with pytest.raises(covey.InputError, match="a hidden pursuer is known as a disk only"):
        covey.simulate(team, disk, pursuer=lambda now: covey.Fly((0.1, 0.0)))


def test_a_visible_pursuer_chooses_where_in_the_disk_it_starts():
    team, disk = covey.Team([[3.0, 2.0]], [0.0]), covey.PursuerDisk((1.0, 2.0), 0.5)

    def policy(offset):
        return lambda now: covey.Fly(offset=offset if now.chooses_start else (0.0, 0.0))

    game = covey.simulate(
        team, disk, pursuer=policy((0.3, -0.4)), sensing="visible", time_limit=0.1
    )
    assert game.pursuer_positions[1:] == pytest.approx(
        np.tile([1.3, 1.6], (len(game.times) - 1, 1))
    )
    with pytest.raises(covey.InputError, match=r"Fly\.offset: expected a point at most 0\.5 from"):
        covey.simulate(team, disk, pursuer=policy((0.4, -0.4)), sensing="visible")


def test_what_a_pursuer_assures_and_means_to_do_is_recorded():
    team, disk = random_game(np.random.default_rng(11), 2)
    game = covey.simulate(
        team,
        disk,
        pursuer=lambda now: covey.Fly((0.0, 0.0), (1, 0), 9.0 - now.time),
        sensing="visible",
        update_time=0.1,
        time_limit=0.3,
    )
    assert game.assurances == pytest.approx([9.0, 8.9, 8.8, 8.8])
    assert game.assurance == 9.0
    assert game.pursuer_sequences[:3].tolist() == [[1, 0]] * 3
    assert covey.simulate(team, disk, time_limit=0.1).assurance == math.inf
