"""Mistakes of the pursuer, the game, and of tables together."""

from __future__ import annotations

import pytest

from scenarios.scenario_files import ONE_EVADER, mistakes


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
            "the centre of the pursuer's disk, from where every heading leads away; "
            "write heading = 0.0, for example",
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
