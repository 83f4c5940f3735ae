"""A game in play, which advances from one decision of the pursuer to the next."""

from __future__ import annotations

import numpy as np

from covey.kernels.maximum.sqp import ascent_scratch
from covey.kernels.play.game import blank_pages, more_pages, write_page
from covey.kernels.play.rules import MOST_UPDATES, NOBODY, announce, flies, fly, remove
from covey.model import PursuerDisk, Team
from covey.planning.compiled_objective import aim_of
from covey.planning.guarantee import value_of_plan
from covey.simulation.build_record import Played, build_record
from covey.simulation.information import (
    checked_decision,
    checked_turns,
    pursuer_information,
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
        aim_of(settings.objective, len(team))  # whether it fits is known before anybody flies
        self._plan = policy_of("evaders", evaders, settings.seed)
        self._decide = policy_of("pursuer", pursuer, settings.seed)
        strategies = {"evaders": description(evaders), "pursuer": description(pursuer)}
        position = position_of(pursuer, disk)
        self._setup = GameSetup(team, disk, settings, strategies, position)
        self._rules = settings.rules(disk, placed=position is not None)
        self._flies = flies(self._rules)
        self._state = first_state(team, disk, position)
        self._updates = 0
        self._pages, self._written = blank_pages(256, len(team)), 0
        self._scratch = ascent_scratch(len(team))
        self._order: list[int] = []
        self._times: list[float] = []
        self._announce_plan()
        turns = self._pages.evaders[0, :, 3]
        self._planned_value = value_of_plan(team, disk, turns, settings.objective)

    @property
    def over(self) -> bool:
        """Whether everybody is captured, or the game was stopped at a limit."""
        return bool(
            self._state.alive[0] == 0
            or self._state.time[0] >= self._rules.time_limit
            or self._updates >= MOST_UPDATES
        )

    def step(self) -> None:
        """Let the pursuer decide, fly until the next update or capture, and let the team plan."""
        self._updates += 1
        taken = self._fly()
        if taken != NOBODY:
            self._order.append(int(self._state.ids[taken]))
            self._times.append(float(self._state.time[0]))
            remove(self._state, taken)
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
        return Played(
            self._setup,
            float(self._pages.guarantees[0]),
            self._planned_value,
            np.array(self._order, dtype=np.int64),
            np.array(self._times),
            self._pages,
            self._written,
        )

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
        decision = self._decide(pursuer_information(self._known, state, flies=self._flies))
        rows, target, velocity = checked_decision(
            decision, self._known.evaders, self._setup.disk, flies=self._flies
        )
        self._pages.intended[self._written - 1, : len(rows)] = state.ids[rows]
        return fly(state, self._rules, target, *velocity)

    def _write(self) -> None:
        if self._written == len(self._pages.times):
            self._pages = more_pages(self._pages)
        page, self._written = self._written, self._written + 1
        write_page(self._pages, page, self._state, self._rules, _NO_ROWS, 0, self._scratch)
