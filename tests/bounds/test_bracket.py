"""The bracket: hand cases, all sequences, teams that do what they like."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import covey
from covey.bounds.bracket import UpperEndKind
from covey.bounds.next_capture import next_capture_bound
from covey.bounds.polygon_bound import last_capture_bound
from covey.bounds.upper_end import earliest_end
from frames import ELSEWHERE
from random_games import random_game, time_rounding


def assert_in_order(found, team, disk):
    """The lower end isn't above the upper end, but for what rounding does to both."""
    assert found.lower <= found.upper + 2.0 * time_rounding(team, disk, found.upper)


def agile_game(generator, count, speed=0.25, **disk):
    """Simple motion, and a disk of which only the reach may not be a point."""
    team, disk = random_game(generator, count, **disk)
    return covey.Team(team.positions, team.headings, speed, math.inf), disk


@pytest.mark.parametrize(("radius", "reach"), [(0.0, 0.0), (0.3, 0.0), (0.0, 0.1), (2.0, 0.0)])
def test_one_agile_evader_leaves_no_gap(frame, radius, reach):
    team = covey.Team([[0.6, -0.8]], [0.3], 0.25, math.inf)
    disk = covey.PursuerDisk((0, 0), radius, 1.0, reach)
    found = covey.bracket(*frame.game(team, disk))
    time = frame.time * max(1.0 - radius - reach, 0.0) / 0.75
    assert (found.lower, found.upper) == pytest.approx((time, time), rel=1e-9, abs=1e-9)


def test_two_on_opposite_sides_leave_no_gap(frame):
    """Both flee straight away, and the pursuer takes the nearer one first."""
    team = covey.Team([[0.5, 0.0], [-1.0, 0.0]], [0.0, 0.0], 0.25, math.inf)
    found = covey.bracket(*frame.game(team, covey.PursuerDisk()))
    time = 0.5 / 0.75
    time = frame.time * (time + 0.5 + 0.25 * time + 1.0) / 0.75
    assert (found.lower, found.upper) == pytest.approx((time, time), rel=1e-9)
    assert found.sequence == (0, 1)


@pytest.mark.parametrize("seed", range(5))
def test_is_the_least_over_all_sequences(seed):
    generator = np.random.default_rng(seed)
    count = 2 + seed % 3
    team, disk = agile_game(generator, count, speed=[0.25, 0.6][seed % 2])
    values = {
        sequence: covey.plan_for_sequence(team, disk, sequence).survival_time
        for sequence in itertools.permutations(range(count))
    }
    found = covey.bracket(team, disk, depth=0)
    if found.upper_by is UpperEndKind.AGILE:
        assert found.upper == pytest.approx(min(values.values()), rel=1e-8)
        assert values[found.sequence] <= found.upper
    assert found.upper <= min(values.values()) * (1.0 + 1e-8)
    assert_in_order(found, team, disk)


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("count", [2, 5])
def test_contains_the_bracket_of_what_is_harder_for_the_team(seed, count):
    """A turn limit, a disk and a reach lower both ends, or leave them."""
    team, disk = agile_game(np.random.default_rng(seed), count, radius=0.1, capture_radius=0.02)
    point = covey.PursuerDisk(disk.center)
    free = covey.bracket(team, point, depth=0)
    slow = covey.Team(team.positions, team.headings, 0.25, 1.0)
    harder = covey.bracket(slow, disk, depth=0)
    assert_in_order(harder, slow, disk)
    assert harder.upper <= free.upper
    assert covey.bracket(slow, point, depth=0).upper <= free.upper


@pytest.mark.parametrize("seed", range(4))
def test_both_ends_are_the_same_in_another_frame(seed):
    team, disk = agile_game(
        np.random.default_rng(seed), 1 + seed, radius=0.1 * seed, capture_radius=0.02
    )
    found, there = covey.bracket(team, disk), covey.bracket(*ELSEWHERE.game(team, disk))
    wanted = ELSEWHERE.time * np.array([found.lower, found.upper])
    assert (there.lower, there.upper) == pytest.approx(wanted, rel=1e-8)
    assert there.sequence == found.sequence


def test_bound_exposes_a_local_maximum():
    """Corners that stand close around the wrong headings bound the right ones, and find them."""
    team = covey.Team([[1.0, 0.02], [2.0, 0.0]], [0.0, 0.0], 0.25, math.inf)
    disk = covey.PursuerDisk()
    best = covey.plan_for_sequence(team, disk, [0, 1])
    local = covey.SequencePlan(
        best.sequence,
        -best.turns,
        -best.goal_headings,
        best.capture_times,
        best.survival_time,
        best.status,
    )
    assert last_capture_bound(team, disk, best) == pytest.approx(best.survival_time, rel=1e-10)
    assert last_capture_bound(team, disk, local) == pytest.approx(best.survival_time, rel=1e-9)


