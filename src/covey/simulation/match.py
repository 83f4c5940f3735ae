"""A game in play, which advances from one decision of the pursuer to the next."""

from __future__ import annotations

import math

import numpy as np

from covey.kernels.arrays import Workspace
from covey.kernels.play.game import (
    ROWS,
    UPDATES,
    allocate_log,
    grow_log,
    is_over,
    log_capture,
    write_row,
)
from covey.kernels.play.rules import NOBODY, announce, fly, moves
from covey.model import PursuerDisk, Team
from covey.planning.border import about_center
from covey.planning.compiled_objective import compiled_objective
from covey.planning.expectation import value_of_plan
from covey.planning.long_calls import interceptions_of_minimum, interruptible
from covey.simulation.build_record import Played, build_record
from covey.simulation.information import (
    checked_decision,
    checked_turns,
    pursuer_information,
    require_kept_assurance,
    team_information,
)
from covey.simulation.record import Game
from covey.simulation.settings import GameSetup, Settings, first_state
from covey.simulation.strategy import (
    PursuerPolicy,
    PursuerStrategy,
    TeamPolicy,
    TeamStrategy,
    description,
    in_own_frame,
    policy_of,
    position_of,
)

_NO_ROWS = np.empty(0, np.int64)


class Match:
    """A game whose team has announced its plan; the pursuer decides next.

    Parameters
    ----------
    team, disk, evaders, pursuer, settings
        As for `play`.

    Raises
    ------
    InputError
        If a strategy decides what it can't.
    """

    def __init__(
        self,
        team: Team,
        disk: PursuerDisk,
        evaders: TeamStrategy | TeamPolicy,
        pursuer: PursuerStrategy | PursuerPolicy,
        settings: Settings,
    ) -> None:
        compiled_objective(settings.objective, len(team))  # an error before anybody flies
        self._plan = in_own_frame(policy_of("evaders", evaders, settings.seed), disk.center)
        self._decide = in_own_frame(policy_of("pursuer", pursuer, settings.seed), disk.center)
        strategies = {"evaders": description(evaders), "pursuer": description(pursuer)}
        position = position_of(pursuer, disk)
        self._setup = GameSetup(team, disk, settings, strategies, position)
        self._rules = settings.rules(disk, has_position=position is not None)
        self._moves = moves(self._rules)
        own = None if position is None else position - disk.center
        self._state = first_state(*about_center(team, disk), own)
        self._log = allocate_log(256, len(team))
        self._assurances: list[float] = []
        self._announce_plan()
        turns = self._log.evaders[0, :, 3]
        self._planned_value = value_of_plan(team, disk, turns, settings.objective)

    @property
    def over(self) -> bool:
        """Whether everybody is captured, or the game was stopped at a limit."""
        return is_over(self._log, self._state, self._rules)

    def step(self) -> None:
        """Let the pursuer decide, fly until the next update or capture, and let the team plan."""
        self._log.counters[UPDATES] += 1
        captured_row = self._fly()
        if captured_row != NOBODY:
            log_capture(self._log, self._state, captured_row)
        if self.over:
            announce(self._state, self._rules)
            self._write()
        else:
            self._announce_plan()

    def record(self) -> Game:
        """Return the record of the game until now."""
        return build_record(self.played())

    def played(self) -> Played:
        """Return the game as it was played until now."""
        guarantee = float(self._log.guarantees[0])
        # The last row is one at which nothing is decided.
        assurances = np.array([*self._assurances, *(self._assurances or [math.inf])[-1:]])
        return Played(self._setup, guarantee, self._planned_value, self._log, assurances)

    def _announce_plan(self) -> None:
        alive = int(self._state.alive[0])
        self._known = team_information(
            self._state, self._setup.disk, self._setup.settings.objective
        )
        self._state.turns[:alive] = checked_turns(self._plan(self._known), alive)
        announce(self._state, self._rules)
        self._write()

    def _fly(self) -> int:
        """Fly what the pursuer decides, and return the row of the captured evader, or `NOBODY`."""
        state = self._state
        known = pursuer_information(self._known, state, self._rules, moves=self._moves)
        decision = checked_decision(self._decide(known), known, moves=self._moves)
        require_kept_assurance(decision.assurance, known.time, self._assurances)
        self._assurances.append(decision.assurance)
        self._log.intended[self._log.counters[ROWS] - 1, : len(decision.rows)] = state.ids[
            decision.rows
        ]
        state.pursuer[:2] += decision.offset
        return fly(state, self._rules, decision.target, *decision.velocity)

    def _write(self) -> None:
        if self._log.counters[ROWS] == len(self._log.times):
            self._log = grow_log(self._log)
        n = len(self._setup.team)

        def write(scratch: Workspace) -> None:
            write_row(self._log, self._state, self._rules, _NO_ROWS, -math.inf, scratch)

        interruptible(write, n, False, interceptions_of_minimum(n, total=False))
