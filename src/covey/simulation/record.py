"""What happened in a game: the record that is returned, saved, drawn and studied."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Any, NamedTuple

import numpy as np

from covey.model import PursuerDisk, Team
from covey.model.display import html_table, one_line, quantity
from covey.model.units import counted, titled
from covey.model.validation import Floats, Ints
from covey.model.value import Value
from covey.simulation.data_frame import data_frame
from covey.simulation.time_series import time_series


class GameStatus(StrEnum):
    """How a game ended.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> game = covey.simulate(team, disk, time_limit=0.5)
    >>> game.status is covey.GameStatus.TIME_LIMIT
    True
    """

    ALL_CAPTURED = "every evader was captured"
    TIME_LIMIT = "stopped at the time limit with evaders alive; raise time_limit to play on"
    UPDATE_LIMIT = "stopped after 200 000 updates with evaders alive; raise update_time to play on"


class Outcome(NamedTuple):
    """What came of a game.

    Attributes
    ----------
    guarantee : float
        Survival time that the first plan guaranteed.
    survival_time : float
        Time of the last capture; inf if the game was stopped before it.
    planned_value, value : float
        Value of the objective by the first plan, and the value that was reached.
    capture_sequence, capture_times : numpy.ndarray
        (C,) evaders in the order of their capture, and when.
    """

    guarantee: float
    survival_time: float
    planned_value: float
    value: float
    capture_sequence: Ints
    capture_times: Floats


@dataclass(frozen=True, eq=False)
class Game(Value):
    """One game, from time 0 to the last capture.

    T rows: one at every update and one at every capture. Each has the state just after the update
    or capture, and the plan that is flown from there on. Evaders are numbered from 0; a captured
    evader stays where it was captured. Lengths, times and radians are as in the team and the disk.

    Attributes
    ----------
    team, disk : Team, PursuerDisk
        The state at time 0.
    sensing : str
        "visible": the team sees the pursuer at every update. "hidden": it knows only the disk,
        which grows at the pursuer's speed and collapses at a capture.
    update_time : float
        Δt between updates; a capture brings an update at once.
    seed : int
        Seed of the searches for plans.
    objective : mapping
        Name and parameters of what the game was about, as a scenario file gives them.
    strategies : mapping
        "evaders" and "pursuer": name and parameters of each, as a scenario file gives them.
    status : GameStatus
    guarantee : float
        Survival time that the first plan guaranteed, if it was flown to the end. Iterative open
        loop never survives less where the game is about the last capture; where the game is about
        the sum, its `value` is never less than `planned_value`.
    survival_time : float
        Time of the last capture; inf if the game was stopped before it.
    planned_value, value : float
        Value of the objective by the first plan, and the value that was reached: guarantee and
        survival time where the objective is the last capture.
    capture_sequence, capture_times : numpy.ndarray
        (C,) evaders in the order of their capture, and when; C = N unless the game was stopped.
    times : numpy.ndarray
        (T,), not decreasing.
    evader_positions, evader_headings : numpy.ndarray
        (T, N, 2) and (T, N).
    evader_turns : numpy.ndarray
        (T, N) signed turns that are still planned; 0 for captured evaders.
    guarantees : numpy.ndarray
        (T,) guaranteed survival time, from that row on, of the plan that is flown. Exact for up to
        20 living evaders, else a proven lower bound.
    assurances : numpy.ndarray
        (T,) time since the start of the game by which the pursuer has captured everybody, whatever
        the evaders do, by what it knew at that row; inf if its strategy assures nothing. It never
        rises.
    critical_sequences, pursuer_sequences : numpy.ndarray
        (T, N) the order in which the flown plan would be captured earliest (for more than 20 living
        evaders the worst order known), and the order that the pursuer has in mind, if its strategy
        names one; filled up with -1.
    pursuer_positions : numpy.ndarray
        (T, 2). Against a hidden pursuer that the rules know as a disk only, a straight flight that
        explains each capture.
    disk_centers, disk_radii : numpy.ndarray
        (T, 2) and (T,): where the pursuer can be, by what the team knows.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> game = covey.simulate(team, disk, update_time=0.1)
    >>> game.evader_positions.shape == (len(game.times), 3, 2)
    True
    >>> print(game.status)
    every evader was captured
    """

    team: Team
    disk: PursuerDisk
    sensing: str
    update_time: float
    seed: int
    objective: Mapping[str, Any]
    strategies: Mapping[str, Mapping[str, Any]]
    status: GameStatus
    guarantee: float
    survival_time: float
    planned_value: float
    value: float
    capture_sequence: Ints
    capture_times: Floats
    times: Floats
    evader_positions: Floats
    evader_headings: Floats
    evader_turns: Floats
    guarantees: Floats
    assurances: Floats
    critical_sequences: Ints
    pursuer_sequences: Ints
    pursuer_positions: Floats
    disk_centers: Floats
    disk_radii: Floats

    @property
    def assurance(self) -> float:
        """Time by which the pursuer had, at time 0, assured the last capture; inf: none."""
        return float(self.assurances[0])

    def __repr__(self) -> str:
        """Return who played, what was guaranteed, and what came of it, in one line."""
        time = self.team.units.time
        sides = {side: str(strategy["name"]) for side, strategy in self.strategies.items()}
        return one_line(
            "Game",
            counted(len(self.team), "evader"),
            **sides,
            sensing=self.sensing,
            guarantee=quantity(self.guarantee, time),
            survival_time=quantity(self.survival_time, time),
            status=self.status,
        )

    def _repr_html_(self) -> str:
        columns = {
            "capture": range(1, len(self.capture_times) + 1),
            "evader": self.capture_sequence.tolist(),
            titled("time", self.team.units.time): self.capture_times.tolist(),
        }
        return html_table(repr(self), columns)

    def columns(self) -> dict[str, Any]:
        """Return the columns (T,) of the game's table by their names, evader_0_x for example."""
        columns: dict[str, Any] = {}
        for field, series in time_series(len(self.team)).items():
            names = np.ravel(series.columns).tolist()
            columns |= dict(zip(names, getattr(self, field).reshape(-1, len(names)).T, strict=True))
        return columns

    def to_pandas(self) -> Any:
        """Return the course of the game as a pandas data frame; pandas must be installed.

        A row is an update or a capture. The columns are those of the file that `save_game` writes.
        """
        return data_frame(self.columns())

    def outcome(self) -> Outcome:
        """Return what came of the game, without its course."""
        return Outcome(*(getattr(self, name) for name in Outcome._fields))
