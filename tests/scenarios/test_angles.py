"""Angles in words: what was typed is read as radians, and shown again as it was typed."""

from __future__ import annotations

import copy
import json
import math
import pickle

import numpy as np
import pytest

from covey.scenarios.values.kinds import as_angle
from covey.studies import Study

TYPED = [("pi/2", math.pi / 2), ("10 deg", math.radians(10)), ("2 pi", 2 * math.pi)]


@pytest.mark.parametrize(("text", "radians"), TYPED)
def test_an_angle_is_its_radians_and_shows_its_text(text, radians):
    angle = as_angle(text)
    assert angle == radians
    assert np.array([angle]).tolist() == [radians]
    assert json.dumps(angle) == json.dumps(radians)
    assert str(angle) == f"{angle}" == text
    for same in (copy.deepcopy(angle), pickle.loads(pickle.dumps(angle))):
        assert (same, str(same)) == (radians, text)


def test_a_number_is_shown_as_a_number():
    assert str(as_angle(0.1745)) == "0.1745"


def test_a_study_shows_its_turn_rates_as_they_were_typed():
    study = Study(turn_rate=["10 deg", 1.5])
    assert "turn_rate=('10 deg', 1.5)" in repr(study)
    assert study == Study(turn_rate=[math.radians(10), 1.5])
