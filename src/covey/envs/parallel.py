"""The PettingZoo environment: every evader and the pursuer an agent."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt
from gymnasium.spaces import Box
from gymnasium.utils import seeding
from pettingzoo import AECEnv, ParallelEnv
from pettingzoo.utils.conversions import parallel_to_aec

from covey.envs.actions import shares_of, velocity_of
from covey.envs.canvas import MODES, RATE, Canvas
from covey.envs.episode import Episode, Seen
from covey.envs.setup import Setup
from covey.envs.spaces import direction_space, observation_space, steering_space
from covey.model import InputError
from covey.model.validation import Floats
from covey.simulation import PursuerPolicy, PursuerStrategy, TeamPolicy, TeamStrategy

PURSUER = "pursuer_0"
"""Its name as an agent; the evaders are "evader_0", "evader_1", ..."""


class PursuitEnv(ParallelEnv[str, Seen, npt.ArrayLike]):  # type: ignore[misc] # it has no types
    """A team of evaders against one faster pursuer; `covey.envs.pursuit_v0` describes it.

    Parameters
    ----------
    evaders, pursuer
        The strategy of a side, whose players are no agents then; None: its players are agents.
    render_mode
        None, "rgb_array" or "human".
    **setup
        Fields of `Setup`: the game.

    Raises
    ------
    InputError
        If the game can't be played, or both sides have strategies.

    Examples
    --------
    >>> from covey.envs import pursuit_v0
    >>> env = pursuit_v0.PursuitEnv(team_size=2)
    >>> env.possible_agents
    ['evader_0', 'evader_1', 'pursuer_0']
    """

    metadata: ClassVar[dict[str, Any]] = {
        "name": "pursuit_v0",
        "render_modes": MODES,
        "render_fps": RATE,
        "is_parallelizable": True,
    }

    def __init__(
        self,
        *,
        evaders: TeamStrategy | TeamPolicy | None = None,
        pursuer: PursuerStrategy | PursuerPolicy | None = None,
        render_mode: str | None = None,
        **setup: Any,
    ) -> None:
        if evaders is not None and pursuer is not None:
            raise InputError(
                "evaders, pursuer: expected a strategy for one side at most, got both; "
                "covey.simulate plays two strategies"
            )
        self.setup = Setup(**setup)
        self._strategies = evaders, pursuer
        self._evaders = {f"evader_{i}": i for i in range(self.setup.team_size)}
        self.possible_agents = [] if evaders is not None else list(self._evaders)
        self.possible_agents += [] if pursuer is not None else [PURSUER]
        self.agents: list[str] = []
        self.observation_spaces = {
            agent: observation_space(self.setup) for agent in self.possible_agents
        }
        self.action_spaces = {
            agent: direction_space() if agent == PURSUER else steering_space(1)
            for agent in self.possible_agents
        }
        self._canvas = Canvas(render_mode, 0.5 * self.setup.side)
        self.render_mode = self._canvas.mode
        self._generator, _ = seeding.np_random()

    def observation_space(self, agent: str) -> Box:
        """Return the space of an agent's observations."""
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> Box:
        """Return the space of an agent's actions."""
        return self.action_spaces[agent]

    def reset(
        self, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[dict[str, Seen], dict[str, dict[str, Any]]]:
        """Start a game: drawn, or at the "positions" and "headings" in `options`."""
        if seed is not None:
            self._generator, _ = seeding.np_random(seed)
        initial = self.setup.draw(self._generator, options)
        seed = int(self._generator.integers(2**31))
        self._episode = Episode(self.setup, initial, seed, *self._strategies)
        self.agents = list(self.possible_agents)
        self._canvas.begin(self._episode)
        return self._seen(self.agents), self._infos(self.agents)

    def step(
        self, actions: Mapping[str, npt.ArrayLike]
    ) -> tuple[
        dict[str, Seen],
        dict[str, float],
        dict[str, bool],
        dict[str, bool],
        dict[str, dict[str, Any]],
    ]:
        """Fly until the next update or capture, with one action for each of `agents`."""
        if set(actions) != set(self.agents):
            raise InputError(f"actions: expected one for each of {self.agents}, got {[*actions]}")
        if not actions:
            return {}, {}, {}, {}, {}
        episode, acting = self._episode, self.agents
        sharing = len(episode.living)
        elapsed = episode.step(*self._decisions(actions))
        rewards = {a: -elapsed if a == PURSUER else elapsed / sharing for a in acting}
        terminations = {agent: self._is_out(agent) for agent in acting}
        truncations = {agent: episode.late and not terminations[agent] for agent in acting}
        self.agents = [a for a in acting if not (terminations[a] or truncations[a])]
        self._canvas.update()
        return self._seen(acting), rewards, terminations, truncations, self._infos(acting)

    def render(self) -> npt.NDArray[np.uint8] | None:
        """Return a picture (height, width, 3) in the mode "rgb_array"."""
        return self._canvas.render()

    def close(self) -> None:
        """Close the window, if there is one."""
        self._canvas.close()

    def _decisions(
        self, actions: Mapping[str, npt.ArrayLike]
    ) -> tuple[Floats | None, tuple[float, float] | None]:
        """Return all turn rates (N,) and the pursuer's velocity; None for a strategy's side."""
        shares = velocity = None
        if self._strategies[0] is None:
            shares = np.zeros(self.setup.team_size)
            for agent, action in actions.items():
                if agent != PURSUER:
                    shares[self._evaders[agent]] = shares_of(agent, action, (1,))[0]
        if PURSUER in actions:
            velocity = velocity_of(PURSUER, actions[PURSUER], self.setup.pursuer_speed)
        return shares, velocity

    def _is_out(self, agent: str) -> bool:
        if agent == PURSUER:
            return self._episode.ended
        return self._evaders[agent] not in self._episode.living

    def _seen(self, agents: list[str]) -> dict[str, Seen]:
        return {
            agent: self._episode.seen_by_pursuer()
            if agent == PURSUER
            else self._episode.seen_by(self._evaders[agent])
            for agent in agents
        }

    def _infos(self, agents: list[str]) -> dict[str, dict[str, Any]]:
        return {agent: self._episode.info() for agent in agents}


def parallel_env(**arguments: Any) -> PursuitEnv:
    """Return the parallel environment; see `PursuitEnv` for the arguments.

    Examples
    --------
    >>> from covey.envs import pursuit_v0
    >>> env = pursuit_v0.parallel_env(team_size=3, sensing="hidden")
    >>> observations, infos = env.reset(seed=1)
    >>> actions = {agent: env.action_space(agent).sample() for agent in env.agents}
    >>> observations, rewards, terminations, truncations, infos = env.step(actions)
    >>> sorted(rewards)
    ['evader_0', 'evader_1', 'evader_2', 'pursuer_0']
    """
    return PursuitEnv(**arguments)


def env(**arguments: Any) -> AECEnv[str, Seen, npt.ArrayLike]:
    """Return the same environment with agents that act one after another (PettingZoo's AEC).

    Examples
    --------
    >>> from covey.envs import pursuit_v0
    >>> env = pursuit_v0.env(team_size=2)
    >>> env.reset(seed=1)
    >>> env.agent_selection
    'evader_0'
    >>> env.step(env.action_space("evader_0").sample())
    >>> env.agent_selection
    'evader_1'
    """
    return parallel_to_aec(PursuitEnv(**arguments))
