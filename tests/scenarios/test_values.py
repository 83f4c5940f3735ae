"""Angles and numbers as they may stand in a file."""

from __future__ import annotations

import math
from datetime import date

import pytest
from hypothesis import given
from hypothesis import strategies as st

from covey.scenarios.values.kinds import as_angle, as_number, as_point, as_whole


@pytest.mark.parametrize(
    ("written", "radians"),
    [
        (0, 0.0),
        (-1.5, -1.5),
        (math.inf, math.inf),
        ("90 deg", math.pi / 2),
        ("-90deg", -math.pi / 2),
        ("1.8e2 degrees", math.pi),
        ("45°", math.pi / 4),
        ("pi", math.pi),
        ("-pi", -math.pi),
        ("+π", math.pi),
        ("pi/2", math.pi / 2),
        ("-pi / 4", -math.pi / 4),
        ("3 pi / 4", 3 * math.pi / 4),
        ("1.5*pi", 1.5 * math.pi),
        ("2pi", 2 * math.pi),
        (" .5 pi ", math.pi / 2),
    ],
)
def test_an_angle(written, radians):
    assert as_angle(written) == pytest.approx(radians, rel=1e-15)


@pytest.mark.parametrize(
    "written",
    [
        "",
        "90",
        "deg",
        "90 dge",
        "pi/0",
        "pi pi",
        "pi/",
        "north",
        "1,5 pi",
        "- 90 deg",
        True,
        None,
        math.nan,
        [1.0],
        {},
        date(2014, 5, 31),
    ],
)
def test_no_angle(written):
    assert as_angle(written) is None


@given(degrees=st.floats(-1e6, 1e6))
def test_degrees_are_what_they_say(degrees):
    assert as_angle(f"{degrees!r} deg") == math.radians(degrees)


@pytest.mark.parametrize("written", [True, "1", None, math.nan, [], 10**400])
def test_no_number(written):
    assert as_number(written) is None


@pytest.mark.parametrize(
    "written", [[1.0], [1.0, 2.0, 3.0], [1.0, math.inf], [1.0, "2"], 1.0, "1, 2", {"x": 1, "y": 2}]
)
def test_no_point(written):
    assert as_point(written) is None


@pytest.mark.parametrize("written", [-1, 1.0, True, "1"])
def test_no_whole_number(written):
    assert as_whole(written) is None
