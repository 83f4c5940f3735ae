"""What a strategy is worth on the covey set."""

from __future__ import annotations

import pytest

import covey
from covey.instances import score

NAMES = ("paper-2", "disk-2", "mixed-3", "reach-3")


@pytest.mark.parametrize("name", NAMES)
def test_a_team_that_flies_the_best_plan_known_comes_to_one_exactly(name):
    game = covey.load_instance(name)

    def fly_the_best_plan(situation):
        alive = list(situation.evaders)
        first = situation.time == 0.0
        return game.plan.turns[alive] if first else situation.turns

    scores = score(game, fly_the_best_plan)
    assert min(each.share for each in scores) >= 1.0 - 1e-9
    hidden = next(each for each in scores if each.sensing == "hidden")
    assert (hidden.pursuer, hidden.share) == ("worst-sequence", pytest.approx(1.0, rel=1e-9))


def test_the_same_strategy_scores_the_same_compiled_and_of_ones_own():
    game = covey.load_instance("mixed-3")

    def straight_away(situation):
        away = situation.disk.headings_away(situation.team.positions)
        return covey.turns_to(situation.team, away)

    assert [each.share for each in score(game, straight_away)] == pytest.approx(
        [each.share for each in score(game, "straight-away")], rel=1e-12
    )


def test_each_game_is_played_hidden_and_visible_against_two_pursuers():
    scores = score(covey.load_instance("paper-2"), "hold-course")
    assert len({(each.sensing, each.pursuer) for each in scores}) == len(scores) == 4
    assert {each.instance for each in scores} == {"paper-2"}
    assert all(0.0 < each.share < 1.0 for each in scores)
