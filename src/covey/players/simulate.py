"""Play a game: compiled where both strategies come with the package, else in Python."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from covey.kernels import game
from covey.kernels.search import search_scratch
from covey.model import PursuerDisk, Team
from covey.planning import plan
from covey.planning.guarantee import check_game
from covey.planning.open_loop import columns_of, start_noise
from covey.players.evaders import IterativeOpenLoop, OpenLoop
from covey.players.pursuers import CommittedPursuer, FixedSequence
from covey.simulation import (
    Game,
    PursuerPolicy,
    PursuerStrategy,
    Settings,
    TeamPolicy,
    TeamStrategy,
    play,
)
from covey.simulation.assemble import assemble
from covey.simulation.settings import first_state


def simulate(
    team: Team,
    disk: PursuerDisk,
    *,
    evaders: TeamStrategy | TeamPolicy = IterativeOpenLoop(),  # noqa: B008 frozen
    pursuer: PursuerStrategy | PursuerPolicy = CommittedPursuer(),  # noqa: B008 frozen
    sensing: str = "hidden",
    update_time: float = 0.01,
    seed: int = 0,
    time_limit: float | None = None,
) -> Game:
    """Play one game and return its record.

    Parameters
    ----------
    team, disk
        The state at time 0; up to 18 evaders, each slower than the pursuer.
    evaders, pursuer
        Strategies: values that come with the package, your own, or plain functions of a
        `Situation`.
    sensing
        "hidden": the team knows a disk that grows at the pursuer's speed and collapses at each
        capture. "visible": it sees the pursuer at every update.
    update_time
        Δt > 0 between updates; a capture brings one at once.
    seed
        The same call with the same seed gives the same game, bit for bit.
    time_limit
        A game is stopped then. None: by when a pursuer that kept to one sequence would have
        captured everybody, whatever the team did.

    Returns
    -------
    Game
        `guarantee` is the value of the first plan, `survival_time` what came of it.

    Raises
    ------
    InputError
        If an argument can't be used, or a strategy decides what it can't.
    """
    check_game(team, disk)
    limit = _longest_game(team, disk) if time_limit is None else time_limit
    settings = Settings(sensing, update_time, seed, limit)
    if isinstance(evaders, OpenLoop | IterativeOpenLoop) and isinstance(
        pursuer, CommittedPursuer | FixedSequence
    ):
        return _play_compiled(team, disk, evaders, pursuer, settings)
    return play(team, disk, evaders, pursuer, settings)


def _play_compiled(
    team: Team,
    disk: PursuerDisk,
    evaders: OpenLoop | IterativeOpenLoop,
    pursuer: CommittedPursuer | FixedSequence,
    settings: Settings,
) -> Game:
    n, policy = len(team), evaders.compiled()
    margin, sequence, known = pursuer.commitment(n)
    first = plan(team, disk, seed=settings.seed, starts=evaders.starts)
    state = first_state(team, disk)
    state.turns[:] = first.turns
    noise = start_noise(settings.seed, policy.restarts, n)
    captured, order, times, count, pages = game.play(
        state,
        settings.rules(disk),
        policy,
        noise,
        columns_of(first),
        margin,
        sequence,
        known,
        True,
        search_scratch(n),
    )
    strategies: dict[str, Any] = {"evaders": evaders.describe(), "pursuer": pursuer.describe()}
    captures = order[:captured], times[:captured]
    return assemble(team, disk, settings, strategies, *captures, pages, count)


def _longest_game(team: Team, disk: PursuerDisk) -> float:
    """By when a pursuer that keeps to any one sequence has captured everybody.

    An evader that is d away is captured within d / (v_p - v), and until then the next one gets no
    farther away than what both can fly.
    """
    offsets = team.positions - disk.center
    farthest = float(np.hypot(offsets[:, 0], offsets[:, 1]).max()) + disk.radius
    fastest = float(team.speeds.max())
    time = 0.0
    for _ in range(len(team)):
        gap = 2.0 * farthest + (disk.speed + fastest) * time
        time += gap / (disk.speed - fastest)
    return time if time > 0.0 else math.inf
