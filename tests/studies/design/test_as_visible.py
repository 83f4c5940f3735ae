"""The hidden game that repeats the order of a visible one."""

from __future__ import annotations

import math

import numpy as np
import pytest

import covey
from covey.simulation import Outcome
from covey.studies import AsVisible


def test_evaders_that_the_visible_pursuer_had_not_captured_come_last_by_number():
    stopped = Outcome(1.0, math.inf, 1.0, math.inf, np.array([2]), np.array([0.5]))
    assert AsVisible().hidden(stopped, 4) == covey.FixedSequence([2, 0, 1, 3])


def test_the_visible_pursuer_is_the_papers_or_the_assured_one():
    assert AsVisible(0.02).visible() == covey.CommittedPursuer(0.02)
    assert AsVisible(pursuer="assured").visible() == covey.AssuredPursuer()
    with pytest.raises(covey.InputError, match='pursuer: expected "committed" or "assured", got'):
        AsVisible(pursuer="nearest")
