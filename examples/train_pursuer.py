"""A pursuer that learns: PPO against a team of three that flies by iterative open loop.

Needs `pip install 'covey[env]' stable-baselines3`, and a few minutes on two cores.
"""

import sys

import numpy as np
import torch
from gymnasium.spaces import Box
from stable_baselines3 import PPO
from stable_baselines3.common.vec_env import VecEnv

import covey
from covey.envs.pursuit_v0 import PursuerVectorEnv

SPEED, TURN_RATE, REACH, STEP = 0.25, np.pi / 2, 0.02, 0.05  # as in `Setup`
TEAM = covey.IterativeOpenLoop(starts=8, restarts=2)


def interceptions(rows):
    """Where and when a pursuer could meet each evader, if that kept to its announced plan."""
    places, (turn, alive) = rows[..., :2], np.moveaxis(rows[..., 4:], -1, 0)
    heading = np.arctan2(rows[..., 3], rows[..., 2])
    time = np.zeros(turn.shape)
    for _ in range(15):  # each round leaves a quarter of the error: the ratio of the speeds
        turning = np.minimum(time, np.abs(turn) / TURN_RATE)
        half = 0.5 * np.sign(turn) * TURN_RATE * turning
        chord, straight = SPEED * turning * np.sinc(half / np.pi), SPEED * (time - turning)
        flown = chord * np.exp(1j * (heading + half)) + straight * np.exp(1j * (heading + 2 * half))
        meeting = places[..., 0] + 1j * places[..., 1] + flown
        time = np.maximum(np.abs(meeting) - REACH, 0.0)
    return meeting, np.where(alive > 0.0, time, np.inf), heading + turn


def look(rows):
    """What the policy sees of evaders (B, N, 6), and the direction that it calls straight ahead.

    The earliest interception comes first and lies straight ahead, so the policy need not learn
    that the game is the same in every direction, and for every numbering of the evaders.
    """
    meeting, time, goal = interceptions(rows)
    order = np.argsort(time, axis=1)
    meeting, time, goal = (np.take_along_axis(a, order, axis=1) for a in (meeting, time, goal))
    ahead = np.exp(1j * np.angle(meeting[:, :1]))
    meeting, goal = meeting / ahead, np.exp(1j * goal) / ahead
    seen = [meeting.real, meeting.imag, time, goal.real, goal.imag, np.ones(time.shape)]
    seen = np.where(np.isfinite(time)[..., None], np.stack(seen, axis=-1), 0.0)
    return seen.reshape(len(rows), -1).astype(np.float32), ahead[:, 0]


def directions(actions, ahead):
    """Turn the policy's actions (B, 2) back into the axes of the environment."""
    turned = (actions[:, 0] + 1j * actions[:, 1]) * ahead
    return np.column_stack([turned.real, turned.imag])


class Games(VecEnv):
    """The batch as Stable-Baselines3 wants it, seen through `look`."""

    def __init__(self, count, size):
        self.games = PursuerVectorEnv(count, team_size=size, evaders=TEAM)
        sight = Box(-np.inf, np.inf, (6 * size,), np.float32)
        super().__init__(count, sight, self.games.single_action_space)
        self.shape = (-1, size, 6)

    def see(self, observed):
        return look(observed[:, :-3].astype(float).reshape(self.shape))

    def reset(self):
        seen, self.ahead = self.see(self.games.reset(seed=self._seeds[0])[0])
        return seen

    def step_async(self, actions):
        self.directions = directions(actions, self.ahead)

    def step_wait(self):
        observed, rewards, ended, late, infos = self.games.step(self.directions)
        seen, self.ahead = self.see(observed)
        told = [{} for _ in range(self.num_envs)]
        for b in np.flatnonzero(ended | late):
            last, _ = self.see(infos["final_obs"][b][None])
            told[b] = {"terminal_observation": last[0], "TimeLimit.truncated": bool(late[b])}
        return seen, rewards.astype(np.float32), ended | late, told

    def close(self):
        self.games.close()

    def get_attr(self, name, indices=None):  # noqa: ARG002 as its base
        return [getattr(self.games, name, None)] * self.num_envs

    def set_attr(self, name, value, indices=None):
        raise NotImplementedError

    def env_method(self, name, *arguments, indices=None, **more):
        raise NotImplementedError

    def env_is_wrapped(self, wrapper, indices=None):  # noqa: ARG002 as its base
        return [False] * self.num_envs


def train(steps, size=3, seed=0):
    torch.set_num_threads(1)  # for so small a network, a second one costs more than it brings
    games = Games(64, size)
    model = PPO(
        "MlpPolicy",
        games,
        learning_rate=lambda left: 6e-4 * max(left, 0.03),
        n_steps=128,
        batch_size=2048,
        n_epochs=8,
        gamma=1.0,  # a second late in the game counts as much as one now
        policy_kwargs={"net_arch": [128, 128], "log_std_init": -1.0},
        seed=seed,
        device="cpu",
    )
    return model.learn(steps)


def pursuer_of(model, size):
    """The policy as a strategy of covey, which `covey.simulate` and every room can play."""

    def decide(situation):
        rows, n = np.zeros((1, size, 6)), len(situation.evaders)
        team, pursuer = situation.team, situation.pursuer
        rows[0, :n, :2] = team.positions - pursuer.center
        rows[0, :n, 2] = team.speeds * np.cos(team.headings)
        rows[0, :n, 3] = team.speeds * np.sin(team.headings)
        rows[0, :n, 4], rows[0, :n, 5] = situation.turns, 1.0
        seen, ahead = look(rows)
        velocity = directions(model(seen), ahead)[0]
        return covey.Fly(tuple(pursuer.speed * velocity / np.hypot(*velocity)))

    return decide


def survival_times(pursuer, starts):
    """Play the same starts, none of which was trained on; return (starts,) survival times."""
    generator = np.random.default_rng(2014)
    times = []
    for _ in range(starts):
        positions = generator.uniform(-0.5, 0.5, (3, 2))
        team = covey.Team(positions, np.arctan2(positions[:, 1], positions[:, 0]))
        game = covey.simulate(
            team,
            covey.PursuerDisk(capture_radius=REACH),
            evaders=TEAM,
            pursuer=pursuer,
            sensing="visible",
            update_time=STEP,
            time_limit=20.0,
        )
        times.append(min(game.survival_time, 20.0))
    return np.array(times)


def straight_ahead(seen):
    return np.tile([1.0, 0.0], (len(seen), 1))


def main(steps=1_000_000, starts=300):
    model = train(steps)
    pursuers = {
        "committed": covey.CommittedPursuer(),
        "learned": pursuer_of(lambda seen: model.predict(seen, deterministic=True)[0], 3),
        "earliest interception": pursuer_of(straight_ahead, 3),
    }
    times = {name: survival_times(pursuer, starts) for name, pursuer in pursuers.items()}
    print(f"{'pursuer':24}{'mean survival time':>20}{'share of the committed':>24}")
    for name, own in times.items():
        print(f"{name:24}{own.mean():20.3f}{times['committed'].mean() / own.mean():24.1%}")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
