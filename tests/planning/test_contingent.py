"""Plans that answer captures: their value by other means, their depth, their parts, delays."""

from __future__ import annotations

import math
from itertools import permutations

import numpy as np
import pytest

import covey
from covey.kernels.contingent.delays import survives_delays
from covey.model import InputError
from covey.planning.contingent import delays
from kernels.contingent import reference_tree
from random_games import random_game

SEEDS = pytest.mark.parametrize("seed", range(6))


def some_game(seed, most=4):
    """A game of two evaders or more."""
    generator = np.random.default_rng(seed)
    count = int(generator.integers(2, most + 1))
    reach = generator.choice([0.0, 0.02])
    return random_game(generator, count, radius=0.1 * (seed % 2), capture_radius=reach)


def flat(tree):
    """All turns of a tree, as `reference_tree` reads them."""
    return tree.node.turns


def earliest(team, disk, turns, i):
    """When evader i is captured if it is the first."""
    others = [j for j in range(len(team)) if j != i]
    return covey.capture_times(team, disk, turns, [i, *others])[0]


@SEEDS
def test_depth_0_is_the_open_loop_plan(seed):
    game = some_game(seed)
    plan, tree = covey.plan(*game, seed=seed), covey.plan_contingent(*game, 0, seed=seed)
    assert tree.turns.tolist() == plan.turns.tolist()
    assert tree.goal_headings.tolist() == plan.goal_headings.tolist()
    assert tree.survival_time == plan.survival_time
    assert tree.critical_sequences == plan.critical_sequences
    assert (tree.status, tree.starts, tree.steps) == (plan.status, plan.starts, plan.steps)


@SEEDS
def test_a_deeper_plan_never_guarantees_less(seed):
    game = some_game(seed)
    times = [covey.plan_contingent(*game, depth).survival_time for depth in range(len(game[0]))]
    assert all(np.diff(times) >= -1e-12 * times[0])


@SEEDS
def test_the_guarantee_is_the_least_over_all_sequences(seed):
    team, disk = some_game(seed)
    for depth in range(len(team)):
        tree = covey.plan_contingent(team, disk, depth)
        value = reference_tree.value(team, disk, flat(tree), depth)
        assert tree.survival_time == pytest.approx(value, rel=1e-10)
        for sequence in tree.critical_sequences:
            ends = reference_tree.times(team, disk, flat(tree), depth, sequence)[-1]
            assert ends == pytest.approx(value, rel=2e-6)


def stepped_end(team, disk, tree, sequence, step):
    """Last capture, by small steps: a pursuer that sees ahead flies straight to each interception.

    An interception is at the first step at which the pursuer, flying straight, is within reach.
    """
    living = {i: [*team.positions[i], team.headings[i]] for i in range(len(team))}
    place, reach, now = disk.center, disk.radius + disk.capture_radius, 0.0
    for i in sequence:
        left, flown = dict(zip(tree.evaders, tree.turns.tolist(), strict=True)), 0.0
        while math.hypot(*(np.array(living[i][:2]) - place)) > reach + disk.speed * flown:
            for j, state in living.items():
                most = team.turn_rates[j] * step
                turned = max(-most, min(most, left[j]))
                left[j] -= turned
                state[0] += team.speeds[j] * step * math.cos(state[2] + 0.5 * turned)
                state[1] += team.speeds[j] * step * math.sin(state[2] + 0.5 * turned)
                state[2] += turned
            flown += step
        now += flown
        place, reach = np.array(living.pop(i)[:2]), 2.0 * disk.capture_radius
        tree = tree.after(i) if living else tree
    return now


@pytest.mark.parametrize("seed", range(3))
def test_a_pursuer_that_flies_to_each_interception_attains_the_guarantee(seed):
    team, disk = random_game(np.random.default_rng(seed), 3, capture_radius=0.01)
    tree, step = covey.plan_contingent(team, disk), 2e-3
    ends = [stepped_end(team, disk, tree, each, step) for each in permutations(range(3))]
    # Each capture is late by a step at most; until the next, that grows as the pursuer is slow.
    growth = (disk.speed + team.speeds.max()) / (disk.speed - team.speeds.max())
    late = step * (1.0 + growth + growth**2)
    assert tree.survival_time - 1e-4 <= min(ends) <= tree.survival_time + late


def test_answers_gain():
    gains = []
    for seed in range(10):
        game = random_game(np.random.default_rng(seed), 4)
        tree, plan = covey.plan_contingent(*game), covey.plan(*game)
        gains.append(tree.survival_time / plan.survival_time - 1.0)
    assert min(gains) >= -1e-12
    assert np.mean(gains) > 0.005


