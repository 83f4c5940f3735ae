"""What planning once and planning again come to."""

from __future__ import annotations

import numpy as np
import pytest

import covey
from random_games import random_game

ROUNDING = 1e-9
"""Of a time, an angle or a length, in games of about unit size."""


def games_of(evaders, sensing, **settings):
    for seed in range(20):
        team, disk = random_game(np.random.default_rng(seed), 2 + seed % 4)
        yield covey.simulate(
            team, disk, evaders=evaders, sensing=sensing, update_time=0.05, seed=seed, **settings
        )


def test_open_loop_lives_exactly_as_long_as_guaranteed_if_captured_in_the_critical_order():
    for seed in range(20):
        team, disk = random_game(
            np.random.default_rng(seed), 2 + seed % 4, radius=0.1 * (seed % 2), mixed=seed % 3 == 0
        )
        plan = covey.plan(team, disk, seed=seed)
        game = covey.simulate(
            team,
            disk,
            evaders=covey.OpenLoop(),
            pursuer=covey.FixedSequence(plan.critical_sequences[0]),
            seed=seed,
        )
        assert game.survival_time == pytest.approx(plan.survival_time, abs=ROUNDING)


@pytest.mark.parametrize("sensing", ["hidden", "visible"])
def test_open_loop_keeps_its_goal_headings(sensing):
    for game in games_of(covey.OpenLoop(starts=2), sensing):
        goals = game.evader_headings + game.evader_turns
        flying = game.times[:, None] < _captured_when(game)
        assert np.abs((goals - goals[0])[flying]).max() <= ROUNDING


@pytest.mark.parametrize("sensing", ["hidden", "visible"])
def test_planning_again_changes_plans_for_the_better_only(sensing):
    changed = 0
    for game in games_of(covey.IterativeOpenLoop(starts=2), sensing):
        guaranteed_until = game.times + game.guarantees
        assert np.diff(guaranteed_until).min() >= -ROUNDING
        changed += guaranteed_until[-1] > guaranteed_until[0] + ROUNDING
    assert changed > 0


def test_planning_again_pays_on_average():
    """Section IV.C: the survival time can be improved by solving anew. Here, seeing the pursuer."""
    once, again = (
        np.mean([game.survival_time for game in games_of(evaders, "visible")])
        for evaders in (covey.OpenLoop(), covey.IterativeOpenLoop())
    )
    assert again > once


@pytest.mark.parametrize("sensing", ["hidden", "visible"])
def test_restarts_after_a_capture_find_better_plans(sensing):
    """Until the first capture the games are one; then a team without stays at its local maximum."""
    better = 0
    for without, with_eight in zip(
        games_of(covey.IterativeOpenLoop(starts=2, restarts=0), sensing),
        games_of(covey.IterativeOpenLoop(starts=2, restarts=8), sensing),
        strict=True,
    ):
        captured = int(np.searchsorted(without.times, without.capture_times[0]))
        assert np.array_equal(without.guarantees[:captured], with_eight.guarantees[:captured])
        gain = with_eight.guarantees[captured] - without.guarantees[captured]
        assert gain >= -ROUNDING
        better += gain > ROUNDING
    assert better > 0


@pytest.mark.parametrize("sensing", ["hidden", "visible"])
def test_more_than_eight_restarts_vary_the_best_plans_and_find_better_ones(sensing):
    """The first eight guesses are the same; the others vary what was found, in teams of four up."""
    better = 0
    for seed in range(12):
        team, disk = random_game(np.random.default_rng(seed), 7)
        at_capture = []
        for restarts in (8, 24):
            game = covey.simulate(
                team,
                disk,
                evaders=covey.IterativeOpenLoop(starts=2, restarts=restarts),
                sensing=sensing,
                update_time=0.2,
                seed=seed,
            )
            captured = int(np.searchsorted(game.times, game.capture_times[0]))
            assert np.abs(game.evader_turns).max() <= np.pi
            assert np.diff(game.times + game.guarantees).min() >= -ROUNDING
            at_capture.append(game.guarantees[captured])
        assert at_capture[1] >= at_capture[0] - ROUNDING
        better += at_capture[1] > at_capture[0] + ROUNDING
    assert better > 0


def _captured_when(game):
    when = np.full(len(game.team), np.inf)
    when[game.capture_sequence] = game.capture_times
    return when
