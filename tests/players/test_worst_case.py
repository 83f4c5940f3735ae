"""The worst case: brute force over all sequences, hand cases, the guarantee."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import covey
from covey.players import DelayedSequence, WorstCaseScope
from random_games import fleeing, random_game


def hold_course(situation):
    """A plain function as a strategy."""
    return np.zeros(len(situation.evaders))


class Homing:
    """A strategy with a memory: the living turn to where the last capture happened."""

    def start(self, seed):
        goal = np.zeros(2)
        seen = None

        def turns(situation):
            nonlocal goal, seen
            if seen not in (None, situation.evaders):
                goal = situation.disk.center
            seen = situation.evaders
            away = situation.team.positions - goal
            return covey.turns_to(situation.team, np.arctan2(away[:, 1], away[:, 0]))

        return turns


def brute_force(team, disk, evaders, delays=None, **settings):
    """The least value of all games, each played from the start."""
    count = len(team)
    sequences = itertools.permutations(range(count))
    pursuers = [covey.FixedSequence(sequence) for sequence in sequences]
    if delays is not None:
        pursuers = [
            DelayedSequence(each.sequence, waits)
            for each in pursuers
            for waits in itertools.product(delays, repeat=count)
        ]
    return min(
        covey.simulate(
            team, disk, evaders=evaders, pursuer=pursuer, sensing="hidden", **settings
        ).value
        for pursuer in pursuers
    )


@pytest.mark.parametrize(
    "evaders",
    [
        covey.IterativeOpenLoop(),
        covey.IterativeOpenLoop(replan_time=0.3),
        covey.OpenLoop(),
        hold_course,
        Homing(),
    ],
)
@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_equals_brute_force_over_all_sequences(count, evaders):
    team, disk = random_game(
        np.random.default_rng(count), count, mixed=count % 2 == 1, radius=0.05, capture_radius=0.02
    )
    least = brute_force(team, disk, evaders, update_time=0.1)
    found = covey.worst_case(team, disk, evaders=evaders, update_time=0.1)
    assert found.survival_time == pytest.approx(least, rel=1e-12)
    assert found.scope is WorstCaseScope.PROMPT
    assert found.delays == (0.0,) * count


@pytest.mark.parametrize(
    "evaders",
    [
        covey.ConstantHeading(starts=1, restarts=1),
        covey.KnownSequence(),
        covey.LargestDistance(),
        covey.SmallestDanger(),
        covey.StraightAway(),
        covey.HoldCourse(),
        covey.Contingent(),
    ],
    ids=lambda evaders: type(evaders).__name__,
)
def test_every_team_that_comes_with_the_package(evaders):
    team, disk = random_game(np.random.default_rng(7), 3)
    least = brute_force(team, disk, evaders, update_time=0.2)
    found = covey.worst_case(team, disk, evaders=evaders, update_time=0.2)
    assert found.survival_time == pytest.approx(least, rel=1e-12)


@pytest.mark.parametrize(
    "objective",
    [covey.TotalSurvival(), covey.ExpectedSurvival(), covey.ExpectedSurvival(measure="last")],
    ids=str,
)
@pytest.mark.parametrize("evaders", [covey.IterativeOpenLoop(), covey.OpenLoop(), Homing()])
def test_the_worst_for_other_objectives(evaders, objective):
    team, disk = random_game(np.random.default_rng(11), 3, capture_radius=0.02)
    options = {"evaders": evaders, "update_time": 0.1, "objective": objective}
    found = covey.worst_case(team, disk, **options)
    assert found.value == pytest.approx(brute_force(team, disk, **options), rel=1e-12)
    assert found.survival_time == found.capture_times[-1]


@pytest.mark.parametrize(
    "evaders", [covey.IterativeOpenLoop(), covey.IterativeOpenLoop(replan_time=0.3), Homing()]
)
@pytest.mark.parametrize("count", [2, 3])
def test_equals_brute_force_over_all_delays(count, evaders):
    team, disk = random_game(np.random.default_rng(count), count)
    least = brute_force(team, disk, evaders, (0.0, 0.25), update_time=0.1)
    found = covey.worst_case(team, disk, evaders=evaders, delays=[0, 0.25], update_time=0.1)
    assert found.survival_time == pytest.approx(least, rel=1e-12)
    assert found.scope is WorstCaseScope.DELAYED


def test_can_be_played_again():
    team, disk = random_game(np.random.default_rng(3), 5)
    found = covey.worst_case(team, disk, update_time=0.05)
    game = covey.simulate(
        team,
        disk,
        pursuer=covey.FixedSequence(found.sequence),
        sensing="hidden",
        update_time=0.05,
    )
    assert tuple(game.capture_times.tolist()) == found.capture_times
    assert game.guarantee <= found.survival_time * (1.0 + 1e-9)


@pytest.mark.parametrize("seed", range(20))
def test_is_between_the_guarantee_and_any_game(seed):
    generator = np.random.default_rng(seed)
    team, disk = random_game(generator, 3, radius=0.1 * (seed % 2))
    worst = covey.worst_case(team, disk, update_time=0.1)
    late = covey.worst_case(team, disk, delays=[0.0, 0.1, 0.5], update_time=0.1)
    game = covey.simulate(
        team, disk, pursuer=covey.FixedSequence(generator.permutation(3)), update_time=0.1
    )
    assert game.guarantee <= late.survival_time * (1.0 + 1e-9)
    assert late.survival_time <= worst.survival_time <= game.survival_time


@pytest.mark.parametrize("seed", range(2))
def test_a_team_that_answers_captures_keeps_its_promise_in_its_worst_case(seed):
    team, disk = random_game(np.random.default_rng(seed), 3, radius=0.1 * (seed % 2))
    evaders, delays = covey.Contingent(depth=1), [0.0, 0.3]
    promised = covey.plan_contingent(team, disk, depth=1)
    worst = covey.worst_case(team, disk, evaders=evaders, update_time=0.5)
    late = covey.worst_case(team, disk, evaders=evaders, delays=delays, update_time=0.5)
    assert promised.survival_time * (1.0 - 1e-9) <= worst.survival_time
    assert promised.with_delays.survival_time <= late.survival_time <= worst.survival_time
    pursuer = DelayedSequence(late.sequence, late.delays)
    game = covey.simulate(team, disk, evaders=evaders, pursuer=pursuer, update_time=0.5)
    assert tuple(game.capture_times.tolist()) == late.capture_times


def test_waiting_delays_a_single_capture_by_so_much():
    """The capture waits from the update at 1.5 on, the first after contact at 4/3, for 0.75."""
    found = covey.worst_case(fleeing(1.0), covey.PursuerDisk(), delays=[0.75], update_time=0.5)
    assert found.survival_time == pytest.approx(2.5, rel=1e-15)
    assert (found.sequence, found.delays) == ((0,), (0.75,))
    late = covey.worst_case(fleeing(1.0), covey.PursuerDisk(), delays=[10.0], update_time=0.5)
    assert late.survival_time == pytest.approx(11.5, rel=1e-15)


def test_shares_beginnings_and_prunes():
    team, disk = random_game(np.random.default_rng(1), 5)
    found = covey.worst_case(team, disk, update_time=0.1)
    assert 15 <= found.flights < 325


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"delays": []}, "delays: expected at least one"),
        ({"delays": [-0.1]}, "delays: expected a finite number >= 0"),
        ({"delays": [math.nan]}, "delays: expected a finite number >= 0"),
        ({"update_time": 0.0}, "update_time"),
        ({"evaders": covey.OpenLoop}, "expected a strategy"),
    ],
)
def test_rejects_bad_input(arguments, message):
    team, disk = random_game(np.random.default_rng(0), 2)
    with pytest.raises(covey.InputError, match=message):
        covey.worst_case(team, disk, **arguments)


def test_delayed_sequence_needs_a_delay_for_each_capture():
    with pytest.raises(covey.InputError, match="expected 2 delays"):
        DelayedSequence([0, 1], [0.5])
