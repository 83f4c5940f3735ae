"""Players of environments that tests need, and episodes played to the end."""

from __future__ import annotations

import numpy as np

ROW = 6


def rows_of(seen, count):
    """The evaders' rows (..., N, 6) of an observation."""
    return seen[..., : ROW * count].reshape(*seen.shape[:-1], count, ROW)


def towards_nearest(seen, count):
    """Directions (..., 2) from the observer to the nearest evader alive."""
    rows = rows_of(seen, count).astype(float)
    distances = np.where(rows[..., 5] > 0.0, np.hypot(rows[..., 0], rows[..., 1]), np.inf)
    nearest = distances.argmin(axis=-1)[..., None, None]
    return np.take_along_axis(rows[..., :2], nearest, axis=-2)[..., 0, :]


def play_parallel(env, generator, **begun):
    """Chase the nearest, evaders steer at random; return all that `reset` and `step` returned."""
    returned = [env.reset(**begun)]
    while env.agents:
        actions = {agent: generator.uniform(-1.0, 1.0, 1) for agent in env.agents}
        if "pursuer_0" in actions:
            actions["pursuer_0"] = towards_nearest(
                returned[-1][0]["pursuer_0"], env.setup.team_size
            )
        returned.append(env.step(actions))
    return returned


def play_single(env, decide, **begun):
    """Let `decide` act on what is seen; return all that `reset` and `step` returned."""
    returned = [env.reset(**begun)]
    over = False
    while not over:
        returned.append(env.step(decide(returned[-1][0])))
        over = returned[-1][2] or returned[-1][3]
    return returned
