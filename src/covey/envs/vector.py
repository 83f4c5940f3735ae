"""Batches of games in which one side acts and the other plays compiled: Gymnasium's vector view."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from covey.envs.actions import shares_of, velocities_of
from covey.envs.games import Games, stacked
from covey.envs.setup import STARTS, TEAM
from covey.kernels.ascent import ascent_scratch
from covey.kernels.batches import fly_pursuers, fly_teams
from covey.kernels.columns import Columns, make_columns
from covey.kernels.search import search_scratch
from covey.model import InputError, PursuerDisk, Team
from covey.planning import plan
from covey.planning.open_loop import columns_of, start_noise
from covey.players import CommittedPursuer, FixedSequence, IterativeOpenLoop, OpenLoop
from covey.players.compiled import pursuer_is_built_in, team_is_built_in


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
        evaders: IterativeOpenLoop | OpenLoop = TEAM,
        **setup: Any,
    ) -> None:
        if not team_is_built_in(evaders):
            raise InputError(_not_compiled("evaders", evaders, "PursuerEnv"))
        super().__init__(num_envs, setup)
        n = self.setup.team_size
        self._evaders, self._policy = evaders, evaders.compiled()
        self._noise = np.zeros((num_envs, *start_noise(0, self._policy.restarts, n).shape))
        self._columns = Columns(*stacked(make_columns(n), num_envs))
        self._scratch = search_scratch(n)

    def begin_opponent(self, b: int, team: Team, known: PursuerDisk, seed: int) -> float:
        """Plan, and remember what the plan will be improved with."""
        first = plan(team, known, seed=seed, starts=self._evaders.starts)
        self.states.turns[b] = first.turns
        self._noise[b] = start_noise(seed, self._policy.restarts, len(team))
        for ours, new in zip(self._columns, columns_of(first), strict=True):
            ours[b] = new
        return first.survival_time

    def fly(self, actions: npt.ArrayLike) -> None:
        """Fly the pursuers in directions (B, 2)."""
        velocities = velocities_of("actions", actions, (self.num_envs, 2), self.setup.pursuer_speed)
        fly_pursuers(
            self.batch,
            self.setup.rules,
            self.setup.hidden,
            velocities,
            self._policy,
            self._noise,
            self._columns,
            self._scratch,
        )


class TeamVectorEnv(Games):
    """Be the teams of many games, against pursuers that are compiled.

    Parameters
    ----------
    num_envs
        B games.
    pursuer
        `CommittedPursuer` or `FixedSequence`.
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
        pursuer: CommittedPursuer | FixedSequence = CommittedPursuer(),  # noqa: B008 frozen
        **setup: Any,
    ) -> None:
        if not pursuer_is_built_in(pursuer):
            raise InputError(_not_compiled("pursuer", pursuer, "TeamEnv"))
        super().__init__(num_envs, setup)
        n = self.setup.team_size
        self._margin, self._first_sequence, self._begins_with_it = pursuer.commitment(n)
        self._sequences = np.zeros((num_envs, n), np.int64)
        self._followed = np.zeros(num_envs, np.int64)
        self._scratch, self._times = ascent_scratch(n), np.empty(n)

    def begin_opponent(self, b: int, team: Team, known: PursuerDisk, seed: int) -> float:
        """Let the pursuer of game b have its first sequence in mind, or none yet."""
        self._sequences[b] = self._first_sequence
        self._followed[b] = self._begins_with_it
        return plan(team, known, seed=seed, starts=STARTS).survival_time

    def fly(self, actions: npt.ArrayLike) -> None:
        """Turn the evaders at rates (B, N), shares of their largest."""
        shares = shares_of("actions", actions, (self.num_envs, self.setup.team_size))
        fly_teams(
            self.batch,
            self.setup.rules,
            self.setup.hidden,
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
