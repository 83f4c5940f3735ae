"""Strategies with parameters that make no sense are refused when they are made, or met."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey

BAD = [
    (lambda: covey.OpenLoop(starts=0), "OpenLoop.starts: expected a whole number >= 1, got 0"),
    (lambda: covey.OpenLoop(starts=2.5), "OpenLoop.starts: expected a whole number >= 1, got 2.5"),
    (
        lambda: covey.IterativeOpenLoop(starts=-1),
        "IterativeOpenLoop.starts: expected a whole number >= 1, got -1",
    ),
    (
        lambda: covey.IterativeOpenLoop(restarts=-1),
        "IterativeOpenLoop.restarts: expected a whole number >= 0, got -1",
    ),
    (
        lambda: covey.CommittedPursuer(-0.1),
        "CommittedPursuer.margin: expected a finite number >= 0, got -0.1",
    ),
    (
        lambda: covey.CommittedPursuer(math.nan),
        "CommittedPursuer.margin: expected a finite number >= 0, got nan",
    ),
    (
        lambda: covey.FlyingPursuer(-1.0),
        "FlyingPursuer.margin: expected a finite number >= 0, got -1.0",
    ),
    (
        lambda: covey.ConstantHeading(starts=0),
        "ConstantHeading.starts: expected a whole number >= 1, got 0",
    ),
    (
        lambda: covey.KnownSequence([1, 1]),
        "KnownSequence: expected each evader 0..1 once, got [1, 1]",
    ),
    (
        lambda: covey.FixedSequence([0, 0]),
        "FixedSequence: expected each evader 0..1 once, got [0, 0]",
    ),
    (
        lambda: covey.FixedSequence([1, 2]),
        "FixedSequence: expected each evader 0..1 once, got [1, 2]",
    ),
    (lambda: covey.FixedSequence(5), "FixedSequence: expected a list, got 5"),
    (lambda: covey.FixedSequence([]), "FixedSequence: expected each evader once, got nobody"),
    (
        lambda: covey.FixedSequence([0.7, 1.2]),
        "FixedSequence: expected each evader 0..1 once, got [0.7, 1.2]",
    ),
    (
        lambda: covey.RandomSequence([(0, 0)]),
        "RandomSequence.sequences: expected each evader 0..1 once, got (0, 0)",
    ),
    (
        lambda: covey.RandomSequence([(0, 1)], [0.0]),
        "RandomSequence.weights: expected at least one > 0, got [0.0]",
    ),
]


@pytest.mark.parametrize(("make", "message"), BAD, ids=[message for _, message in BAD])
def test_when_made(make, message):
    with pytest.raises(covey.InputError) as error:
        make()
    assert str(error.value) == message


@pytest.mark.parametrize("sequence", [[0, 1], [0, 1, 2, 3]])
@pytest.mark.parametrize("compiled", [True, False])
def test_a_sequence_for_a_team_of_another_size(sequence, compiled):
    team = covey.Team([(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)], [0.0, 0.0, 0.0])
    pursuer = covey.FixedSequence(sequence)
    with pytest.raises(covey.InputError, match="expected a sequence of all 3 evaders, got"):
        covey.simulate(team, covey.PursuerDisk(), pursuer=pursuer if compiled else pursuer.start(0))


def test_a_fixed_sequence_that_nobody_gave_is_that_of_the_numbers():
    for count in (2, 4):
        team = covey.Team(
            np.random.default_rng(count).uniform(-1.0, 1.0, (count, 2)), [0.0] * count
        )
        game = covey.simulate(team, covey.PursuerDisk(), pursuer=covey.FixedSequence())
        assert game.capture_sequence.tolist() == list(range(count))


def test_a_known_sequence_of_a_team_of_another_size():
    team = covey.Team([(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)], [0.0, 0.0, 0.0])
    with pytest.raises(covey.InputError, match="KnownSequence: expected a sequence of all 3"):
        covey.simulate(team, covey.PursuerDisk(), evaders=covey.KnownSequence([1, 0]))


def test_strategies_with_equal_parameters_are_equal():
    assert covey.FixedSequence([1, 0]) == covey.FixedSequence((1, 0))
    assert covey.CommittedPursuer() == covey.CommittedPursuer(margin=0.01)
    assert covey.IterativeOpenLoop() != covey.IterativeOpenLoop(restarts=0)
