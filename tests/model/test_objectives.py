"""The distribution that an expectation is over: what it keeps, and what it refuses."""

import math

import pytest

import covey


def test_a_distribution_is_kept_as_it_was_given():
    expected = covey.ExpectedSurvival([(1, 0), [0, 1]], [1, 0.5], "last")
    assert expected.sequences == ((1, 0), (0, 1))
    assert expected.weights == (1.0, 0.5)
    assert expected.describe() == {
        "name": "expected-survival",
        "sequences": [[1, 0], [0, 1]],
        "weights": [1.0, 0.5],
        "measure": "last",
    }


@pytest.mark.parametrize(
    ("sequences", "weights", "message"),
    [
        (None, [1.0], "weights: expected none without sequences"),
        ([(0, 1)], [1.0, 2.0], "weights: expected one for each of 1 sequences, got 2"),
        ([(0, 1), (1, 0)], [0.0, 0.0], "weights: expected at least one > 0"),
        ([(0, 1), (1, 0)], [1.0, -1.0], "weights: expected a finite number >= 0"),
        ([(0, 1), (1, 0)], [1.0, math.nan], "weights: expected a"),
        ([(0, 1), (0, 1)], None, "sequences: expected each once, got one twice"),
        ([], None, "sequences: expected at least one"),
        ([(0, 2)], None, "sequences: expected each evader 0..1 once"),
    ],
)
def test_what_is_no_distribution_is_refused(sequences, weights, message):
    with pytest.raises(covey.InputError, match=rf"^ExpectedSurvival\.{message}"):
        covey.ExpectedSurvival(sequences, weights)
