"""Batches of games as Gymnasium vector environments: one side acts, the other plays compiled."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from covey.envs.actions import shares_of, velocities_of
from covey.envs.batch import GameBatch, part_of, repeated
from covey.envs.setup import STARTS, TEAM, InitialState
from covey.kernels.maximum.working_set import WorkingSet, new_working_set
from covey.kernels.play.batches import Commitments, fly_pursuers, fly_teams
from covey.kernels.play.policy import TeamMemory
from covey.model import InputError, LastCapture
from covey.planning.compiled_objective import compiled_objective
from covey.planning.open_loop import first_plan, guess_uniforms
from covey.planning.workspace import workspace
from covey.players import CommittedPursuer
from covey.players.compiled import (
    BuiltInPursuer,
    BuiltInTeam,
    pursuer_is_built_in,
    team_is_built_in,
)
from covey.players.names import pursuer_strategy, team_strategy
from covey.players.teams.open_loop import first_memory


class PursuerVectorEnv(GameBatch):
    """Be the pursuers of many games, against teams that plan compiled.

    Parameters
    ----------
    num_envs
        B games.
    evaders
        `IterativeOpenLoop` or `OpenLoop`, or its name. Fewer `starts` and `restarts` plan faster,
        and a little worse.
    **setup
        Fields of `Setup`: the game.

    Raises
    ------
    InputError
        If the game can't be played, or `evaders` is neither of the two.

    Examples
    --------
    >>> from covey.envs import pursuit_v0
    >>> games = pursuit_v0.PursuerVectorEnv(8, team_size=3)
    >>> observations, infos = games.reset(seed=1)
    >>> observations.shape
    (8, 21)
    """

    of_team = False

    def __init__(
        self,
        num_envs: int,
        *,
        evaders: BuiltInTeam | str = TEAM,
        **setup: Any,
    ) -> None:
        team = team_strategy(evaders)
        if not team_is_built_in(team):
            raise InputError(_not_compiled("evaders", team, "PursuerEnv"))
        super().__init__(num_envs, setup)
        n = self.setup.team_size
        self._evaders, self._options = team, team.compiled()
        uniforms = guess_uniforms(0, self._options.restarts, n)
        all_uniforms, lasts = repeated([uniforms, np.zeros(2)], num_envs)
        self._memories = TeamMemory(
            WorkingSet(*repeated(new_working_set(n), num_envs)),
            all_uniforms,
            lasts,
            compiled_objective(LastCapture(), n),
        )

    def begin_opponent(self, b: int, initial: InitialState, seed: int) -> float:
        """Plan, and keep the memory from which replanning starts."""
        team, known = self.setup.team(initial), self.setup.known_at_start(initial)
        first = first_plan(team, known, LastCapture(), seed, self._evaders.starts)
        part_of(self.states.turns, b, self.num_envs)[:] = first.turns
        memory = first_memory(first, seed, self._options.restarts)
        for ours, new in zip(self._memories.working_set, memory.working_set, strict=True):
            part_of(ours, b, self.num_envs)[:] = new
        part_of(self._memories.uniforms, b, self.num_envs)[:] = memory.uniforms
        part_of(self._memories.last, b, self.num_envs)[:] = memory.last
        return first.survival_time

    def fly(self, actions: npt.ArrayLike) -> None:
        """Fly the pursuers in directions (B, 2)."""
        velocities = velocities_of("actions", actions, (self.num_envs, 2), self.setup.pursuer_speed)
        fly_pursuers(
            self.states,
            self.setup.rules,
            velocities,
            self._options,
            self._memories,
            workspace(self.setup.team_size),
        )


class TeamVectorEnv(GameBatch):
    """Be the teams of many games, against pursuers that are compiled.

    Parameters
    ----------
    num_envs
        B games.
    pursuer
        A pursuer that follows sequences: `CommittedPursuer`, `UncommittedPursuer`, `FixedSequence`,
        `BestSequence`, `RandomSequence`; or its name.
    **setup
        Fields of `Setup`: the game.

    Raises
    ------
    InputError
        If the game can't be played, or `pursuer` is none of these five.

    Examples
    --------
    >>> from covey.envs import pursuit_v0
    >>> games = pursuit_v0.TeamVectorEnv(8, team_size=3)
    >>> observations, infos = games.reset(seed=1)
    >>> actions = games.action_space.sample()
    >>> observations, rewards, terminated, truncated, infos = games.step(actions)
    >>> rewards.shape
    (8,)
    """

    of_team = True

    def __init__(
        self,
        num_envs: int,
        *,
        pursuer: BuiltInPursuer | str = CommittedPursuer(),  # noqa: B008 frozen
        **setup: Any,
    ) -> None:
        opponent = pursuer_strategy(pursuer)
        if not pursuer_is_built_in(opponent):
            raise InputError(_not_compiled("pursuer", opponent, "TeamEnv"))
        super().__init__(num_envs, setup)
        n = self.setup.team_size
        self._pursuer = opponent
        # The margin is the same for each game.
        self._commitments = Commitments(
            math.inf, np.zeros(num_envs * n, np.int64), np.zeros(num_envs, np.int64)
        )

    def begin_opponent(self, b: int, initial: InitialState, seed: int) -> float:
        """Set the sequence that the pursuer of game b follows at first, if any."""
        team, known = self.setup.team(initial), self.setup.known_at_start(initial)
        point = self.setup.disk_around(initial.pursuer, 0.0)
        margin, sequence, is_chosen = self._pursuer.commitment(team, point, seed)
        part_of(self._commitments.sequences, b, self.num_envs)[:] = sequence
        self._commitments.chosen[b] = is_chosen
        self._commitments = self._commitments._replace(margin=margin)
        return first_plan(team, known, LastCapture(), seed, STARTS).survival_time

    def fly(self, actions: npt.ArrayLike) -> None:
        """Turn the evaders at rates (B, N), shares of the largest."""
        shares = shares_of("actions", actions, (self.num_envs, self.setup.team_size))
        fly_teams(
            self.states,
            self.setup.rules,
            shares * self.setup.largest_turns,
            self._commitments,
            workspace(self.setup.team_size),
        )


def _not_compiled(name: str, strategy: object, single: str) -> str:
    return (
        f"{name}: expected a strategy that comes with covey, which plays compiled, got "
        f"{strategy!r}; for your own, use gymnasium.vector.SyncVectorEnv over {single}"
    )
