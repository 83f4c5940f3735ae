"""Teams and plans that answer captures, and break a promise, are found."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import covey
from covey.players.teams.contingent import Flight
from random_games import random_game
from soak import case, contingent, players


@pytest.fixture(scope="module")
def answering():
    """A case of a team that answers captures, against a hidden pursuer that keeps to an order."""
    team, disk = random_game(np.random.default_rng(1), 3)
    return case.Case(
        seed=1,
        team=team,
        disk=disk,
        evaders=players.Player("contingent", covey.Contingent(), answers=True),
        pursuer=players.Player("in order", covey.FixedSequence([2, 0, 1]), ends=True),
        sensing="hidden",
        objective=covey.LastCapture(),
        update_time=0.2,
        time_limit=None,
        checks=frozenset(),
    )


def play(each):
    players = {"evaders": each.evaders.strategy, "pursuer": each.pursuer.strategy}
    return covey.simulate(each.team, each.disk, **players, **each.settings())


def test_a_team_that_promises_less_than_before_is_found(answering, monkeypatch):
    assert max(contingent.promises(answering, play(answering)).values()) < 1e-12
    honest = Flight.__call__

    def boasting(flight, situation):
        turns = honest(flight, situation)
        flight.promise *= 1.0 if situation.time > 0.0 else 1.1
        return turns

    monkeypatch.setattr(Flight, "__call__", boasting)
    found = contingent.promises(answering, play(answering))
    assert found["promises of answers never fall"] > 0.05


def test_a_team_that_dies_before_its_promise_is_found(answering):
    game = play(answering)
    early = dataclasses.replace(game, survival_time=0.5 * game.survival_time)
    found = contingent.promises(answering, early)
    assert found["promise with delays is kept"] > 0.1
    assert found["the noted game is the same"] > 0.1


@pytest.mark.parametrize(
    ("depth", "factor", "check"),
    [
        (0, 0.99, "depth 0 is the open-loop plan"),
        (2, 0.9, "a deeper plan never promises less"),
        (2, 3.0, "answers below the upper end"),
    ],
)
def test_a_plan_that_answers_captures_wrongly_is_found(
    answering, monkeypatch, depth, factor, check
):
    assert max(contingent.plans(answering, None).values()) < 1e-12
    honest = covey.plan_contingent

    def wrong(team, disk, k, seed):
        tree = honest(team, disk, k, seed=seed)
        time = tree.survival_time * (factor if k == depth else 1.0)
        return dataclasses.replace(tree, survival_time=time)

    monkeypatch.setattr(covey, "plan_contingent", wrong)
    assert contingent.plans(answering, None)[check] > 1e-3
