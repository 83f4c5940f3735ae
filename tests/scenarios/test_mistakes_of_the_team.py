"""Mistakes of evaders and of their number, by place, with what was wanted and what came."""

from __future__ import annotations

import pytest

from scenarios.scenario_files import mistakes

NO_EVADERS = (
    "team.evaders: expected 1 to 50 evaders, got none; add a [[team.evaders]] table with a "
    "position for each, or [team.random] with a count"
)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("position = [0.3]", "position: expected a point [x, y] of two numbers, got [0.3]"),
        ("position = [nan, 0]", "position: expected a point [x, y] of two numbers, got [nan, 0]"),
        ("position = [inf, 0]", "position: expected a point [x, y] of two numbers, got [inf, 0]"),
        ("position = 3", "position: expected a point [x, y] of two numbers, got 3"),
        ("heading = 0", "position: missing; expected a point [x, y] of two numbers"),
        ("postion = [1, 2]", 'postion: unknown key; did you mean "position"?'),
        (
            "position = [1, 2]\nspeed = -1",
            "speed: expected a finite number >= 0, got -1",
        ),
        (
            "position = [1, 2]\nspeed = nan",
            "speed: expected a finite number >= 0, got nan",
        ),
        (
            'position = [1, 2]\nspeed = "fast"',
            'speed: expected a finite number >= 0, got "fast"',
        ),
        (
            "position = [1, 2]\nspeed = true",
            "speed: expected a finite number >= 0, got true",
        ),
        (
            'position = [1, 2]\nheading = "90 dge"',
            'heading: expected a heading: radians, or a string such as "90 deg" or "pi/2", or '
            '"away", got "90 dge"',
        ),
        (
            "position = [1, 2]\nheading = inf",
            'heading: expected a heading: radians, or a string such as "90 deg" or "pi/2", or '
            '"away", got inf',
        ),
        (
            "position = [1, 2]\nturn_rate = -1",
            'turn_rate: expected a turn rate >= 0: radians, or a string such as "90 deg" or '
            '"pi/2" (inf is allowed), got -1',
        ),
        (
            "position = [1, 2]\nturn_radius = -1",
            "turn_radius: expected a turning radius >= 0 (inf: can't turn), got -1",
        ),
        (
            "position = [1, 2]\nturn_radius = 1\nturn_rate = 1",
            "turn_radius: expected turn_rate or turn_radius, got both; leave one out",
        ),
        (
            "position = [0, 0.0]",
            'heading: expected a heading in radians, got "away" for an evader at the centre of '
            "the pursuer's disk, from where every heading leads away; "
            "write heading = 0.0, for example",
        ),
        (
            "position = [1, 2]\nspeed = 1.0",
            "speed: expected every evader to be slower than the pursuer (1), or it could flee for "
            "ever; got 1",
        ),
        (
            "position = [1, 2]\nwings = 2",
            "wings: unknown key; known here: position, heading, speed, turn_rate, turn_radius",
        ),
        (
            "position = [1, 2]\nseed = 2",
            'seed: unknown key; did you mean "speed"?; "seed" belongs to [team.random] or [game]',
        ),
    ],
)
def test_a_mistake_of_an_evader(text, line, tmp_path):
    assert mistakes(tmp_path, f"[[team.evaders]]\n{text}\n") == [f"team.evaders[0].{line}"]


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("", [NO_EVADERS]),
        ("[team]\nevaders = []", [NO_EVADERS]),
        ("[team.random]\ncount = 0", ["team.random.count: expected 1 to 50 evaders, got 0"]),
        ("[team.random]\ncount = 51", ["team.random.count: expected 1 to 50 evaders, got 51"]),
        ("[team.random]", ["team.random.count: missing; expected a whole number >= 0"]),
        (
            "[team.random]\ncount = 2.5",
            ["team.random.count: expected a whole number >= 0, got 2.5"],
        ),
        (
            "[[team.evaders]]\nposition = [1, 2]\n" * 51,
            ["team.evaders: expected 1 to 50 evaders, got 51"],
        ),
        ("team = 3", ["team: expected a table, got 3"]),
        (
            "[team.evaders]\nposition = [1, 2]",
            [
                "team.evaders: expected a list of tables, [[team.evaders]], "
                "got a table with position"
            ],
        ),
        ("[team]\nevaders = [3]", ["team.evaders[0]: expected a table, got 3"]),
    ],
)
def test_a_mistake_in_the_number_of_evaders(text, lines, tmp_path):
    assert mistakes(tmp_path, text) == lines