@SEEDS
def test_nothing_guarantees_more_than_an_upper_bound(seed):
    game = some_game(seed)
    assert covey.plan_contingent(*game).survival_time <= covey.bracket(*game).upper * (1.0 + 1e-9)


@SEEDS
def test_the_part_after_a_capture_is_a_plan_for_those_left(seed):
    team, disk = some_game(seed)
    tree = covey.plan_contingent(team, disk)
    for i in tree.evaders:
        after = tree.after(i)
        assert after.evaders == tuple(j for j in tree.evaders if j != i)
        assert after.depth == tree.depth - 1
        assert all(i not in sequence for sequence in after.critical_sequences)
        first = earliest(team, disk, tree.turns, i)
        assert first + after.survival_time >= tree.survival_time * (1.0 - 1e-9)
    worst = tree.critical_sequences[0]
    first = earliest(team, disk, tree.turns, worst[0])
    after = tree.after(worst[0])
    assert first + after.survival_time == pytest.approx(tree.survival_time, rel=2e-6)


def test_after_the_last_answer_everybody_flies_on():
    team, disk = random_game(np.random.default_rng(5), 3)
    tree = covey.plan_contingent(team, disk, 1)
    last = tree.after(0)
    assert last.depth == 0
    assert last.after(2).evaders == (1,)
    assert last.after(2).goal_headings == pytest.approx(last.goal_headings[:1])


def test_delays_that_cost_much_are_found_in_few_searches(monkeypatch):
    """Each search that fails finds a play that ends earlier, at first by a little."""
    generator, searched = np.random.default_rng(2), []
    positions, headings = generator.uniform(-0.5, 0.5, (3, 2)), generator.uniform(-3.0, 3.0, 3)
    speeds, rates = generator.choice([0.25, 0.9, 0.98], 3), generator.choice([1.5, 20.0, 0.3], 3)
    tree = covey.plan_contingent(
        covey.Team(positions, headings, speeds, rates), covey.PursuerDisk()
    )

    def counted(*arguments):
        searched.append(arguments)
        return survives_delays(*arguments)

    monkeypatch.setattr(delays, "survives_delays", counted)
    least = tree.with_delays
    assert least.survival_time < 0.95 * tree.survival_time
    assert least.resolution <= 1.1 * delays.RESOLUTION * least.survival_time
    assert len(searched) < 20


@SEEDS
def test_no_delay_ends_before_what_is_guaranteed_with_delays(seed):
    team, disk = some_game(seed)
    tree, generator = covey.plan_contingent(team, disk), np.random.default_rng(seed)
    least = tree.with_delays
    assert least.survival_time <= tree.survival_time
    assert least.resolution <= 1.1e-3 * tree.survival_time
    for _ in range(100):
        sequence = generator.permutation(len(team))
        delays = tree.survival_time * generator.exponential(0.1, tree.depth)
        ends = reference_tree.times(team, disk, flat(tree), tree.depth, sequence, list(delays))
        assert ends[-1] >= least.survival_time * (1.0 - 1e-9)


@SEEDS
def test_a_moved_and_turned_game_has_the_moved_and_turned_plan(seed):
    team, disk = some_game(seed)
    angle, shift = 0.7, np.array([3.0, -5.0])
    turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    moved = covey.Team(
        team.positions @ turn.T + shift, team.headings + angle, team.speeds, team.turn_rates
    )
    center = turn @ disk.center + shift
    there = covey.PursuerDisk(center, disk.radius, disk.speed, disk.capture_radius)
    one, other = covey.plan_contingent(team, disk), covey.plan_contingent(moved, there)
    assert other.survival_time == pytest.approx(one.survival_time, rel=1e-5)


def test_the_same_seed_gives_the_same_tree():
    game = random_game(np.random.default_rng(3), 4)
    one, other = (covey.plan_contingent(*game, seed=7) for _ in range(2))
    assert flat(one).tolist() == flat(other).tolist()


def test_one_evader_has_nothing_to_answer():
    game = random_game(np.random.default_rng(3), 1)
    tree = covey.plan_contingent(*game)
    assert tree.depth == 0
    assert tree.survival_time == covey.plan(*game).survival_time
    with pytest.raises(InputError, match=r"i: expected an evader after whose capture others live"):
        tree.after(0)


def test_bad_input_is_refused():
    game = random_game(np.random.default_rng(3), 9)
    with pytest.raises(InputError, match=r"depth: .*at most 20000 turns, got .* at most 4"):
        covey.plan_contingent(*game)
    with pytest.raises(InputError, match="depth: expected"):
        covey.plan_contingent(*game, -1)
    with pytest.raises(InputError, match="seed: expected"):
        covey.plan_contingent(*game, 1, seed=-1)
    with pytest.raises(InputError, match="team: expected"):
        covey.plan_contingent(game[1], game[0])
