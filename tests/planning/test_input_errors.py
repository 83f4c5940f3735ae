"""What can't be planned is refused, and the message says which argument is wrong, and how."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey

PAIR = covey.Team([(1, 0), (0, 1)], [0.0, 0.0])
DISK = covey.PursuerDisk()
FAST = covey.Team([(1, 0), (0, 1)], [0.0, 0.0], [0.25, 1.0])
CROWD = covey.Team(np.ones((51, 2)), np.zeros(51))


BAD_TURNS = {
    "too few": ([0.0], r"expected .*shape \(2,?\)", r"shape \(1,\)"),
    "a number": (0.0, "expected .*shape", r"shape \(\)"),
    "a table": (np.zeros((2, 1)), "expected .*shape", r"shape \(2, 1\)"),
    "nan": ([0.0, math.nan], "finite", r"\[1\] = nan"),
    "infinite": ([math.inf, 0.0], "finite", r"\[0\] = inf"),
    "words": (["left", "right"], "expected numbers", "left"),
    "nothing": (None, "expected numbers", "None"),
}

BAD_SEQUENCES = {
    "too short": [0],
    "too long": [0, 1, 2],
    "one twice": [1, 1],
    "counted from one": [1, 2],
    "negative": [0, -1],
    "fractions": [0.5, 1.0],
    "a number": 0,
    "words": ["first", "second"],
    "nan": [0.0, math.nan],
}

BAD_OPTIONS = {
    "no start": ({"starts": 0}, "starts: .*>= 1", "0"),
    "half a start": ({"starts": 1.5}, "starts: .*whole number", "1.5"),
    "many starts": ({"starts": [1, 2]}, "starts: .*whole number", r"\[1, 2\]"),
    "more than memory": ({"starts": 2**31}, "starts: .*<= 100000", "2147483648"),
    "yes": ({"starts": True}, "starts: .*whole number", "True"),
    "negative seed": ({"seed": -1}, "seed: .*>= 0", "-1"),
    "half a seed": ({"seed": 0.5}, "seed: .*whole number", "0.5"),
    "no seed": ({"seed": None}, "seed: .*whole number", "None"),
    "no tolerance": ({"tolerance": 0.0}, "tolerance: .*> 0", "0.0"),
    "negative tolerance": ({"tolerance": -1e-9}, "tolerance: .*> 0", "-1e-09"),
    "nan tolerance": ({"tolerance": math.nan}, "tolerance: .*finite", "nan"),
    "negative time": ({"time_limit": -1.0}, "time_limit: .*>= 0", "-1.0"),
    "nan time": ({"time_limit": math.nan}, "time_limit: .*finite", "nan"),
    "word for a time": ({"time_limit": "soon"}, "time_limit: expected numbers", "soon"),
    "large warm start": ({"warm_start": [0.0, 3.15]}, "warm_start: .*π", "3.15"),
}


@pytest.mark.parametrize("case", BAD_TURNS)
def test_turns(case):
    turns, wanted, got = BAD_TURNS[case]
    message = f"^turns: .*({wanted}).*got.*{got}"
    with pytest.raises(covey.InputError, match=message):
        covey.guaranteed_survival(PAIR, DISK, turns)
    with pytest.raises(covey.InputError, match=message):
        covey.capture_times(PAIR, DISK, turns, [0, 1])


@pytest.mark.parametrize("case", [case for case in BAD_TURNS if case != "nothing"])
def test_warm_start(case):
    turns, wanted, got = BAD_TURNS[case]
    with pytest.raises(covey.InputError, match=f"^warm_start: .*({wanted}).*got.*{got}"):
        covey.plan(PAIR, DISK, warm_start=turns)


def test_warm_start_from_another_team():
    other = covey.plan(covey.Team([(1, 0)], [0.0]), DISK, starts=1)
    with pytest.raises(covey.InputError, match=r"^warm_start: expected .*got shape \(1,\)"):
        covey.plan(PAIR, DISK, warm_start=other)


@pytest.mark.parametrize("case", BAD_SEQUENCES)
def test_sequence(case):
    with pytest.raises(
        covey.InputError, match=r"^sequence: expected each evader 0\.\.1 once, got "
    ):
        covey.capture_times(PAIR, DISK, [0.0, 0.0], BAD_SEQUENCES[case])


@pytest.mark.parametrize("case", BAD_OPTIONS)
def test_options(case):
    options, wanted, got = BAD_OPTIONS[case]
    with pytest.raises(covey.InputError, match=f"^{wanted}.*got.*{got}"):
        covey.plan(PAIR, DISK, **options)


def test_an_evader_as_fast_as_the_pursuer():
    message = r"^speeds: expected .*slower .*\(1\), got speeds\[1\] = 1"
    with pytest.raises(covey.InputError, match=message):
        covey.plan(FAST, DISK)
    with pytest.raises(covey.InputError, match=message):
        covey.guaranteed_survival(FAST, DISK, [0.0, 0.0])
    with pytest.raises(covey.InputError, match=message):
        covey.capture_times(FAST, DISK, [0.0, 0.0], [0, 1])


def test_too_many_evaders_for_the_exact_minimum():
    message = "^team: expected at most 50 evaders, got 51"
    with pytest.raises(covey.InputError, match=r"^team: expected at most 50 evaders, got 51"):
        covey.plan(CROWD, DISK)
    with pytest.raises(covey.InputError, match=message):
        covey.plan(CROWD, DISK, time_limit=1.0)
    with pytest.raises(covey.InputError, match=message):
        covey.guaranteed_survival(CROWD, DISK, np.zeros(51))


def test_one_sequence_of_many_evaders_is_no_trouble():
    assert len(covey.capture_times(CROWD, DISK, np.zeros(51), range(51))) == 51
