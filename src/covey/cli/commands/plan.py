"""`covey plan`: the plan that a team would fly, and what it guarantees."""

from __future__ import annotations

import covey
from covey.cli.shared.arguments import Json, ScenarioFile, Seed
from covey.cli.shared.sources import read_scenario
from covey.cli.shared.waiting import waiting
from covey.cli.show.json_output import plan_as_json, print_json
from covey.cli.show.tables import print_plan


def plan(file: ScenarioFile, /, *, seed: Seed = None, json: Json = False) -> None:
    """Plan a team's flight, and print the survival time that it guarantees.

    Every evader turns once, at its full rate, and then flies straight. The guaranteed survival
    time holds against any pursuer in the disk, whatever it does; the critical sequences are the
    orders of capture by which it would come closest. Beside it stands a time that no team could be
    sure to exceed, whatever its strategy, even if it saw the pursuer and turned at once. Where
    [game] names another objective, the plan is for that one, and stands alone.

    Try:

        covey plan fig3
    """
    scenario = read_scenario(file, seed)
    with waiting("planning"):
        bracket = scenario.bracket() if isinstance(scenario.objective, covey.LastCapture) else None
        found = scenario.plan() if bracket is None else bracket.plan
    if json:
        print_json(plan_as_json(scenario, found, bracket))
    else:
        print_plan(scenario, found, bracket)
