"""Each mistake of a scenario file by its place, with what was wanted and what came; all at once."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

import covey
from covey.scenarios import load_scenario
from covey.scenarios.load import checked
from scenarios.scenario_files import ONE_EVADER, mistakes

NO_EVADERS = (
    "team.evaders: expected 1 to 20 evaders, got none; add a [[team.evaders]] table with a "
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
            "the pursuer's disk, from where every heading leads away",
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
    ("text", "line"),
    [
        ("[pursuer]\nspeed = 0", "pursuer.speed: expected a finite number > 0, got 0"),
        ("[pursuer]\nspeed = inf", "pursuer.speed: expected a finite number > 0, got inf"),
        ("[pursuer]\nradius = -1", "pursuer.radius: expected a finite number >= 0, got -1"),
        (
            "[pursuer]\ncapture_radius = nan",
            "pursuer.capture_radius: expected a finite number >= 0, got nan",
        ),
        (
            "[pursuer]\ncenter = [[0, 0]]",
            "pursuer.center: expected a point [x, y] of two numbers, got [[0, 0]]",
        ),
        ("[pursuer]\ncentre = [0, 0]", 'pursuer.centre: unknown key; did you mean "center"?'),
        (
            "[pursuer]\nupdate_time = 1",
            'pursuer.update_time: unknown key; "update_time" belongs to [game]',
        ),
        (
            '[game]\nsensing = "Hidden"',
            'game.sensing: expected one of "hidden", "visible", got "Hidden"',
        ),
        (
            "[game]\nupdate_time = 1e200",
            "game.update_time: expected a number of at most 1e+50 in size, got 1e+200",
        ),
        ("[game]\nupdate_time = 0", "game.update_time: expected a finite number > 0, got 0"),
        ("[game]\nseed = 1.5", "game.seed: expected a whole number >= 0, got 1.5"),
        ("[game]\nseed = -1", "game.seed: expected a whole number >= 0, got -1"),
        (
            "[game]\ntime_limit = 0",
            "game.time_limit: expected a number > 0 (inf: no limit), got 0",
        ),
        ("[gmae]\nseed = 1", 'gmae: unknown key; did you mean "game"?'),
        ("[[pursuer]]\nspeed = 1", "pursuer: expected a table, got [a table with speed]"),
        (
            "[pursuer]\nspeed = 0.25",
            "team.speed: expected every evader to be slower than the pursuer (0.25), or it could "
            "flee for ever; got 0.25, the default",
        ),
        (
            "[team]\nturn_rate = 1\nturn_radius = 0.2",
            "team.turn_radius: expected turn_rate or turn_radius, got both; leave one out",
        ),
        (
            "[pursuer]\nradius = 1\nlast_seen = { position = [0, 0], ago = 1 }",
            "pursuer.last_seen: expected radius or last_seen, got both; leave one out",
        ),
        (
            "[pursuer]\ncenter = [0, 0]\nradius = 1\nlast_seen = { position = [0, 0], ago = 1 }",
            "pursuer.last_seen: expected center and radius or last_seen, got both; leave one out",
        ),
        (
            "[pursuer]\nlast_seen = { position = [0, 0] }",
            "pursuer.last_seen.ago: missing; expected a finite number >= 0",
        ),
        (
            "[pursuer]\nlast_seen = { position = [0, 0], ago = 1, within = -1 }",
            "pursuer.last_seen.within: expected a finite number >= 0, got -1",
        ),
        (
            "[pursuer]\nlast_seen = { position = [0.3, 0.4], ago = 1 }",
            'team.evaders[0].heading: expected a heading in radians, got "away" for an evader at '
            "the centre of the pursuer's disk, from where every heading leads away",
        ),
        (
            "[team]\nspeed = 2",
            "team.speed: expected every evader to be slower than the pursuer (1), or it could "
            "flee for ever; got 2",
        ),
        (
            "[team.random]\ncount = 3",
            "team.random: expected the evaders of [[team.evaders]] or those of [team.random], got "
            "both",
        ),
    ],
)
def test_a_mistake_of_the_rest(text, line, tmp_path):
    if text.startswith("[team]"):
        text, evader = f"{text}\n{ONE_EVADER}", ""
    else:
        evader = ONE_EVADER
    assert mistakes(tmp_path, f"{text}\n{evader}") == [line]


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("", [NO_EVADERS]),
        ("[team]\nevaders = []", [NO_EVADERS]),
        ("[team.random]\ncount = 0", ["team.random.count: expected 1 to 20 evaders, got 0"]),
        ("[team.random]\ncount = 21", ["team.random.count: expected 1 to 20 evaders, got 21"]),
        ("[team.random]", ["team.random.count: missing; expected a whole number >= 0"]),
        (
            "[team.random]\ncount = 2.5",
            ["team.random.count: expected a whole number >= 0, got 2.5"],
        ),
        (
            "[[team.evaders]]\nposition = [1, 2]\n" * 21,
            ["team.evaders: expected 1 to 20 evaders, got 21"],
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


def test_all_mistakes_are_told_at_once(tmp_path):
    lines = mistakes(
        tmp_path,
        """
        [pursuer]
        speed = 0.2
        captur_radius = 0.1
        strategy = "comitted"
        [team]
        strategy = { name = "open-loop", strats = 3, starts = 0 }
        [[team.evaders]]
        position = [0.3, 0.1, 0.2]
        speed = 0.1
        [[team.evaders]]
        postion = [0.3, 0.1]
        speed = 0.2
        [game]
        sensing = "seen"
        """,
    )
    assert [line.partition(":")[0] for line in lines] == [
        "game.sensing",
        "pursuer.captur_radius",
        "pursuer.strategy",
        "team.evaders[0].position",
        "team.evaders[1].postion",
        "team.evaders[1].speed",
        "team.strategy.starts",
        "team.strategy.strats",
    ]


@pytest.mark.parametrize(
    ("content", "wanted"),
    [
        (b"position = [1,", "expected a scenario in TOML: Invalid value"),
        (b"a = 1\na = 2\n", "expected a scenario in TOML: Cannot overwrite a value"),
        (b"\xff\xfe\x00\x01", "expected a scenario in TOML, got a binary file"),
        (b"\x00" * 20, "expected a scenario in TOML: "),
    ],
)
def test_a_file_that_is_no_toml_is_refused(content, wanted, tmp_path):
    path = tmp_path / "game.toml"
    path.write_bytes(content)
    with pytest.raises(covey.InputError) as caught:
        load_scenario(path)
    assert str(caught.value).startswith(f"{path}: {wanted}")


def test_a_file_that_is_not_there_and_a_folder_are_refused(tmp_path):
    with pytest.raises(covey.InputError, match=r"none.toml: no such file, and no scenario of"):
        load_scenario(tmp_path / "none.toml")
    with pytest.raises(covey.InputError, match="can't be read: "):
        load_scenario(tmp_path)


_leaves = st.sampled_from(
    [
        True,
        0,
        -1,
        3,
        19,
        10**400,
        0.5,
        math.inf,
        math.nan,
        "",
        "away",
        "committed",
        "open-loop",
        "fixed-sequence",
        "90 deg",
        [],
        [0, 1],
        [[0, 0]],
        {},
    ]
)
_keys = st.sampled_from(
    [
        "pursuer",
        "team",
        "game",
        "evaders",
        "random",
        "position",
        "heading",
        "headings",
        "speed",
        "turn_rate",
        "strategy",
        "name",
        "sequence",
        "margin",
        "starts",
        "count",
        "side",
        "seed",
        "center",
        "radius",
        "sensing",
        "update_time",
        "wings",
    ]
)
_anything = st.recursive(
    _leaves,
    lambda part: st.lists(part, max_size=3) | st.dictionaries(_keys, part, max_size=6),
    max_leaves=20,
)
_tables = st.dictionaries(_keys, _anything, max_size=6)


@given(
    document=st.fixed_dictionaries(
        {}, optional={"pursuer": _tables, "team": _tables, "game": _tables}
    )
    | st.dictionaries(_keys, _anything)
)
def test_no_document_brings_the_checks_to_fall(document, tmp_path_factory):
    path = tmp_path_factory.getbasetemp() / "any.toml"
    try:
        checked(document, path)
    except covey.InputError as error:
        first, *lines = str(error).split("\n  ")
        count = int(first.removeprefix(f"{path}: ").partition(" mistake")[0])
        if count > 10:
            assert lines.pop() == f"and {count - 10} more"
        assert len(set(lines)) == len(lines) == min(count, 10)
