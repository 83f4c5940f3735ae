"""The hidden game that repeats the order of a visible one."""

from __future__ import annotations

import math

import numpy as np

import covey
from covey.simulation import Outcome
from covey.studies import AsVisible


def test_evaders_that_the_visible_pursuer_had_not_captured_come_last_by_number():
    stopped = Outcome(1.0, math.inf, 1.0, math.inf, np.array([2]), np.array([0.5]))
    assert AsVisible().hidden(stopped, 4) == covey.FixedSequence([2, 0, 1, 3])
