"""The first guess of a search: everybody flies straight away from the disk's centre."""

import math

import numpy as np
import pytest

from covey.kernels.maximum.initial_guesses import Guesses, new_elite
from covey.kernels.maximum.multistart import RADIUS_RANDOM, multistart
from covey.kernels.maximum.problem import Iterate, Options, Problem
from covey.kernels.maximum.working_set import new_working_set
from covey.model import LastCapture
from covey.planning.border import pursuit_of
from covey.planning.compiled_objective import compiled_objective
from covey.planning.workspace import workspace
from random_games import random_game


@pytest.mark.parametrize("count", [1, 4])
def test_the_first_guess_is_flight_away_from_a_disk_anywhere(count):
    team, disk = random_game(np.random.default_rng(count), count)
    assert disk.center.any()
    problem = Problem(team.as_rows(), pursuit_of(disk), compiled_objective(LastCapture(), count))
    iterate = Iterate(np.zeros(count), new_working_set(count))
    guesses = Guesses(np.empty((0, count)), new_elite(count), 0, 1)
    no_step = Options(RADIUS_RANDOM, 1e-9, 0)
    multistart(problem, guesses, no_step, -math.inf, iterate, workspace(count))
    away = np.arctan2(*(team.positions - disk.center).T[::-1])
    assert np.cos(team.headings + iterate.turns - away) == pytest.approx(np.ones(count))
