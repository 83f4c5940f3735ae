"""A game as a file describes it: who is where, how it is played, and by which strategies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from covey.bounds import Bracket, bracket
from covey.model import LastCapture, Objective, PursuerDisk, Team
from covey.model.display import html_facts
from covey.model.units import titled
from covey.model.value import Value
from covey.planning import ContingentPlan, Plan, plan, plan_contingent
from covey.planning.open_loop import starts_followed
from covey.players import IterativeOpenLoop, OpenLoop, WorstCase, simulate, worst_case
from covey.players.names import team_strategy
from covey.simulation import Game, PursuerPolicy, PursuerStrategy, TeamPolicy, TeamStrategy


@dataclass(frozen=True, eq=False)
class Scenario(Value):
    """All that `plan` and `simulate` need.

    Attributes
    ----------
    team, disk : Team, PursuerDisk
        The state at time 0.
    evaders, pursuer
        Strategies, by value or by name; see `simulate`.
    sensing : str
        "hidden" or "visible".
    update_time : float
        Δt between updates.
    seed : int
        Seed of the searches for plans.
    time_limit : float or None
        When a game is stopped; see `simulate`.
    objective
        What the game is about; see `plan` and `simulate`.

    Examples
    --------
    >>> import covey
    >>> scenario = covey.load_scenario("uncertain")
    >>> game = scenario.simulate()
    >>> game.capture_sequence.tolist()
    [2, 0, 3, 1]
    """

    team: Team
    disk: PursuerDisk
    evaders: TeamStrategy | TeamPolicy | str
    pursuer: PursuerStrategy | PursuerPolicy | str
    sensing: str
    update_time: float
    seed: int
    time_limit: float | None
    objective: Objective | str = LastCapture()  # noqa: RUF009 frozen

    def _repr_html_(self) -> str:
        second = self.team.units.time
        times = {name: titled(name, second) for name in ("update_time", "time_limit")}
        facts = {times.get(name, name): value for name, value in vars(self).items()}
        return html_facts("Scenario", facts)

    def plan(self, time_limit: float | None = None) -> Plan:
        """Return the open-loop plan, with which a team that flies one begins the game.

        Parameters
        ----------
        time_limit
            Seconds after which the search ends, see `covey.plan`.
        """
        return plan(
            self.team,
            self.disk,
            objective=self.objective,
            seed=self.seed,
            starts=self._starts,
            time_limit=time_limit,
        )

    def plan_contingent(self, depth: int | None = None) -> ContingentPlan:
        """Return the plan for the last capture that answers captures, see `plan_contingent`."""
        return plan_contingent(self.team, self.disk, depth, seed=self.seed)

    def bracket(self, depth: int | None = None) -> Bracket:
        """Return plans for the last capture, and what no team could be sure to exceed.

        Parameters
        ----------
        depth
            How many captures are answered, see `covey.bracket`.
        """
        return bracket(self.team, self.disk, depth=depth, seed=self.seed, starts=self._starts)

    def worst_case(self, delays: Sequence[float] = (0.0,)) -> WorstCase:
        """Return the least survival time of the team's strategy against a hidden pursuer."""
        return worst_case(
            self.team,
            self.disk,
            evaders=self.evaders,
            delays=delays,
            update_time=self.update_time,
            seed=self.seed,
            objective=self.objective,
        )

    def simulate(self) -> Game:
        """Play the game and return its record."""
        return simulate(
            self.team,
            self.disk,
            evaders=self.evaders,
            pursuer=self.pursuer,
            sensing=self.sensing,
            update_time=self.update_time,
            seed=self.seed,
            time_limit=self.time_limit,
            objective=self.objective,
        )

    @property
    def _starts(self) -> int | None:
        """Starts of the search for the plan, which strategies that fly none don't name."""
        evaders = team_strategy(self.evaders)
        if isinstance(evaders, OpenLoop | IterativeOpenLoop):
            return starts_followed(evaders.starts, len(self.team))
        return None