@pytest.mark.parametrize("seed", range(10))
def test_bound_is_close_although_maxima_are_many(seed):
    generator = np.random.default_rng(seed)
    team, disk = agile_game(generator, 5, speed=[0.25, 0.5][seed % 2])
    best = covey.plan_for_sequence(team, disk, generator.permutation(5))
    bound = last_capture_bound(team, disk, best)
    assert best.survival_time * (1.0 - 1e-12) <= bound <= best.survival_time * (1.0 + 1e-9)


@pytest.mark.parametrize("speed", [0.25, 0.7])
@pytest.mark.parametrize("seed", range(3))
def test_no_team_outlives_it(seed, speed):
    """Not those that waver or roam either, against a pursuer that keeps to the sequence."""
    generator = np.random.default_rng(seed)
    team, disk = agile_game(generator, 3, speed, capture_radius=0.02 * seed)
    found = covey.bracket(team, disk)
    pursuer = covey.FixedSequence(found.sequence)
    best = covey.plan_for_sequence(team, disk, found.sequence).goal_headings

    def waver(situation):
        """Swing to both sides of the best headings, at random."""
        off = generator.choice([-0.3, 0.0, 0.3], len(situation.evaders))
        goals = best[list(situation.evaders)] + off
        return covey.turns_to(situation.team, goals)

    def dodge(situation):
        """The best flight anew at every update."""
        living = list(situation.evaders)
        order = [living.index(i) for i in found.sequence if i in living]
        goals = covey.plan_for_sequence(situation.team, situation.disk, order).goal_headings
        return covey.turns_to(situation.team, goals)

    def roam(situation):
        return generator.uniform(-math.pi, math.pi, len(situation.evaders))

    for evaders in (waver, dodge, roam, covey.OpenLoop(), covey.IterativeOpenLoop()):
        game = covey.simulate(
            team, disk, evaders=evaders, pursuer=pursuer, sensing="visible", update_time=0.05
        )
        assert game.survival_time <= found.upper * (1.0 + 1e-12)


def test_an_evader_almost_as_fast_as_the_pursuer_is_bounded_too():
    team = covey.Team([[0.5, 0.1], [-0.3, 0.4]], [0.0, 0.0], 1.0 - 1e-9, math.inf)
    found = covey.bracket(team, covey.PursuerDisk())
    assert found.lower <= found.upper < math.inf


def test_an_evader_almost_as_fast_and_where_the_pursuer_is_is_captured_at_once():
    team = covey.Team([[0.0, 0.0]], [0.0], 1.0 - 1e-9, math.inf)
    assert covey.bracket(team, covey.PursuerDisk()).upper == 0.0


def test_one_capture_at_a_time_counts_where_it_is_better_to_leave_the_order_open():
    """The fourth start of section V: the order that is best depends on how the team flies."""
    start = covey.Study(starts=4, team_size=5).start(3, 5)
    team = covey.Team(start.positions, start.headings, 0.25, math.inf)
    found = covey.bracket(team, covey.PursuerDisk(), depth=0)
    whole = earliest_end(team, covey.PursuerDisk())
    assert found.upper_by is UpperEndKind.NEXT_CAPTURE
    alone = next_capture_bound(team, covey.PursuerDisk(), whole.time)
    assert found.upper == alone.time < 0.98 * whole.time
    assert found.sequence[0] == alone.first
    assert sorted(found.sequence) == list(range(5))


@pytest.mark.parametrize("seed", range(4))
def test_takes_the_better_plan_and_says_which(seed):
    team, disk = random_game(np.random.default_rng(seed), 4)
    found = covey.bracket(team, disk, seed=seed)
    ends = {
        "OPEN_LOOP": found.plan.survival_time,
        "CONTINGENT": found.contingent.with_delays.survival_time,
    }
    assert found.lower == ends[found.lower_by.name] == max(ends.values())
    assert_in_order(found, team, disk)
    alone = covey.bracket(team, disk, depth=0, seed=seed)
    assert alone.contingent is None
    assert (alone.lower, alone.upper) == (found.plan.survival_time, found.upper)


def test_rejects_an_evader_as_fast_as_the_pursuer():
    with pytest.raises(covey.InputError, match="slower than the pursuer"):
        covey.bracket(covey.Team([[1.0, 0.0]], [0.0], 1.0), covey.PursuerDisk())
