"""One game of an environment, step by step, by the rules of the simulation."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from covey.envs.setup import STARTS, InitialState, Setup
from covey.kernels.play.observation import DISK, ROW, observe
from covey.kernels.play.rules import NOBODY, announce, fly, remove
from covey.model import InputError, LastCapture
from covey.model.validation import Floats, Ints
from covey.planning import guaranteed_survival
from covey.planning.open_loop import first_plan
from covey.simulation import PursuerStrategy, TeamStrategy
from covey.simulation.information import (
    checked_decision,
    checked_turns,
    pursuer_information,
    team_information,
)
from covey.simulation.strategy import PursuerPolicy, TeamPolicy, policy_of

Velocity = tuple[float, float]
Seen = npt.NDArray[np.float32]


class Episode:
    """One game. A strategy decides for its side; `step` is given the decisions of the other side.

    Parameters
    ----------
    setup, initial
        The game, and its initial state.
    seed
        Seed of the searches for plans.
    evaders, pursuer
        Strategies, or functions of a `Situation`; None: `step` is given the decisions.

    Attributes
    ----------
    guarantee : float
        Survival time that the team's first plan guarantees. A team without a strategy has no plan;
        then that of `covey.plan`.
    state
        The kernels' state of the game; see `covey.kernels.play.rules`.
    """

    def __init__(
        self,
        setup: Setup,
        initial: InitialState,
        seed: int,
        evaders: TeamStrategy | TeamPolicy | None,
        pursuer: PursuerStrategy | PursuerPolicy | None,
    ) -> None:
        team, known = setup.team(initial), setup.known_at_start(initial)
        self.setup, self.rules = setup, setup.rules
        self.state = setup.first_state(initial)
        self._disk = known
        self._plan = None if evaders is None else policy_of("evaders", evaders, seed)
        self._decide = None if pursuer is None else policy_of("pursuer", pursuer, seed)
        if self._plan is None:
            first = first_plan(team, known, LastCapture(), seed, STARTS)
            self.guarantee = first.survival_time
        else:
            self._announce_plan(self._plan)
            self.guarantee = guaranteed_survival(team, known, self.state.turns).time

    @property
    def time(self) -> float:
        """Time since the start."""
        return float(self.state.time[0])

    @property
    def living(self) -> Ints:
        """Numbers of the evaders alive."""
        living: Ints = self.state.ids[: self.state.alive[0]]
        return living

    @property
    def ended(self) -> bool:
        """Whether everybody was captured."""
        return len(self.living) == 0

    @property
    def late(self) -> bool:
        """Whether the time limit ended the game."""
        return not self.ended and self.time >= self.rules.time_limit

    def info(self) -> dict[str, float]:
        """Return the guaranteed survival time, and the time now."""
        return {"guarantee": self.guarantee, "time": self.time}

    def step(self, shares: Floats | None, velocity: Velocity | None) -> float:
        """Fly until the next update or capture, and return the elapsed time.

        `shares` (N,) are the evaders' turn rates as shares of the largest, `velocity` (2,) is the
        pursuer's; None for a side with a strategy.
        """
        if self.ended or self.late:
            raise InputError("step: expected a game that goes on, this one has ended; call reset()")
        state, alive, before = self.state, len(self.living), self.time
        if shares is not None:
            state.turns[:alive] = (shares * self.setup.largest_turns)[self.living]
        announce(state, self.rules)
        target, flown = NOBODY, velocity or (0.0, 0.0)
        if self._decide is not None:
            target, flown = self._decided(self._decide)
        taken = fly(state, self.rules, target, *flown)
        if taken != NOBODY:
            remove(state, taken)
        if self._plan is None:
            state.turns[:] = 0.0  # a capture ends the step, and with it the announced turns
        elif not self.ended:
            self._announce_plan(self._plan)
        return self.time - before

    def seen_by_pursuer(self) -> Seen:
        """Return the pursuer's observation."""
        return self._seen_from(self.state.pursuer, NOBODY)

    def seen_by_team(self) -> Seen:
        """Return the team's common observation, from the centre of the disk that it knows of."""
        return self._seen_from(self.state.disk, NOBODY)

    def seen_by(self, evader: int) -> Seen:
        """Return an evader's observation; a captured one observes from its capture point."""
        row = np.flatnonzero(self.living == evader)
        position = self.state.evaders[row[0]] if len(row) else self.state.capture_pose[evader]
        return self._seen_from(position, evader)

    def _decided(self, decide: PursuerPolicy) -> tuple[int, Velocity]:
        """Return the row of the evader that the pursuer flies to, or NOBODY, and its velocity."""
        known = team_information(self.state, self._disk)
        seen = pursuer_information(known, self.state, self.rules, moves=True)
        decision = checked_decision(decide(seen), seen, moves=True)
        return decision.target, decision.velocity

    def _seen_from(self, position: Floats, first: int) -> Seen:
        seen = np.empty(ROW * self.setup.team_size + DISK, np.float32)
        observe(self.state, position[0], position[1], first, seen)
        return seen

    def _announce_plan(self, plan_of: TeamPolicy) -> None:
        turns = plan_of(team_information(self.state, self._disk))
        self.state.turns[: len(self.living)] = checked_turns(turns, len(self.living))
