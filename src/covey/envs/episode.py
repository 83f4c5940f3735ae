"""One game of an environment, played decision by decision by the rules of the simulation."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from covey.envs.setup import STARTS, Setup, Start
from covey.kernels.play.observation import DISK, ROW, observe
from covey.kernels.play.rules import NOBODY, announce, fly, remove
from covey.model import InputError
from covey.model.validation import Floats, Ints
from covey.planning import guaranteed_survival, plan
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
    """One game. A side that has a strategy plays by itself, the other is given its decisions.

    Parameters
    ----------
    setup, start
        The game.
    seed
        Of the searches for plans.
    evaders, pursuer
        Strategies, or functions of a `Situation`; None: decisions are given to `step`.

    Attributes
    ----------
    guarantee : float
        Survival time that the team's first plan guarantees or, where the team is given its
        decisions, that of `covey.plan`.
    state
        Of the kernels; see `covey.kernels.play.rules`.
    """

    def __init__(
        self,
        setup: Setup,
        start: Start,
        seed: int,
        evaders: TeamStrategy | TeamPolicy | None,
        pursuer: PursuerStrategy | PursuerPolicy | None,
    ) -> None:
        team, known = setup.team(start), setup.known_at_start(start)
        self.setup, self.rules = setup, setup.rules
        self.state = setup.first_state(start)
        self._disk = known
        self._plan = None if evaders is None else policy_of("evaders", evaders, seed)
        self._decide = None if pursuer is None else policy_of("pursuer", pursuer, seed)
        if self._plan is None:
            self.guarantee = plan(team, known, seed=seed, starts=STARTS).survival_time
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
        """Return what infos say: the survival time that was guaranteed, and the time now."""
        return {"guarantee": self.guarantee, "time": self.time}

    def step(self, shares: Floats | None, velocity: Velocity | None) -> float:
        """Fly until the next update or capture, and return the time that it took.

        `shares` (N,) are the evaders' turn rates, `velocity` (2,) is the pursuer's; None for a side
        that plays by itself.
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
            state.turns[:] = 0.0  # what a capture left of a turn is not announced any longer
        elif not self.ended:
            self._announce_plan(self._plan)
        return self.time - before

    def seen_by_pursuer(self) -> Seen:
        """Return the pursuer's observation."""
        return self._seen_from(self.state.pursuer, NOBODY)

    def seen_by_team(self) -> Seen:
        """Return what the team sees together, from the centre of the disk that it knows of."""
        return self._seen_from(self.state.disk, NOBODY)

    def seen_by(self, evader: int) -> Seen:
        """Return an evader's observation; where it was captured, if it was."""
        row = np.flatnonzero(self.living == evader)
        place = self.state.evaders[row[0]] if len(row) else self.state.resting[evader]
        return self._seen_from(place, evader)

    def _decided(self, decide: PursuerPolicy) -> tuple[int, Velocity]:
        """Return the row that the pursuer makes for, or NOBODY, and its velocity."""
        known = team_information(self.state, self._disk)
        decision = decide(pursuer_information(known, self.state, flies=True))
        _, target, velocity = checked_decision(decision, known.evaders, self._disk, flies=True)
        return target, velocity

    def _seen_from(self, place: Floats, first: int) -> Seen:
        seen = np.empty(ROW * self.setup.team_size + DISK, np.float32)
        observe(self.state, place[0], place[1], first, seen)
        return seen

    def _announce_plan(self, plan_of: TeamPolicy) -> None:
        turns = plan_of(team_information(self.state, self._disk))
        self.state.turns[: len(self.living)] = checked_turns(turns, len(self.living))
