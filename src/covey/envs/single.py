"""The game as a Gymnasium environment: one side acts, a strategy plays the other."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium import Space

from covey.envs.actions import shares_of, velocity_of
from covey.envs.canvas import MODES, RATE, Canvas
from covey.envs.episode import Episode, Seen, Velocity
from covey.envs.setup import TEAM, Setup
from covey.envs.spaces import direction_space, observation_space, steering_space
from covey.model import InputError
from covey.model.validation import Floats
from covey.players import CommittedPursuer
from covey.players.names import pursuer_strategy, team_strategy
from covey.simulation import PursuerPolicy, PursuerStrategy, TeamPolicy, TeamStrategy


class _OneSide(gymnasium.Env[Seen, npt.ArrayLike]):
    """What both environments share: one game after another, and pictures."""

    metadata: dict[str, Any] = {"render_modes": MODES, "render_fps": RATE}  # noqa: RUF012 as declared
    _evaders: TeamStrategy | TeamPolicy | None = None
    _pursuer: PursuerStrategy | PursuerPolicy | None = None
    _episode: Episode | None = None

    def __init__(self, render_mode: str | None, setup: dict[str, Any]) -> None:
        self.setup = Setup(**setup)
        self.observation_space: Space[Any] = observation_space(self.setup)
        self._canvas = Canvas(render_mode, 0.5 * self.setup.side)
        self.render_mode = self._canvas.mode

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Seen, dict[str, Any]]:
        """Start a game: drawn, or at the "positions" and "headings" in `options`."""
        super().reset(seed=seed)
        initial = self.setup.draw(self.np_random, options)
        planning_seed = int(self.np_random.integers(2**31))
        episode = Episode(self.setup, initial, planning_seed, self._evaders, self._pursuer)
        self._canvas.begin(episode)
        self._episode = episode
        return self._seen(episode), episode.info()

    def render(self) -> npt.NDArray[np.uint8] | None:
        """Return a picture (height, width, 3) in the mode "rgb_array"."""
        return self._canvas.render()

    def close(self) -> None:
        """Close the window, if there is one."""
        self._canvas.close()

    def _seen(self, episode: Episode) -> Seen:
        raise NotImplementedError

    def _step(
        self, shares: Floats | None, velocity: Velocity | None, sign: float
    ) -> tuple[Seen, float, bool, bool, dict[str, Any]]:
        episode = self._episode
        if episode is None:
            raise InputError("step: expected a game to be begun; call reset() first")
        reward = sign * episode.step(shares, velocity)
        self._canvas.update()
        return self._seen(episode), reward, episode.ended, episode.late, episode.info()


class PursuerEnv(_OneSide):
    """Be the pursuer, against a team that plays by a strategy.

    Parameters
    ----------
    evaders
        The team's strategy, its name, or a function of a `Situation`.
    render_mode
        None, "rgb_array" or "human".
    **setup
        Fields of `Setup`: the game.

    Examples
    --------
    >>> from covey.envs import pursuit_v0
    >>> env = pursuit_v0.PursuerEnv(team_size=3)
    >>> observation, info = env.reset(seed=1)
    >>> observation.shape
    (21,)
    >>> observation, reward, terminated, truncated, info = env.step([1.0, 0.0])
    >>> reward < 0.0  # the pursuer pays the time of a step
    True
    """

    def __init__(
        self,
        *,
        evaders: TeamStrategy | TeamPolicy | str = TEAM,
        render_mode: str | None = None,
        **setup: Any,
    ) -> None:
        super().__init__(render_mode, setup)
        self._evaders = team_strategy(evaders)
        self.action_space: Space[Any] = direction_space()

    def step(self, action: npt.ArrayLike) -> tuple[Seen, float, bool, bool, dict[str, Any]]:
        """Fly in a direction (2,) until the next update or capture; the reward is -(its time)."""
        velocity = velocity_of("action", action, self.setup.pursuer_speed)
        return self._step(None, velocity, -1.0)

    def _seen(self, episode: Episode) -> Seen:
        return episode.seen_by_pursuer()


class TeamEnv(_OneSide):
    """Be the team, against a pursuer that plays by a strategy.

    Parameters
    ----------
    pursuer
        The pursuer's strategy, its name, or a function of a `Situation`.
    render_mode
        None, "rgb_array" or "human".
    **setup
        Fields of `Setup`: the game.

    Examples
    --------
    >>> from covey.envs import pursuit_v0
    >>> env = pursuit_v0.TeamEnv(team_size=3, pursuer="committed")
    >>> observation, info = env.reset(seed=1)
    >>> observation, reward, terminated, truncated, info = env.step([0.0, 0.5, -0.5])
    >>> reward > 0.0  # the team is paid the time of a step
    True
    """

    def __init__(
        self,
        *,
        pursuer: PursuerStrategy | PursuerPolicy | str = CommittedPursuer(),  # noqa: B008 frozen
        render_mode: str | None = None,
        **setup: Any,
    ) -> None:
        super().__init__(render_mode, setup)
        self._pursuer = pursuer_strategy(pursuer)
        self.action_space: Space[Any] = steering_space(self.setup.team_size)

    def step(self, action: npt.ArrayLike) -> tuple[Seen, float, bool, bool, dict[str, Any]]:
        """Turn at rates (N,) until the next update or capture; captured evaders' are ignored."""
        shares = shares_of("action", action, (self.setup.team_size,))
        return self._step(shares, None, 1.0)

    def _seen(self, episode: Episode) -> Seen:
        return episode.seen_by_team()
