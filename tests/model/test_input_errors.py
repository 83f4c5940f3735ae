"""What can't be a game is refused with the name of the argument, what was wanted and what came."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey

TWO = [(0, 0), (1, 1)]

TEAMS = {
    "no places": ({"positions": []}, "positions: expected .*shape", r"\(0,\)"),
    "no rows": ({"positions": np.zeros((0, 2))}, "positions: expected at least one", "none"),
    "one place flat": ({"positions": [0, 0]}, "positions: expected .*shape", r"\(2,\)"),
    "places in space": ({"positions": np.zeros((2, 3))}, "positions: expected", r"\(2, 3\)"),
    "nan place": ({"positions": [(0, 0), (1, math.nan)]}, "positions: .*finite", r"\[1, 1\] = nan"),
    "infinite place": ({"positions": [(0, 0), (math.inf, 1)]}, "positions: .*finite", "inf"),
    "ragged": ({"positions": [(0, 0), (1,)]}, "positions: expected numbers", r"\(1,\)"),
    "words": ({"positions": "here"}, "positions: expected numbers", "'here'"),
    "nothing": ({"positions": None}, "positions: expected numbers", "None"),
    "complex": ({"positions": np.zeros((2, 2), complex)}, "positions: expected numbers", "0.j"),
    "many headings": ({"headings": [0, 0, 0]}, "headings: expected one number.* 2", r"\(3,\)"),
    "heading a word": ({"headings": "away"}, "headings: expected num", "'away'.*headings_away"),
    "far place": (
        {"positions": [(0, 0), (1, 1e60)]},
        "positions: .*up to 1e.50",
        r"\[1, 1\] = 1e.60",
    ),
    "many turns": ({"headings": [0, 1e16]}, r"headings: .*up to 1.001e\+09", r"\[1\] = 1e\+16"),
    "nan heading": ({"headings": [0, math.nan]}, "headings: .*finite", r"\[1\] = nan"),
    "infinite heading": ({"headings": [math.inf, 0]}, "headings: .*finite", r"\[0\] = inf"),
    "negative speed": ({"speeds": [0.1, -0.1]}, "speeds: .*>= 0", r"speeds\[1\] = -0.1"),
    "nan speed": ({"speeds": math.nan}, "speeds: .*>= 0", "nan"),
    "infinite speed": ({"speeds": math.inf}, "speeds: .*finite", "inf"),
    "three speeds": ({"speeds": [0.1] * 3}, "speeds: .*one number.* 2 evaders", r"\(3,\)"),
    "negative rate": ({"turn_rates": -1.0}, "turn_rates: .*>= 0", "-1"),
    "nan rate": ({"turn_rates": [1, math.nan]}, "turn_rates: .*>= 0", r"\[1\] = nan"),
    "negative radius": ({"turn_radii": -1.0}, "turn_radii: .*>= 0", "-1"),
    "nan radius": ({"turn_radii": [1, math.nan]}, "turn_radii: .*>= 0", r"\[1\] = nan"),
    "three radii": ({"turn_radii": [1] * 3}, "turn_radii: .*one number.* 2 evaders", r"\(3,\)"),
    "rates and radii": (
        {"turn_rates": 1.0, "turn_radii": 1.0},
        "turn_rates, turn_radii: expected one of them",
        "both; leave one out",
    ),
    "rates in a table": ({"turn_rates": np.ones((2, 1))}, "turn_rates: .*one number", r"\(2, 1\)"),
}

DISKS = {
    "center in space": ({"center": (0, 0, 0)}, "center: expected .*shape", r"\(3,\)"),
    "center a number": ({"center": 0.0}, "center: expected .*shape", r"\(\)"),
    "nan center": ({"center": (0, math.nan)}, "center: .*finite", r"\[1\] = nan"),
    "negative radius": ({"radius": -0.1}, "radius: .*>= 0", "-0.1"),
    "nan radius": ({"radius": math.nan}, "radius: .*finite", "nan"),
    "infinite radius": ({"radius": math.inf}, "radius: .*finite", "inf"),
    "two radii": ({"radius": [0.1, 0.2]}, "radius: expected one number", r"\(2,\)"),
    "word": ({"radius": "wide"}, "radius: expected numbers", "'wide'"),
    "no speed": ({"speed": 0.0}, "speed: .*> 0", "0.0"),
    "negative speed": ({"speed": -1.0}, "speed: .*> 0", "-1.0"),
    "infinite speed": ({"speed": math.inf}, "speed: .*finite", "inf"),
    "large speed": ({"speed": 1e60}, r"speed: .*> 0 and <= 1e\+50", r"1e\+60"),
    "tiny speed": ({"speed": 1e-60}, "speed: .*>= 1e-50", "1e-60"),
    "negative reach": ({"capture_radius": -1e-9}, "capture_radius: .*>= 0", "-1e-09"),
    "nan reach": ({"capture_radius": math.nan}, "capture_radius: .*finite", "nan"),
}


@pytest.mark.parametrize("case", TEAMS)
def test_team(case):
    changes, wanted, got = TEAMS[case]
    arguments = {"positions": TWO, "headings": [0.0, 0.0], **changes}
    with pytest.raises(covey.InputError, match=f"^{wanted}.*got.*{got}"):
        covey.Team(**arguments)


@pytest.mark.parametrize("case", DISKS)
def test_disk(case):
    changes, wanted, got = DISKS[case]
    with pytest.raises(covey.InputError, match=f"^{wanted}.*got.*{got}"):
        covey.PursuerDisk(**changes)


@pytest.mark.parametrize(
    ("goals", "got"),
    [([0.0], r"shape \(1,\)"), (0.0, r"shape \(\)"), ([0.0, math.nan], r"\[1\] = nan"),
     (["north", "south"], "north")],
)  # fmt: skip
def test_goal_headings(goals, got):
    with pytest.raises(covey.InputError, match=f"^goal_headings: expected.*got.*{got}"):
        covey.turns_to(covey.Team(TWO, [0.0, 0.0]), goals)


@pytest.mark.parametrize(
    "value",
    ["x" * 5000, 10**5000, [0.0] * 5000, [[0.0], 0.0] * 5000],
    ids=["text", "int", "1", "2"],
)
def test_a_long_value_is_shown_shortened(value):
    with pytest.raises(covey.InputError, match=r"^radius: expected ") as caught:
        covey.PursuerDisk(radius=value)
    assert len(str(caught.value)) < 200


def test_an_input_error_is_a_value_error():
    """So that callers who know nothing of covey catch it as they would expect to."""
    assert issubclass(covey.InputError, ValueError)
