"""Many games at once, as a Gymnasium vector environment: what both sides' batches share."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt
from gymnasium.utils import seeding
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from covey.envs.episode import Seen
from covey.envs.setup import InitialState, Setup
from covey.envs.spaces import direction_space, observation_space, steering_space
from covey.kernels.play.batches import observe_games
from covey.kernels.play.rules import State, initial_state
from covey.model import InputError
from covey.model.validation import Floats, whole_number

Flags = npt.NDArray[np.bool_]


class GameBatch(VectorEnv[Seen, npt.ArrayLike, npt.NDArray[Any]]):
    """B games. A game that ends is begun anew in the same step."""

    metadata: dict[str, Any] = {"autoreset_mode": AutoresetMode.SAME_STEP}  # noqa: RUF012 as declared
    of_team: ClassVar[bool]

    def __init__(self, num_envs: int, setup: dict[str, Any]) -> None:
        count = self.num_envs = whole_number("num_envs", num_envs, low=1)
        self.setup = Setup(**setup)
        n = self.setup.team_size
        self.single_action_space = steering_space(n) if self.of_team else direction_space()
        self.action_space = batch_space(self.single_action_space, count)
        self.single_observation_space = observation_space(self.setup)
        self.observation_space = batch_space(self.single_observation_space, count)
        self.states = State(*repeated(initial_state(np.zeros((n, 5)), 0.0, 0.0, 0.0), count))
        self._guarantees = np.zeros(count)
        self._generators = [seeding.np_random()[0] for _ in range(count)]
        self._begun = False

    def reset(
        self,
        *,
        seed: int | Sequence[int | None] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[Seen, dict[str, Any]]:
        """Start all games. Game b is that of a single environment with the seed `seed` + b.

        `options` are those of a single environment, the same for all games.
        """
        if seed is None or isinstance(seed, int | np.integer):
            seeds = [None if seed is None else int(seed) + b for b in range(self.num_envs)]
        else:
            seeds = list(seed)
        if len(seeds) != self.num_envs:
            raise InputError(f"seed: expected {self.num_envs} seeds, got {len(seeds)}")
        for b, own in enumerate(seeds):
            if own is not None:
                self._generators[b], _ = seeding.np_random(own)
            self._begin(b, options)
        self._begun = True
        return self._observe(), self._infos(np.ones(self.num_envs, np.bool_))

    def step(self, actions: npt.ArrayLike) -> tuple[Seen, Floats, Flags, Flags, dict[str, Any]]:
        """Fly every game until its next update or capture; begin the games anew that end."""
        if not self._begun:
            raise InputError("step: expected games to be begun; call reset() first")
        before = self.states.time.copy()
        self.fly(actions)
        elapsed = self.states.time - before
        ended = self.states.alive == 0
        late = ~ended & (self.states.time >= self.setup.time_limit)
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
        return seen, elapsed if self.of_team else -elapsed, ended, late, infos

    def _begin(self, b: int, options: dict[str, Any] | None) -> None:
        generator = self._generators[b]
        initial = self.setup.draw(generator, options)
        for ours, new in zip(self.states, self.setup.first_state(initial), strict=True):
            part_of(ours, b, self.num_envs)[:] = new
        self._guarantees[b] = self.begin_opponent(b, initial, int(generator.integers(2**31)))

    def _observe(self) -> Seen:
        seen = np.empty(self.observation_space.shape or (), np.float32)
        observe_games(self.states, self.of_team, seen)
        return seen

    def _infos(self, which: Flags) -> dict[str, Any]:
        """Return the infos of the games in `which`, as Gymnasium batches them: arrays and masks."""
        values = {"guarantee": self._guarantees, "time": self.states.time}
        infos: dict[str, Any] = {}
        for name, value in values.items():
            infos |= {name: np.where(which, value, 0.0), f"_{name}": which}
        return infos

    def begin_opponent(self, b: int, initial: InitialState, seed: int) -> float:
        """Prepare the opponent of game b, and return the guaranteed survival time."""
        raise NotImplementedError

    def fly(self, actions: npt.ArrayLike) -> None:
        """Fly every game until its next update or capture."""
        raise NotImplementedError


def repeated(arrays: Sequence[npt.NDArray[Any]], count: int) -> list[npt.NDArray[Any]]:
    """Return each array `count` times, one after the other along the first axis."""
    return [np.concatenate([array] * count) for array in arrays]


def part_of(array: npt.NDArray[Any], b: int, count: int) -> npt.NDArray[Any]:
    """Return the part of game b, not a copy, of an array of `count` games."""
    size = len(array) // count
    return array[b * size : (b + 1) * size]
