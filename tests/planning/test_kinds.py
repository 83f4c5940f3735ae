"""Arguments of the wrong kind: each public function says what it wanted, and what came."""

from __future__ import annotations

import numpy as np
import pytest

import covey

TEAM = covey.Team([[0.0, 1.0], [1.0, 0.0]], [0.0, 1.0])
DISK = covey.PursuerDisk()
TURNS, ORDER = np.zeros(2), [0, 1]

CALLS = {
    "plan": lambda team, disk: covey.plan(team, disk),
    "guaranteed_survival": lambda team, disk: covey.guaranteed_survival(team, disk, TURNS),
    "expected_survival": lambda team, disk: covey.expected_survival(
        team, disk, TURNS, covey.ExpectedSurvival()
    ),
    "capture_times": lambda team, disk: covey.capture_times(team, disk, TURNS, ORDER),
    "bracket": lambda team, disk: covey.bracket(team, disk),
    "plan_for_sequence": lambda team, disk: covey.plan_for_sequence(team, disk, ORDER),
    "simulate": lambda team, disk: covey.simulate(team, disk),
    "worst_case": lambda team, disk: covey.worst_case(team, disk),
}


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_team_and_disk_exchanged(call):
    with pytest.raises(covey.InputError, match="team: expected a Team, got PursuerDisk"):
        call(DISK, TEAM)


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_positions_in_place_of_a_team(call):
    with pytest.raises(covey.InputError, match=r"team: expected a Team, got \[\[0, 0\]\]"):
        call([[0, 0]], DISK)


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_a_position_in_place_of_a_disk(call):
    with pytest.raises(covey.InputError, match=r"disk: expected a PursuerDisk, got \(0, 0\)"):
        call(TEAM, (0, 0))


def test_headings_in_place_of_a_team():
    with pytest.raises(covey.InputError, match="team: expected a Team, got array"):
        covey.turns_to(np.zeros(2), [0.0, 1.0])


def test_a_long_value_is_cut():
    with pytest.raises(covey.InputError) as caught:
        covey.plan(list(range(10_000)), DISK)
    assert len(str(caught.value)) < 150
