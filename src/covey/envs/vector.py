"""Batches of games in which one side acts and the other plays compiled: Gymnasium's vector view."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from covey.envs.actions import shares_of, velocities_of
from covey.envs.games import Games, stacked
from covey.envs.setup import STARTS, TEAM, Start
from covey.kernels.maximum.multistart import search_scratch
from covey.kernels.maximum.sqp import ascent_scratch
from covey.kernels.maximum.working_set import Columns, make_columns
from covey.kernels.play.batches import fly_pursuers, fly_teams
from covey.kernels.play.policy import TeamMemory
from covey.model import InputError, LastCapture
from covey.planning import plan
from covey.planning.compiled_objective import aim_of
from covey.planning.open_loop import start_noise
from covey.players import CommittedPursuer
from covey.players.compiled import (
    BuiltInPursuer,
    BuiltInTeam,
    pursuer_is_built_in,
    team_is_built_in,
)
from covey.players.teams.open_loop import first_memory


class PursuerVectorEnv(Games):
    """Be the pursuers of many games, against teams that plan compiled.

    Parameters
    ----------
    num_envs
        B games.
    evaders
        `IterativeOpenLoop` or `OpenLoop`. Fewer `starts` and `restarts` plan faster, and a little
        worse.
    **setup
        Fields of `Setup`: the game.

    Raises
    ------
    InputError
        If the game can't be played, or the strategy isn't one of the two.
    """

    of_team = False

    def __init__(
        self,
        num_envs: int,
        *,
        evaders: BuiltInTeam = TEAM,
        **setup: Any,
    ) -> None:
        if not team_is_built_in(evaders):
            raise InputError(_not_compiled("evaders", evaders, "PursuerEnv"))
        super().__init__(num_envs, setup)
        n = self.setup.team_size
        self._evaders, self._policy = evaders, evaders.compiled()
        noise = start_noise(0, self._policy.restarts, n)
        columns = Columns(*stacked(make_columns(n), num_envs))
        noises, lasts = stacked([noise, np.zeros(2)], num_envs)
        self._memories = TeamMemory(columns, noises, lasts, aim_of(LastCapture(), n))
        self._scratch = search_scratch(n)

    def begin_opponent(self, b: int, start: Start, seed: int) -> float:
        """Plan, and remember what the plan will be improved with."""
        team, known = self.setup.team(start), self.setup.known_at_start(start)
        first = plan(team, known, seed=seed, starts=self._evaders.starts)
        self.states.turns[b] = first.turns
        columns, noise, last, _ = first_memory(first, seed, self._policy.restarts)
        for ours, new in zip(self._memories.columns, columns, strict=True):
            ours[b] = new
        self._memories.noise[b], self._memories.last[b] = noise, last
        return first.survival_time

    def fly(self, actions: npt.ArrayLike) -> None:
        """Fly the pursuers in directions (B, 2)."""
        velocities = velocities_of("actions", actions, (self.num_envs, 2), self.setup.pursuer_speed)
        fly_pursuers(
            self.states,
            self.setup.rules,
            velocities,
            self._policy,
            self._memories,
            self._scratch,
        )


class TeamVectorEnv(Games):
    """Be the teams of many games, against pursuers that are compiled.

    Parameters
    ----------
    num_envs
        B games.
    pursuer
        One that follows sequences: `CommittedPursuer`, `UncommittedPursuer`, `FixedSequence`,
        `BestSequence`, `RandomSequence`.
    **setup
        Fields of `Setup`: the game.

    Raises
    ------
    InputError
        If the game can't be played, or the strategy isn't one of the two.
    """

    of_team = True

    def __init__(
        self,
        num_envs: int,
        *,
        pursuer: BuiltInPursuer = CommittedPursuer(),  # noqa: B008 frozen
        **setup: Any,
    ) -> None:
        if not pursuer_is_built_in(pursuer):
            raise InputError(_not_compiled("pursuer", pursuer, "TeamEnv"))
        super().__init__(num_envs, setup)
        n = self.setup.team_size
        self._pursuer = pursuer
        self._sequences = np.zeros((num_envs, n), np.int64)
        self._followed = np.zeros(num_envs, np.int64)
        self._scratch, self._times = ascent_scratch(n), np.empty(n)

    def begin_opponent(self, b: int, start: Start, seed: int) -> float:
        """Let the pursuer of game b have its first sequence in mind, or none yet."""
        team, known = self.setup.team(start), self.setup.known_at_start(start)
        place = self.setup.disk_around(start.pursuer, 0.0)
        self._margin, self._sequences[b], self._followed[b] = self._pursuer.commitment(
            team, place, seed
        )
        return plan(team, known, seed=seed, starts=STARTS).survival_time

    def fly(self, actions: npt.ArrayLike) -> None:
        """Turn the evaders at rates (B, N), shares of their largest."""
        shares = shares_of("actions", actions, (self.num_envs, self.setup.team_size))
        fly_teams(
            self.states,
            self.setup.rules,
            shares * self.setup.largest_turns,
            self._margin,
            self._sequences,
            self._followed,
            self._times,
            self._scratch,
        )


def _not_compiled(name: str, strategy: object, single: str) -> str:
    return (
        f"{name}: expected a strategy that comes with covey, which plays compiled, got "
        f"{strategy!r}; for your own, use gymnasium.vector.SyncVectorEnv over {single}"
    )
