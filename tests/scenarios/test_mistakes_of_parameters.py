"""Mistakes of strategies and objectives: a name, or a table with a name and parameters."""

from __future__ import annotations

import pytest

from scenarios.scenario_files import ONE_EVADER, mistakes

NAMES = (
    '"committed", "flying", "patient", "fixed-sequence", "best-sequence", "assured", '
    '"random-sequence", "nearest-first"'
)


@pytest.mark.parametrize(
    ("strategy", "line"),
    [
        (
            '"comitted"',
            f': expected one of {NAMES}, got "comitted"; did you mean "committed"?',
        ),
        (
            '{ name = "Fixed-Sequence", sequence = [0] }',
            f'.name: expected one of {NAMES}, got "Fixed-Sequence"; did you mean "fixed-sequence"?',
        ),
        (
            "{ margin = 1 }",
            f".name: expected one of {NAMES}, got nothing",
        ),
        (
            "3",
            ": expected a name, or a table with a name and parameters, got 3",
        ),
        (
            '{ name = "committed", margn = 0.1 }',
            '.margn: unknown key; did you mean "margin"?',
        ),
        (
            '{ name = "committed", margin = -1 }',
            ".margin: expected a number >= 0 (inf is allowed), got -1",
        ),
        (
            '{ name = "fixed-sequence", sequence = [0.5] }',
            ".sequence: expected a list of evaders' numbers, got [0.5]",
        ),
        (
            '{ name = "fixed-sequence", sequence = [0, 1] }',
            ".sequence: expected each evader 0..0 once, got [0, 1]",
        ),
    ],
)
def test_a_mistake_of_a_strategy(strategy, line, tmp_path):
    text = f"[pursuer]\nstrategy = {strategy}\n{ONE_EVADER}"
    assert mistakes(tmp_path, text) == [f"pursuer.strategy{line}"]


@pytest.mark.parametrize(
    ("strategy", "line"),
    [
        (
            '{ name = "constant-heading", replan_time = -1 }',
            ".replan_time: expected a finite number >= 0, got -1",
        ),
        (
            '{ name = "hold-course", replan_time = 1 }',
            ".replan_time: unknown key; known here: name",
        ),
        (
            '{ name = "known-sequence", sequence = [1] }',
            ".sequence: expected each evader 0..0 once, got [1]",
        ),
        (
            '"straigt-away"',
            ': expected one of "open-loop", "iterative-open-loop", "contingent", '
            '"constant-heading", "straight-away", "hold-course", "known-sequence", '
            '"largest-distance", "smallest-danger", got "straigt-away"; '
            'did you mean "straight-away"?',
        ),
    ],
)
def test_a_mistake_of_a_teams_strategy(strategy, line, tmp_path):
    text = f"[team]\nstrategy = {strategy}\n{ONE_EVADER}"
    assert mistakes(tmp_path, text) == [f"team.strategy{line}"]


@pytest.mark.parametrize(
    ("objective", "line"),
    [
        (
            '"total"',
            ': expected one of "last-capture", "total-survival", "expected-survival", got "total"',
        ),
        (
            '{ name = "total-survival", measure = "last" }',
            ".measure: unknown key; known here: name",
        ),
        (
            '{ name = "expected-survival", measure = "first" }',
            '.measure: expected one of "last", "total", got "first"',
        ),
        (
            '{ name = "expected-survival", sequences = [[0, 1]] }',
            ".sequences[0]: expected each evader 0..0 once, got [0, 1]",
        ),
        (
            '{ name = "expected-survival", sequences = [0] }',
            ".sequences: expected a list of sequences of evaders' numbers, got [0]",
        ),
        (
            '{ name = "expected-survival", sequences = [[0]], weights = [-1] }',
            ".weights: expected a list of finite numbers >= 0, got [-1]",
        ),
        (
            '{ name = "expected-survival", sequences = [[0]], weights = [0] }',
            ": ExpectedSurvival.weights: expected at least one > 0, got [0.0]",
        ),
    ],
)
def test_a_mistake_of_an_objective(objective, line, tmp_path):
    text = f"[game]\nobjective = {objective}\n{ONE_EVADER}"
    assert mistakes(tmp_path, text) == [f"game.objective{line}"]


@pytest.mark.parametrize("offset", ["[1.0, 0.1]", "[0.5]", "0.5"])
def test_a_mistake_of_a_pursuers_place(offset, tmp_path):
    text = f'[pursuer]\nstrategy = {{ name = "flying", offset = {offset} }}\n{ONE_EVADER}'
    wanted = "a point [x, y] at most 1 from the origin"
    line = f"pursuer.strategy.offset: expected {wanted}, got {offset}"
    assert mistakes(tmp_path, text) == [line]


@pytest.mark.parametrize("starts", ["0", "1.5", "inf"])
def test_a_mistake_of_the_evaders_strategy(starts, tmp_path):
    text = f'[team]\nstrategy = {{ name = "open-loop", starts = {starts} }}\n{ONE_EVADER}'
    line = f"team.strategy.starts: expected a whole number >= 1, got {starts}"
    assert mistakes(tmp_path, text) == [line]
