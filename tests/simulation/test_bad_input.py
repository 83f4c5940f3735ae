"""`simulate` refuses what it can't play, and says what it wanted."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey

BAD_SETTINGS = [
    ({"sensing": "hiden"}, "sensing: expected one of hidden, visible, got 'hiden'"),
    ({"sensing": None}, "sensing: expected one of hidden, visible, got None"),
    ({"update_time": 0.0}, "update_time: expected a finite number > 0, got 0.0"),
    ({"update_time": -0.01}, "update_time: expected a finite number > 0, got -0.01"),
    ({"update_time": math.nan}, "update_time: expected a finite number > 0, got nan"),
    ({"update_time": math.inf}, "update_time: expected a finite number > 0, got inf"),
    ({"update_time": [0.1, 0.2]}, "update_time: expected one number, got shape (2,)"),
    ({"update_time": "fast"}, "update_time: expected numbers, got 'fast'"),
    ({"seed": -1}, "seed: expected a whole number >= 0, got -1"),
    ({"seed": 0.5}, "seed: expected a whole number >= 0, got 0.5"),
    ({"seed": None}, "seed: expected a whole number >= 0, got None"),
    ({"time_limit": -1.0}, "time_limit: expected a finite number > 0, got -1.0"),
    ({"time_limit": 0.0}, "time_limit: expected a finite number > 0, got 0.0"),
    ({"time_limit": math.nan}, "time_limit: expected a finite number > 0, got nan"),
]

STRATEGIES = [
    {},
    {"evaders": lambda situation: situation.turns},
]


@pytest.mark.parametrize("strategies", STRATEGIES, ids=["compiled", "in Python"])
@pytest.mark.parametrize(
    ("settings", "message"), BAD_SETTINGS, ids=[message for _, message in BAD_SETTINGS]
)
def test_settings(settings, message, strategies):
    team = covey.Team([(1.0, 0.0)], [0.0])
    with pytest.raises(covey.InputError) as error:
        covey.simulate(team, covey.PursuerDisk(), **settings, **strategies)
    assert str(error.value) == message


@pytest.mark.parametrize("strategies", STRATEGIES, ids=["compiled", "in Python"])
def test_games(strategies):
    def refused(team):
        with pytest.raises(covey.InputError) as error:
            covey.simulate(team, covey.PursuerDisk(), **strategies)
        return str(error.value)

    crowd = covey.Team(np.ones((51, 2)), np.zeros(51))
    assert refused(crowd).startswith("team: expected at most 50 evaders, got 51")
    as_fast = covey.Team([(1.0, 0.0), (0.0, 1.0)], [0.0, 0.0], speeds=[0.25, 1.0])
    assert refused(as_fast) == (
        "speeds: expected every evader to be slower than the pursuer (1), got speeds[1] = 1"
    )


@pytest.mark.parametrize("role", ["evaders", "pursuer"])
@pytest.mark.parametrize("not_a_strategy", ["no-such-name", 3, None])
def test_what_is_no_strategy(role, not_a_strategy):
    team = covey.Team([(1.0, 0.0)], [0.0])
    with pytest.raises(covey.InputError, match=role):
        covey.simulate(team, covey.PursuerDisk(), **{role: not_a_strategy})


@pytest.mark.parametrize(
    ("role", "strategy"), [("evaders", "IterativeOpenLoop"), ("pursuer", "CommittedPursuer")]
)
def test_a_class_in_place_of_a_value(role, strategy):
    team = covey.Team([(1.0, 0.0)], [0.0])
    with pytest.raises(covey.InputError, match=role):
        covey.simulate(team, covey.PursuerDisk(), **{role: getattr(covey, strategy)})
