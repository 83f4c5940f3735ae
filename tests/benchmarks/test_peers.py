"""The peers that the benchmarks compare with solve the same problem, and solve it right."""

from __future__ import annotations

import numpy as np
import pytest

import covey
from kernels import kernel_calls, reference_game
from peers.didp import Didp
from peers.enumeration import Sequences, times_and_gradients
from peers.ipopt import Ipopt
from peers.peer import SAME
from peers.slsqp import Slsqp, SlsqpByDifferences
from random_games import random_game, random_turns

OPTIONS = [{}, {"radius": 0.1}, {"radius": 0.05, "capture_radius": 0.03}]


@pytest.mark.parametrize("options", OPTIONS, ids=str)
@pytest.mark.parametrize("count", [1, 2, 3, 4, 5])
def test_their_times_and_gradients_are_those_of_the_kernels(count, options):
    generator = np.random.default_rng([count, len(options)])
    sequences = Sequences(count)
    for _ in range(5):
        team, disk = random_game(generator, count, **options)
        turns = random_turns(generator, count)
        times, gradients = times_and_gradients(sequences, team, disk, turns)
        orders = reference_game.every_sequence(count)
        wanted = kernel_calls.times_of_sequences(team, disk, orders)(turns)
        assert times == pytest.approx(wanted, rel=1e-12, abs=0.0)
        for k in generator.integers(0, len(orders), 5):
            gradient, _ = kernel_calls.derivatives(team, disk, turns, orders[k])
            assert gradients[k] == pytest.approx(gradient, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("options", OPTIONS, ids=str)
@pytest.mark.parametrize("peer", [Slsqp, SlsqpByDifferences, Ipopt], ids=lambda peer: peer.name)
def test_from_near_a_maximum_they_come_to_it(peer, options):
    """Interior points stay away from corners at first, so IPOPT now and then leaves for another."""
    generator = np.random.default_rng(len(options))
    solver, gains = peer(3), []
    for _ in range(6):
        team, disk = random_game(generator, 3, **options)
        plan = covey.plan(team, disk)
        near = np.clip(plan.turns + generator.uniform(-0.01, 0.01, 3), -np.pi, np.pi)
        memory = None
        for _ in range(2):  # then with what it remembers, if it does
            turns, memory = solver.solve(team, disk, near, memory)
            found = covey.guaranteed_survival(team, disk, turns).time
            gains.append(found / plan.survival_time - 1.0)
    assert max(gains) <= SAME
    assert np.mean(np.abs(gains) <= SAME) >= (0.7 if peer is Ipopt else 1.0)


@pytest.mark.parametrize("options", OPTIONS, ids=str)
@pytest.mark.parametrize("count", [1, 2, 7, 9])
def test_didppy_finds_the_minimum_over_all_sequences_of_straight_flight(count, options):
    generator = np.random.default_rng([count, len(options)])
    team, disk = random_game(generator, count, **options)
    found = Didp().certify(team, disk, 60.0)
    assert found.exact
    assert found.lower == pytest.approx(found.upper, rel=1e-12)
    ours = covey.guaranteed_survival(team, disk, np.zeros(count))
    assert found.upper == pytest.approx(ours.time, rel=1e-12)


def test_the_minimum_of_fourteen_evaders_in_straight_flight_is_that_of_didppy():
    generator = np.random.default_rng((14, 1))
    positions = generator.uniform(-0.5, 0.5, (14, 2))
    disk = covey.PursuerDisk()
    team = covey.Team(positions, disk.headings_away(positions))
    found = Didp().certify(team, disk, 120.0)
    assert found.exact
    ours = covey.guaranteed_survival(team, disk, np.zeros(14))
    assert ours.time == pytest.approx(found.upper, rel=1e-12)
