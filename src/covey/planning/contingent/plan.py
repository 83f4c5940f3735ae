"""`plan_contingent`: turns now, and the turns that answer each capture, guaranteed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from covey.kernels.arrays import LARGEST_TABLE, MOST_EVADERS
from covey.kernels.capture.path import HEADING
from covey.kernels.contingent.branch import fly_branch, new_branch
from covey.kernels.contingent.minimum import new_levels, tree_value
from covey.kernels.contingent.tree import Tree, answer_to, tree_sizes
from covey.kernels.maximum.working_set import WorkingSet
from covey.model import InputError, PursuerDisk, Team
from covey.model.angles import wrap_angle
from covey.model.display import html_table, one_line, quantity
from covey.model.units import units_with
from covey.model.validation import Floats, read_only, whole_number
from covey.model.value import Value
from covey.planning.border import about_center, check_game, pursuit_of
from covey.planning.contingent.delays import DelayedGuarantee, with_delays
from covey.planning.contingent.moment import Moment, after_capture
from covey.planning.contingent.search import deeper_and_deeper, problem_of
from covey.planning.open_loop import plan
from covey.planning.open_loop_plan import CRITICAL_WITHIN, PLAN_STATUS, PlanStatus
from covey.planning.workspace import workspace

MOST_TURNS = 20_000
"""Of a tree: as many as seven evaders need to answer every capture, or twelve to answer three."""


class Node(NamedTuple):
    """A node of a tree, and the game when the node begins."""

    moment: Moment  # its origin is the centre of the disk that the tree was planned for
    turns: Floats  # of the node's subtree, flat
    depth: int
    origin: Floats  # (2,)
    unit: str  # of lengths


@dataclass(frozen=True, eq=False)
class ContingentPlan(Value):
    """A plan that answers captures, and what it guarantees. All times count from its beginning.

    The policy: the evaders make `turns`. Once evider i has been captured, early or late, those left
    begin the turns of `after(i)` from where they are, and so on.

    Attributes
    ----------
    evaders : tuple of int
        Numbers, in the team that was planned for, of the n evaders whom the turns are for.
    turns : numpy.ndarray
        (n,) signed turns in [-π, π], radians, that everybody makes now.
    goal_headings : numpy.ndarray
        (n,) headings after these turns, radians in [-π, π]; of a subtree, where every capture
        happens as early as it can.
    survival_time : float
        Guaranteed where every capture happens as early as it can: the exact minimum over all
        capture sequences, computed again after the search, from the turns alone.
    depth : int
        Captures that are answered.
    critical_sequences : tuple of tuple of int
        Capture sequences that attain `survival_time`, or come within 1e-6 of it, relative, as far
        as the search met them; the worst first.
    status : PlanStatus
        How the ascent that found the plan ended.
    starts, steps : int
        What the search cost: ascents, and their steps of sequential quadratic programming.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> tree = covey.plan_contingent(team, disk)
    >>> tree.survival_time >= covey.plan(team, disk).survival_time - 1e-9
    True
    >>> answer = tree.after(0)
    >>> answer.evaders
    (1, 2)
    """

    evaders: tuple[int, ...]
    turns: Floats
    goal_headings: Floats
    survival_time: float
    depth: int
    critical_sequences: tuple[tuple[int, ...], ...]
    status: PlanStatus
    starts: int
    steps: int
    node: Node

    def __repr__(self) -> str:
        """Return what is guaranteed, how many captures are answered, and how the search ended."""
        return one_line(
            "ContingentPlan",
            survival_time=quantity(self.survival_time, units_with(self.node.unit).time),
            evaders=len(self.turns),
            depth=self.depth,
            critical_sequences=len(self.critical_sequences),
            status=self.status,
        )

    def _repr_html_(self) -> str:
        columns = {
            "evader": self.evaders,
            "turn (rad)": self.turns.tolist(),
            "goal heading (rad)": self.goal_headings.tolist(),
        }
        return html_table(repr(self), columns)

    @property
    def team(self) -> Team:
        """The evaders, where this plan begins."""
        x, y, headings, speeds, turn_rates = self.node.moment.evaders.T
        positions = np.column_stack([x, y]) + self.node.origin
        return Team(positions, headings, speeds, turn_rates, unit=self.node.unit)

    @property
    def disk(self) -> PursuerDisk:
        """Where the pursuer can be then."""
        pursuit = self.node.moment.pursuit
        center = self.node.origin + np.array([pursuit.center_x, pursuit.center_y])
        reach = 0.5 * pursuit.later_radius
        radius = pursuit.first_radius - reach
        return PursuerDisk(center, radius, pursuit.speed, reach, unit=self.node.unit)

    @cached_property
    def with_delays(self) -> DelayedGuarantee:
        """What is guaranteed if the pursuer may put off each capture; computed at first use.

        Examples
        --------
        >>> import covey
        >>> team = covey.Team([[0.3, 0.0], [0.0, 0.4]], headings=[0.0, 1.6])
        >>> tree = covey.plan_contingent(team, covey.PursuerDisk())
        >>> tree.with_delays.survival_time <= tree.survival_time
        True
        """
        moment, turns, depth, *_ = self.node
        tree = Tree(turns, depth, tree_sizes(len(self.turns), depth))
        return with_delays(moment, tree, self.survival_time, self.node.unit)

    def after(self, i: int) -> ContingentPlan:
        """Return the plan of those left once evader i was captured as early as it can be first.

        Parameters
        ----------
        i
            One of `evaders`.

        Raises
        ------
        InputError
            If i isn't one of `evaders`, or is the last.
        """
        i = whole_number("i", i, low=0)
        if i not in self.evaders or len(self.evaders) == 1:
            others = self.evaders if len(self.evaders) > 1 else ()
            raise InputError(
                f"i: expected an evader after whose capture others live, {others}, got {i}"
            )
        moment, turns, depth, *_ = self.node
        rank, n = self.evaders.index(i), len(self.evaders)
        now = turns[:n]
        time = float(moment.earliest(now)[rank])
        after, left = after_capture(moment, now, rank, time)
        evaders = tuple(j for j in self.evaders if j != i)
        if depth > 0:
            left = answer_to(turns, n, rank)
        node = self.node._replace(moment=after, turns=left, depth=max(depth - 1, 0))
        return _plan_of(node, evaders, self.status, (0, 0), [])


def plan_contingent(
    team: Team, disk: PursuerDisk, depth: int | None = None, *, seed: int = 0
) -> ContingentPlan:
    """Plan turns for now, and turns that answer each capture, so that the last capture is late.

    Parameters
    ----------
    team, disk
        The state of the game; up to 20 evaders.
    depth
        How many captures are answered; a team of N has N - 1 to answer. 0: none, as `covey.plan`;
        None: all. A deeper plan never guarantees less.
    seed
        Of the initial guesses.

    Returns
    -------
    ContingentPlan

    Raises
    ------
    InputError
        If an argument can't be used, or the tree would have more than 20 000 turns.

    Notes
    -----
    One joint max-min over the whole tree: its leaves are the capture sequences, and capture times
    follow Algorithm 1 along each branch, each from the state that the branch has led to. Sequential
    quadratic programming with exact derivatives on a few branches; an exact search finds the branch
    that is missing.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.0], [0.0, 0.4], [-0.5, 0.1]], headings=[0.0, 1.6, 3.0])
    >>> tree = covey.plan_contingent(team, covey.PursuerDisk())
    >>> tree.survival_time >= covey.plan(team, covey.PursuerDisk()).survival_time
    True
    >>> tree.after(0).evaders
    (1, 2)
    """
    check_game(team, disk)
    n = len(team)
    if n > LARGEST_TABLE:
        raise InputError(
            f"team: expected at most {LARGEST_TABLE} evaders for a plan that answers captures, got "
            f"{n}; covey.plan serves up to {MOST_EVADERS}"
        )
    depth = n - 1 if depth is None else min(whole_number("depth", depth, low=0), n - 1)
    _require_room(n, depth)
    whole_number("seed", seed, low=0)
    evaders = tuple(range(n))
    own, about = about_center(team, disk)
    moment = Moment(own.as_rows(), pursuit_of(about))
    first = plan(team, disk, seed=seed)
    if depth == 0:
        node = Node(moment, first.turns, 0, disk.center, team.unit)
        cost = (first.starts, first.steps)
        return _plan_of(node, evaders, first.status, cost, list(first.critical_sequences))
    found = deeper_and_deeper(moment, depth, first.turns, seed)
    node = Node(moment, found.turns, depth, disk.center, team.unit)
    cost = (first.starts + found.starts, first.steps + found.steps)
    critical = _sequences(found.branches, n)
    return _plan_of(node, evaders, PLAN_STATUS[found.status], cost, critical)


def _require_room(n: int, depth: int) -> None:
    turns = int(tree_sizes(n, depth)[0])
    if turns > MOST_TURNS:
        fits = max(k for k in range(depth) if tree_sizes(n, k)[0] <= MOST_TURNS)
        raise InputError(
            f"depth: expected a tree of at most {MOST_TURNS} turns, got {turns} for {n} evaders "
            f"that answer {depth} captures; choose a depth of at most {fits}"
        )


def _sequences(branches: WorkingSet, n: int) -> list[tuple[int, ...]]:
    return [tuple(row) for row in branches.sequences[: branches.used[0], :n].tolist()]


def _plan_of(
    node: Node,
    evaders: tuple[int, ...],
    status: PlanStatus,
    cost: tuple[int, int],
    candidates: list[tuple[int, ...]],
) -> ContingentPlan:
    """Return the plan of a node; what it guarantees follows from its turns alone."""
    moment, turns, depth, *_ = node
    n = len(evaders)
    problem, tree = problem_of(moment), Tree(turns, depth, tree_sizes(n, depth))
    worst = np.zeros(n, np.int64)
    value = tree_value(problem, tree, math.inf, worst, new_levels(n), workspace(n))
    branch = new_branch(n)
    times = {
        sequence: fly_branch(problem, tree, np.array(sequence, np.int64), branch)
        for sequence in dict.fromkeys([tuple(worst.tolist()), *candidates])
    }
    latest = value * (1.0 + CRITICAL_WITHIN)
    critical = [each for each in sorted(times, key=times.__getitem__) if times[each] <= latest]
    now = turns[:n].copy()
    return ContingentPlan(
        evaders=evaders,
        turns=read_only(now),
        goal_headings=read_only(wrap_angle(moment.evaders[:, HEADING] + now)),
        survival_time=value,
        depth=depth,
        critical_sequences=tuple(tuple(evaders[rank] for rank in each) for each in critical),
        status=status,
        starts=cost[0],
        steps=cost[1],
        node=node,
    )
