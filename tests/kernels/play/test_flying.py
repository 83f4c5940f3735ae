"""One interval between two decisions, worked out by hand: who moves where, and who is captured."""

from __future__ import annotations

import math

import numpy as np
import pytest

from covey.kernels.capture.path import HEADING, X, Y
from covey.kernels.play.rules import NOBODY, Rules, announce, fly, initial_state, remove

ROUNDING = 1e-14
"""Of a length, a time or an angle of about one."""

STANDING = (0.0, 0.0, 0.0)  # heading, speed, turn rate


def state_of(*evaders, disk=(0.0, 0.0, 0.0), turns=None):
    state = initial_state(np.array(evaders, dtype=float), *disk)
    if turns is not None:
        state.turns[:] = turns
    return state


def rules_of(*, hidden, reach=0.0, update_time=1.0, time_limit=math.inf):
    return Rules(1.0, reach, hidden, update_time, time_limit)


def flown(state, rules, target=NOBODY, velocity=(0.0, 0.0)):
    announce(state, rules)
    return fly(state, rules, target, *velocity)


def test_a_hidden_disk_grows_until_its_target_is_in_it():
    state, rules = state_of((1.5, 0.0, *STANDING)), rules_of(hidden=True)
    assert flown(state, rules, target=0) == NOBODY
    assert state.disk.tolist() == [0.0, 0.0, 1.0]
    assert state.time[0] == 1.0
    assert flown(state, rules, target=0) == 0
    assert state.disk.tolist() == [1.5, 0.0, 0.0]
    assert state.time[0] == pytest.approx(1.5, abs=ROUNDING)


def test_a_hidden_pursuer_with_reach_is_left_anywhere_within_it():
    state = state_of((1.0, 0.0, *STANDING), (1.0, 1.0, *STANDING))
    rules = rules_of(hidden=True, reach=0.2)
    assert flown(state, rules, target=0) == 0
    assert state.time[0] == pytest.approx(0.8, abs=ROUNDING)
    assert state.disk.tolist() == [1.0, 0.0, 0.2]
    remove(state, 0)
    assert flown(state, rules, target=0) == 0
    assert state.time[0] == pytest.approx(0.8 + 0.6, abs=ROUNDING)


def test_a_hidden_pursuer_takes_nobody_but_its_target():
    state = state_of((0.1, 0.0, *STANDING), (2.0, 0.0, *STANDING))
    rules = rules_of(hidden=True, reach=0.5)
    assert flown(state, rules, target=1) == NOBODY
    assert flown(state, rules, target=NOBODY) == NOBODY
    assert state.disk.tolist() == [0.0, 0.0, 2.0]
    assert flown(state, rules, target=0) == 0
    assert state.time[0] == 2.0


@pytest.mark.parametrize("hidden", [True, False])
def test_a_capture_at_the_very_end_of_an_interval_counts(hidden):
    state = state_of((1.0, 0.0, *STANDING))
    assert flown(state, rules_of(hidden=hidden), target=0) == 0
    assert state.time[0] == 1.0


def test_a_visible_pursuer_flies_to_where_it_will_meet_its_target():
    """At three fifths and four fifths of its speed: the triangle 3-4-5."""
    state = state_of((0.8, 0.0, math.pi / 2, 0.6, 0.0))
    rules = rules_of(hidden=False, update_time=0.5)
    assert flown(state, rules, target=0) == NOBODY
    assert state.disk == pytest.approx([0.4, 0.3, 0.0], abs=ROUNDING)
    assert flown(state, rules, target=0) == 0
    assert state.disk == pytest.approx([0.8, 0.6, 0.0], abs=ROUNDING)
    assert state.time[0] == pytest.approx(1.0, abs=ROUNDING)


def test_a_visible_pursuer_sets_out_from_where_in_its_disk_the_meeting_is_nearest():
    state = state_of((1.0, 0.0, *STANDING), disk=(0.0, 0.0, 0.3))
    assert flown(state, rules_of(hidden=False, update_time=0.5), target=0) == NOBODY
    assert state.disk == pytest.approx([0.8, 0.0, 0.0], abs=ROUNDING)


def test_a_visible_pursuer_whose_target_is_in_its_disk_was_there():
    state = state_of((0.2, 0.0, *STANDING), disk=(0.0, 0.0, 0.3))
    assert flown(state, rules_of(hidden=False), target=0) == 0
    assert state.disk.tolist() == [0.2, 0.0, 0.0]
    assert state.time[0] == 0.0


def test_a_visible_pursuer_without_target_flies_as_it_says():
    state = state_of((5.0, 0.0, *STANDING), disk=(1.0, 1.0, 0.3))
    assert flown(state, rules_of(hidden=False), velocity=(0.6, -0.8)) == NOBODY
    assert state.disk == pytest.approx([1.6, 0.2, 0.0], abs=ROUNDING)


