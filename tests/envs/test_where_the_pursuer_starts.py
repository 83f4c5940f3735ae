"""Where environments put the pursuer at time 0, and what the team knows of that."""

from __future__ import annotations

import math

import numpy as np
import pytest

from covey.envs import pursuit_v0
from covey.envs.setup import Setup

RADIUS = 0.4
TWO = {"team_size": 2, "disk_radius": RADIUS, "time_limit": 1.0}
QUICK = {"evaders": lambda situation: np.zeros(len(situation.evaders))}


def starts(**fields):
    setup, generator = Setup(**(TWO | fields)), np.random.default_rng(0)
    return np.array([setup.draw(generator, None).pursuer for _ in range(2000)])


@pytest.mark.parametrize("sensing", ["visible", "hidden"])
def test_anywhere_in_the_disk_with_equal_chance(sensing):
    pursuers = starts(sensing=sensing)
    distances = np.hypot(*pursuers.T)
    assert distances.max() <= RADIUS
    # Equal areas: a share s² lies within s of the radius. Bounds of four standard errors.
    for share in (0.25, 0.5, 0.75, 0.9):
        inside = (distances <= share * RADIUS).mean()
        error = math.sqrt(share**2 * (1.0 - share**2) / len(pursuers))
        assert inside == pytest.approx(share**2, abs=4.0 * error)
    # All directions: four quadrants, each with a quarter.
    quadrants = 2 * (pursuers[:, 0] > 0.0) + (pursuers[:, 1] > 0.0)
    counts = np.bincount(quadrants, minlength=4) / len(pursuers)
    assert counts == pytest.approx(0.25, abs=4.0 * math.sqrt(0.1875 / len(pursuers)))


def test_without_a_disk_at_the_origin():
    assert not starts(disk_radius=0.0).any()


def test_the_team_knows_the_disk_and_not_where_in_it_a_hidden_pursuer_is():
    setup = Setup(**TWO, sensing="hidden")
    initial = setup.draw(np.random.default_rng(1), None)
    assert np.hypot(*initial.pursuer) > 0.01
    known, state = setup.known_at_start(initial), setup.first_state(initial)
    assert (*known.center, known.radius) == (0.0, 0.0, RADIUS)
    assert state.disk[:3].tolist() == [0.0, 0.0, RADIUS]
    assert state.pursuer[:2].tolist() == initial.pursuer.tolist()


def test_the_team_sees_where_a_visible_pursuer_is():
    setup = Setup(**TWO, sensing="visible")
    initial = setup.draw(np.random.default_rng(1), None)
    known, state = setup.known_at_start(initial), setup.first_state(initial)
    assert (*known.center, known.radius) == (*initial.pursuer, 0.0)
    assert state.pursuer[:2].tolist() == initial.pursuer.tolist()


def test_a_hidden_pursuer_observes_its_place_in_the_disk_in_every_environment():
    """The last three numbers of an observation are the disk, as seen from who observes."""
    setup = {**TWO, "sensing": "hidden"}
    parallel, _ = pursuit_v0.parallel_env(**setup).reset(seed=7)
    single, _ = pursuit_v0.PursuerEnv(**setup, **QUICK).reset(seed=7)
    batch, _ = pursuit_v0.PursuerVectorEnv(3, **setup).reset(seed=7)
    x, y, radius = parallel["pursuer_0"][-3:].tolist()
    assert radius == np.float32(RADIUS)
    assert 0.01 < math.hypot(x, y) <= RADIUS
    np.testing.assert_array_equal(single[-3:], parallel["pursuer_0"][-3:])
    np.testing.assert_array_equal(batch[0, -3:], parallel["pursuer_0"][-3:])
    assert len({tuple(row[-3:-1]) for row in batch.tolist()}) == 3  # each game has its own place


def test_a_team_observes_the_same_wherever_in_the_disk_the_pursuer_is():
    start = {"positions": [[0.3, 0.0], [0.0, 0.4]], "headings": [0.0, math.pi / 2]}
    env = pursuit_v0.parallel_env(**TWO, sensing="hidden")
    seen = [env.reset(seed=seed, options=start)[0] for seed in (1, 2)]
    np.testing.assert_array_equal(seen[0]["evader_0"], seen[1]["evader_0"])
    assert not np.array_equal(seen[0]["pursuer_0"], seen[1]["pursuer_0"])
    np.testing.assert_allclose(seen[0]["evader_0"][-3:], [-0.3, 0.0, RADIUS], atol=1e-7)
