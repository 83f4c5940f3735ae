"""`covey plan`: the plan that a team would fly, and what it guarantees."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

import covey
from covey.cli.shared.arguments import Json, ScenarioFile, Seed
from covey.cli.shared.sources import read_scenario
from covey.cli.shared.waiting import waiting
from covey.cli.show.contingent import print_tree, tree_as_json
from covey.cli.show.json_output import plan_as_json, print_json
from covey.cli.show.tables import print_plan

if TYPE_CHECKING:
    from covey.model import Objective


def plan(
    file: ScenarioFile,
    /,
    *,
    contingent: Annotated[
        bool,
        Parameter(
            negative="", show_default=False, help="Plan, too, how the team answers each capture."
        ),
    ] = False,
    depth: Annotated[
        int | None,
        Parameter(help="With --contingent: how many captures are answered; by default all."),
    ] = None,
    time_limit: Annotated[
        float | None,
        Parameter(
            help="Seconds after which the search ends with the best plan so far. The plan then "
            "stands alone."
        ),
    ] = None,
    seed: Seed = None,
    json: Json = False,
) -> None:
    """Plan a team's flight, and print the survival time that it guarantees.

    Every evader turns once, at its full rate, and then flies straight. The guaranteed survival
    time holds against any pursuer in the disk, whatever it does; the critical sequences are the
    orders of capture by which it would come closest. Beside it stands a time that no team could be
    sure to exceed, whatever its strategy, even if it saw the pursuer. Where
    [game] names another objective, the plan is for that one, and stands alone. So does the plan of
    more than 20 evaders, for whom that time is too late to mean anything.

    A contingent plan also holds the turns that those left begin when an evader has been captured.

    Try:

        covey plan fig3
        covey plan fig3 --contingent
        covey plan many.toml --time-limit 10
    """
    from covey.kernels.arrays import LARGEST_TABLE  # only now, as they load NumPy
    from covey.planning.compiled_objective import checked_objective

    scenario = read_scenario(file, seed)
    objective = checked_objective(scenario.objective)
    last_capture = isinstance(objective, covey.LastCapture)
    if contingent:
        _check_contingent(objective, time_limit)
    elif depth is not None:
        raise covey.InputError(
            "--depth: expected --contingent beside it; without, none is answered"
        )
    with waiting("planning"):
        tree = scenario.plan_contingent(depth) if contingent else None
        bounded = last_capture and time_limit is None and len(scenario.team) <= LARGEST_TABLE
        bracket = scenario.bracket(depth=0) if bounded else None
        found = scenario.plan(time_limit) if bracket is None else bracket.plan
        if tree is not None:
            _ = tree.with_delays  # computed while the command says that it works
    if tree is not None and bracket is not None:
        if json:
            print_json(tree_as_json(scenario, tree, bracket))
        else:
            print_tree(scenario, tree, bracket)
    elif json:
        print_json(plan_as_json(scenario, found, bracket))
    else:
        print_plan(scenario, found, bracket)


def _check_contingent(objective: Objective, time_limit: float | None) -> None:
    """Raise InputError if there are no plans that answer captures for this."""
    if not isinstance(objective, covey.LastCapture):
        raise covey.InputError(
            "--contingent: expected a scenario about the last capture, got the objective "
            f"{objective.describe()['name']}; leave [game] objective out"
        )
    if time_limit is not None:
        raise covey.InputError(
            "--time-limit: expected without --contingent, whose search has no limit"
        )