def test_a_visible_pursuer_with_reach_takes_whoever_is_in_its_way():
    """First the nearer of two that it passes, a tenth off its line each."""
    state = state_of(
        (0.9, 0.0, *STANDING), (0.6, 0.1, *STANDING), (0.3, -0.1, *STANDING), (0.0, 0.5, *STANDING)
    )
    rules = rules_of(hidden=False, reach=0.125)
    before = math.sqrt(0.125**2 - 0.1**2)
    assert flown(state, rules, target=0) == 2
    assert state.time[0] == pytest.approx(0.3 - before, abs=ROUNDING)
    assert state.disk == pytest.approx([0.3 - before, 0.0, 0.0], abs=ROUNDING)
    remove(state, 2)
    assert flown(state, rules, target=0) == 1
    assert state.time[0] == pytest.approx(0.6 - before, abs=ROUNDING)
    remove(state, 1)
    assert flown(state, rules, target=0) == 0
    assert state.time[0] == pytest.approx(0.9 - 0.125, abs=ROUNDING)


def test_without_reach_nobody_is_taken_on_the_way():
    state = state_of((0.9, 0.0, *STANDING), (0.5, 0.0, *STANDING))
    assert flown(state, rules_of(hidden=False), target=0) == 0
    assert flown(state, rules_of(hidden=False), velocity=(1.0, 0.0)) == NOBODY


def test_a_visible_pursuer_that_waits_takes_who_comes_to_it():
    state = state_of((1.0, 0.0, math.pi, 0.5, 0.0))
    rules = rules_of(hidden=False, reach=0.25)
    assert flown(state, rules) == NOBODY
    assert flown(state, rules) == 0
    assert state.time[0] == pytest.approx(1.5, abs=ROUNDING)
    assert state.disk.tolist() == [0.0, 0.0, 0.0]


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_an_evader_turns_as_far_as_its_rate_lets_it(side):
    """A quarter circle in each interval, of a turn of three eighths."""
    rate, radius = math.pi / 2, 1.0
    state = state_of(
        (0.0, 0.0, 0.0, rate * radius, rate), disk=(9.0, 9.0, 0.0), turns=[side * 0.75 * math.pi]
    )
    rules = rules_of(hidden=True)
    assert flown(state, rules) == NOBODY
    assert state.evaders[0, [X, Y, HEADING]] == pytest.approx(
        [radius, side * radius, side * math.pi / 2], abs=ROUNDING
    )
    assert state.turns[0] == pytest.approx(side * math.pi / 4, abs=ROUNDING)
    assert flown(state, rules) == NOBODY
    assert state.evaders[0, HEADING] == pytest.approx(side * 0.75 * math.pi, abs=ROUNDING)
    assert state.turns[0] == 0.0
    straight = 0.5 * rate * radius
    end = radius * math.sqrt(0.5) - straight * math.sqrt(0.5)
    assert state.evaders[0, X] == pytest.approx(end, abs=ROUNDING)


def test_without_a_turn_rate_a_turn_is_not_flown_and_with_an_infinite_one_it_is_flown_at_once():
    state = state_of(
        (0.0, 0.0, 0.0, 0.5, 0.0),
        (0.0, 0.0, 0.0, 0.5, math.inf),
        disk=(9.0, 9.0, 0.0),
        turns=[math.pi / 2, math.pi / 2],
    )
    assert flown(state, rules_of(hidden=True)) == NOBODY
    assert state.evaders[0, [X, Y, HEADING]].tolist() == [0.5, 0.0, 0.0]
    assert state.evaders[1, [X, Y, HEADING]] == pytest.approx([0.0, 0.5, math.pi / 2], abs=ROUNDING)
    assert state.turns.tolist() == [0.0, 0.0]


def test_the_time_limit_ends_an_interval():
    state = state_of((1.0, 0.0, *STANDING))
    assert flown(state, rules_of(hidden=True, time_limit=0.25), target=0) == NOBODY
    assert state.time[0] == 0.25
    assert state.disk.tolist() == [0.0, 0.0, 0.25]


def test_who_is_captured_rests_where_it_was_and_the_others_close_up():
    state = state_of(*((i, 0.5, 0.25, 0.0, 0.0) for i in range(4)), turns=[0.0, 0.1, 0.2, 0.3])
    remove(state, 1)
    assert state.alive[0] == 3
    assert state.ids[:3].tolist() == [0, 2, 3]
    assert state.evaders[:3, X].tolist() == [0.0, 2.0, 3.0]
    assert state.turns[:3].tolist() == [0.0, 0.2, 0.3]
    assert state.capture_pose[1].tolist() == [1.0, 0.5, 0.25]
    remove(state, 2)
    assert state.ids[:2].tolist() == [0, 2]
    assert state.capture_pose[3].tolist() == [3.0, 0.5, 0.25]
