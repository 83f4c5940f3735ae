"""A game in play, which moves from one decision to the next."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from covey.kernels.ascent import ascent_scratch
from covey.kernels.game import blank_pages, more_pages, write_page
from covey.kernels.rules import (
    MOST_UPDATES,
    NOBODY,
    announce,
    fly,
    fly_hidden_point,
    remove,
)
from covey.model import InputError, PursuerDisk, Team
from covey.model.checks import Floats
from covey.simulation.assemble import assemble
from covey.simulation.decisions import checked_turns, chosen_rows, chosen_velocity
from covey.simulation.record import Game
from covey.simulation.settings import Settings, first_state
from covey.simulation.strategy import (
    Chase,
    PursuerPolicy,
    PursuerStrategy,
    Situation,
    TeamPolicy,
    TeamStrategy,
    description,
    policy_of,
)

_NO_ROWS = np.empty(0, np.int64)


class Match:
    """A game whose team has announced its plan, and which waits for the pursuer's decision.

    Parameters
    ----------
    team, disk, evaders, pursuer, settings
        As for `play`.

    Raises
    ------
    InputError
        If a strategy decides what it can't, or a hidden pursuer is flown that can't capture.
    """

    def __init__(
        self,
        team: Team,
        disk: PursuerDisk,
        evaders: TeamStrategy | TeamPolicy,
        pursuer: PursuerStrategy | PursuerPolicy,
        settings: Settings,
    ) -> None:
        self._team, self._disk, self._settings = team, disk, settings
        self._plan = policy_of("evaders", evaders, settings.seed)
        self._decide = policy_of("pursuer", pursuer, settings.seed)
        self._strategies = {"evaders": description(evaders), "pursuer": description(pursuer)}
        self._rules, self._state = settings.rules(disk), first_state(team, disk)
        self._place = _first_place(disk, settings)
        self._updates = 0
        self._pages, self._written = blank_pages(256, len(team)), 0
        self._scratch = ascent_scratch(len(team))
        self._order: list[int] = []
        self._times: list[float] = []
        self._announce_plan()

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
        taken = self._fly(self._decide(self._for_pursuer()))
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
        """Return what has happened until now."""
        return assemble(
            self._team,
            self._disk,
            self._settings,
            self._strategies,
            np.array(self._order, dtype=np.int64),
            np.array(self._times),
            self._pages,
            self._written,
        )

    def _announce_plan(self) -> None:
        alive = int(self._state.alive[0])
        self._now = self._situation()
        self._state.turns[:alive] = checked_turns(self._plan(self._now), alive)
        announce(self._state, self._rules)
        self._write()

    def _fly(self, decision: object) -> int:
        """Fly what the pursuer decides, and return the row of whom it took."""
        state, rules, disk = self._state, self._rules, self._disk
        if isinstance(decision, Chase) and self._place is None:
            living = state.ids[: state.alive[0]]
            rows = chosen_rows(decision, living.tolist())
            self._pages.intended[self._written - 1, : len(rows)] = living[rows]
            return fly(state, rules, int(rows[0]), 0.0, 0.0)
        shapeless = rules.hidden and self._place is None
        velocity = chosen_velocity(decision, disk, shapeless=shapeless)
        if self._place is None:
            return fly(state, rules, NOBODY, *velocity)
        return fly_hidden_point(state, rules, self._place, *velocity)

    def _write(self) -> None:
        if self._written == len(self._pages.times):
            self._pages = more_pages(self._pages)
        page, self._written = self._written, self._written + 1
        write_page(self._pages, page, self._state, self._rules, _NO_ROWS, 0, self._scratch)
        if self._place is not None:
            self._pages.pursuers[page, :2] = self._place

    def _situation(self) -> Situation:
        state, disk = self._state, self._disk
        alive = int(state.alive[0])
        rows = state.evaders[:alive]
        return Situation(
            time=float(state.time[0]),
            evaders=tuple(state.ids[:alive].tolist()),
            team=Team(rows[:, :2], rows[:, 2], rows[:, 3], rows[:, 4]),
            disk=PursuerDisk(state.disk[:2], state.disk[2], disk.speed, disk.capture_radius),
            turns=_read_only_copy(state.turns[:alive]),
        )

    def _for_pursuer(self) -> Situation:
        """What the team has seen, the turns it has announced since, and where the pursuer is."""
        turns = _read_only_copy(self._state.turns[: len(self._now.turns)])
        place = None if self._place is None else _read_only_copy(self._place)
        return replace(self._now, turns=turns, place=place)


def _first_place(disk: PursuerDisk, settings: Settings) -> Floats | None:
    """Where a hidden pursuer that is flown begins."""
    if not settings.flown or settings.sensing == "visible":
        return None
    if disk.capture_radius == 0.0:
        raise InputError("capture_radius: expected a number > 0 for a pursuer that is flown, got 0")
    return disk.center.copy()


def _read_only_copy(array: Floats) -> Floats:
    copy = array.copy()
    copy.flags.writeable = False
    return copy
