"""Batches of games in which one side acts and the other plays compiled: Gymnasium's vector view."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt
from gymnasium.utils import seeding
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from covey.envs.actions import shares_of, velocities_of
from covey.envs.episode import Seen
from covey.envs.setup import STARTS, TEAM, Setup
from covey.envs.spaces import direction_space, observation_space, steering_space
from covey.kernels.ascent import ascent_scratch
from covey.kernels.batches import Batch, fly_pursuers, fly_teams, observe_games
from covey.kernels.columns import Columns, make_columns
from covey.kernels.rules import State, initial_state
from covey.kernels.search import search_scratch
from covey.model import InputError, PursuerDisk, Team
from covey.model.checks import Floats, whole_number
from covey.planning import plan
from covey.planning.open_loop import columns_of, start_noise
from covey.players import CommittedPursuer, FixedSequence, IterativeOpenLoop, OpenLoop
from covey.players.compiled import pursuer_is_built_in, team_is_built_in

Flags = npt.NDArray[np.bool_]


class _Games(VectorEnv[Seen, npt.ArrayLike, npt.NDArray[Any]]):
    """What both batches share: games, each of them begun anew in the step that ends it."""

    metadata: dict[str, Any] = {"autoreset_mode": AutoresetMode.SAME_STEP}  # noqa: RUF012 as declared
    _of_team: ClassVar[bool]

    def __init__(self, num_envs: int, setup: dict[str, Any]) -> None:
        count = self.num_envs = whole_number("num_envs", num_envs, low=1)
        self.setup = Setup(**setup)
        n = self.setup.team_size
        self.single_action_space = steering_space(n) if self._of_team else direction_space()
        self.action_space = batch_space(self.single_action_space, count)
        self.single_observation_space = observation_space(self.setup)
        self.observation_space = batch_space(self.single_observation_space, count)
        self._states = State(*_stacked(initial_state(np.zeros((n, 5)), 0.0, 0.0, 0.0), count))
        self._batch = Batch(self._states, np.zeros((count, 3)))
        self._guarantees = np.zeros(count)
        self._generators = [seeding.np_random()[0] for _ in range(count)]

    def reset(
        self,
        *,
        seed: int | Sequence[int | None] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[Seen, dict[str, Any]]:
        """Start all games; game b is the one that a single view starts with seed `seed` + b."""
        if seed is None or isinstance(seed, int):
            seeds = [None if seed is None else seed + b for b in range(self.num_envs)]
        else:
            seeds = list(seed)
        if len(seeds) != self.num_envs:
            raise InputError(f"seed: expected {self.num_envs} seeds, got {len(seeds)}")
        for b, own in enumerate(seeds):
            if own is not None:
                self._generators[b], _ = seeding.np_random(own)
            self._begin(b, options)
        return self._observe(), self._infos(np.ones(self.num_envs, np.bool_))

    def step(self, actions: npt.ArrayLike) -> tuple[Seen, Floats, Flags, Flags, dict[str, Any]]:
        """Fly every game until its next update or capture; begin those anew that end with it."""
        before = self._states.time[:, 0].copy()
        self._fly(actions)
        elapsed = self._states.time[:, 0] - before
        ended = self._states.alive[:, 0] == 0
        late = ~ended & (self._states.time[:, 0] >= self.setup.time_limit)
        over, seen, infos = ended | late, self._observe(), dict[str, Any]()
        if over.any():
            final = np.full(self.num_envs, None, object)
            for b in np.flatnonzero(over).tolist():
                final[b] = seen[b].copy()
            infos = {"final_obs": final, "final_info": self._infos(over)}
            infos |= {"_final_obs": over, "_final_info": over}
            for b in np.flatnonzero(over).tolist():
                self._begin(b, None)
            seen = self._observe()
        infos |= self._infos(np.ones(self.num_envs, np.bool_))
        return seen, elapsed if self._of_team else -elapsed, ended, late, infos

    def _begin(self, b: int, options: dict[str, Any] | None) -> None:
        generator = self._generators[b]
        start = self.setup.draw(generator, options)
        team, known = self.setup.team(start), self.setup.known_at_start(start)
        for ours, new in zip(self._states, self.setup.first_state(start), strict=True):
            ours[b] = new
        self._batch.known[b] = *known.center, known.radius
        self._guarantees[b] = self._begin_opponent(b, team, known, int(generator.integers(2**31)))

    def _observe(self) -> Seen:
        seen = np.empty(self.observation_space.shape or (), np.float32)
        observe_games(self._batch, self._of_team, seen)
        return seen

    def _infos(self, which: Flags) -> dict[str, Any]:
        """Infos of some games, as Gymnasium batches them: with a mask beside every array."""
        values = {"guarantee": self._guarantees, "time": self._states.time[:, 0]}
        infos: dict[str, Any] = {}
        for name, value in values.items():
            infos |= {name: np.where(which, value, 0.0), f"_{name}": which}
        return infos

    def _begin_opponent(self, b: int, team: Team, known: PursuerDisk, seed: int) -> float:
        """Prepare the opponent of game b; return the guaranteed survival time."""
        raise NotImplementedError

    def _fly(self, actions: npt.ArrayLike) -> None:
        raise NotImplementedError


class PursuerVectorEnv(_Games):
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

    _of_team = False

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
        self._columns = Columns(*_stacked(make_columns(n), num_envs))
        self._scratch = search_scratch(n)

    def _begin_opponent(self, b: int, team: Team, known: PursuerDisk, seed: int) -> float:
        first = plan(team, known, seed=seed, starts=self._evaders.starts)
        self._states.turns[b] = first.turns
        self._noise[b] = start_noise(seed, self._policy.restarts, len(team))
        for ours, new in zip(self._columns, columns_of(first), strict=True):
            ours[b] = new
        return first.survival_time

    def _fly(self, actions: npt.ArrayLike) -> None:
        velocities = velocities_of("actions", actions, (self.num_envs, 2), self.setup.pursuer_speed)
        fly_pursuers(
            self._batch,
            self.setup.rules,
            self.setup.hidden,
            velocities,
            self._policy,
            self._noise,
            self._columns,
            self._scratch,
        )


class TeamVectorEnv(_Games):
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

    _of_team = True

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

    def _begin_opponent(self, b: int, team: Team, known: PursuerDisk, seed: int) -> float:
        self._sequences[b] = self._first_sequence
        self._followed[b] = self._begins_with_it
        return plan(team, known, seed=seed, starts=STARTS).survival_time

    def _fly(self, actions: npt.ArrayLike) -> None:
        shares = shares_of("actions", actions, (self.num_envs, self.setup.team_size))
        fly_teams(
            self._batch,
            self.setup.rules,
            self.setup.hidden,
            shares * self.setup.largest_turns,
            self._margin,
            self._sequences,
            self._followed,
            self._times,
            self._scratch,
        )


def _stacked(arrays: Sequence[npt.NDArray[Any]], count: int) -> list[npt.NDArray[Any]]:
    """Return each array `count` times, stacked."""
    return [np.stack([array] * count) for array in arrays]


def _not_compiled(name: str, strategy: object, single: str) -> str:
    return (
        f"{name}: expected a strategy that comes with covey, which plays compiled, got "
        f"{strategy!r}; for your own, use gymnasium.vector.SyncVectorEnv over {single}"
    )
