"""A game between any two strategies, in Python, by the rules that compiled games go by."""

from __future__ import annotations

import math

import numpy as np

from covey.kernels.ascent import ascent_scratch
from covey.kernels.game import blank_pages, more_pages, write_page
from covey.kernels.rules import MOST_UPDATES, NOBODY, State, announce, fly, remove
from covey.model import InputError, PursuerDisk, Team
from covey.model.checks import Floats, Ints, frozen_array
from covey.simulation.assemble import assemble
from covey.simulation.record import Game
from covey.simulation.settings import Settings, first_state
from covey.simulation.strategy import (
    Chase,
    Fly,
    PursuerPolicy,
    PursuerStrategy,
    Situation,
    TeamPolicy,
    TeamStrategy,
    description,
    place_of,
    policy_of,
)


def play(
    team: Team,
    disk: PursuerDisk,
    evaders: TeamStrategy | TeamPolicy,
    pursuer: PursuerStrategy | PursuerPolicy,
    settings: Settings,
) -> Game:
    """Play a game, asking both strategies at every update and after every capture.

    Raises
    ------
    InputError
        If a strategy decides what it can't: turns that aren't n numbers in [-π, π], a sequence
        that names somebody who isn't alive, a velocity above the pursuer's speed, any velocity for
        a pursuer that is a disk only, a place outside it.
    """
    plan = policy_of("evaders", evaders, settings.seed)
    decide = policy_of("pursuer", pursuer, settings.seed)
    place = place_of(pursuer, disk)
    rules = settings.rules(disk, placed=place is not None)
    state, flies = first_state(team, disk, place), rules.placed or not rules.hidden
    n = len(team)
    pages, page, scratch = blank_pages(256, n), 0, ascent_scratch(n)
    order: list[int] = []
    times: list[float] = []
    while state.alive[0] > 0 and state.time[0] < rules.time_limit and page < MOST_UPDATES:
        alive = int(state.alive[0])
        state.turns[:alive] = checked_turns(plan(situation_of(state, disk)), alive)
        announce(state, rules)
        target, velocity, intended = checked_decision(
            decide(situation_of(state, disk, flies=flies)), state, disk, flies=flies
        )
        if page + 2 > len(pages.times):
            pages = more_pages(pages)
        write_page(pages, page, state, rules, intended, len(intended), scratch)
        page += 1
        taken = fly(state, rules, target, *velocity)
        if taken != NOBODY:
            order.append(int(state.ids[taken]))
            times.append(float(state.time[0]))
            remove(state, taken)
    announce(state, rules)
    write_page(pages, page, state, rules, np.empty(0, np.int64), 0, scratch)
    return assemble(
        team,
        disk,
        settings,
        {"evaders": description(evaders), "pursuer": description(pursuer)},
        np.array(order, dtype=np.int64),
        np.array(times),
        pages,
        page + 1,
        placed=rules.placed,
    )


def situation_of(state: State, disk: PursuerDisk, *, flies: bool = False) -> Situation:
    """What the team knows and, if the pursuer `flies`, what only the pursuer does: its place."""
    alive = int(state.alive[0])
    rows = state.evaders[:alive]
    turns = state.turns[:alive].copy()
    turns.flags.writeable = False
    return Situation(
        time=float(state.time[0]),
        evaders=tuple(state.ids[:alive].tolist()),
        team=Team(rows[:, :2], rows[:, 2], rows[:, 3], rows[:, 4]),
        disk=PursuerDisk(state.disk[:2], state.disk[2], disk.speed, disk.capture_radius),
        turns=turns,
        place=state.pursuer[:2].copy() if flies and state.pursuer[2] == 0.0 else None,
    )


def checked_turns(turns: object, alive: int) -> Floats:
    checked = frozen_array("turns returned by the team's strategy", turns, (alive,))
    if np.abs(checked).max() > math.pi:
        raise InputError(
            f"turns returned by the team's strategy: expected radians in [-π, π], "
            f"got {checked.tolist()}"
        )
    return checked


def checked_decision(
    decision: object, state: State, disk: PursuerDisk, *, flies: bool
) -> tuple[int, tuple[float, float], Ints]:
    """Return the row of the target, the velocity, and the rows of the sequence in mind."""
    living = state.ids[: state.alive[0]].tolist()
    if isinstance(decision, Chase):
        sequence = list(decision.sequence)
        if not sequence or len(set(sequence)) < len(sequence) or not set(sequence) <= set(living):
            raise InputError(
                f"Chase: expected a sequence of living evaders {living}, got {sequence}"
            )
        rows = np.array([living.index(i) for i in sequence], dtype=np.int64)
        return int(rows[0]), (0.0, 0.0), rows
    if isinstance(decision, Fly):
        velocity = frozen_array("Fly.velocity", decision.velocity, (2,))
        speed = float(np.hypot(*velocity))
        if speed > disk.speed * (1.0 + 1e-12):
            raise InputError(f"Fly: expected a speed of at most {disk.speed:g}, got {speed:g}")
        if not flies and speed > 0.0:
            raise InputError(
                "Fly: a hidden pursuer is known as a disk only and can't be steered; "
                "return Chase((...)) to name its next target, or Fly() to wait, or give its "
                "strategy a place"
            )
        return NOBODY, (float(velocity[0]), float(velocity[1])), np.empty(0, np.int64)
    raise InputError(f"pursuer's decision: expected Chase or Fly, got {decision!r}")
