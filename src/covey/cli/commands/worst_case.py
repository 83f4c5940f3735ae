"""`covey worst-case`: the worst that a hidden pursuer can do to the team's strategy."""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from covey.cli.shared.arguments import Json, ScenarioFile, Seed
from covey.cli.shared.sources import read_scenario
from covey.cli.shared.waiting import waiting
from covey.cli.show.json_output import print_json, worst_case_as_json
from covey.cli.show.tables import print_worst_case


def worst_case(
    file: ScenarioFile,
    /,
    *,
    delays: Annotated[
        list[float] | None,
        Parameter(
            consume_multiple=True,
            negative="",
            help="Times that each capture may wait, as in --delays 0 0.1 0.3; by default none "
            "waits, and a capture comes as soon as the pursuer's disk reaches the evader.",
        ),
    ] = None,
    seed: Seed = None,
    json: Json = False,
) -> None:
    """Find the order of capture by which a hidden pursuer ends the team's survival earliest.

    The team plays its strategy from the file; the file's pursuer and sensing don't matter. All
    orders are searched, and what is printed names what else was.

    Try:

        covey worst-case fig3
    """
    scenario = read_scenario(file, seed)
    with waiting("searching all orders of capture"):
        found = scenario.worst_case(delays or [0.0])
    if json:
        print_json(worst_case_as_json(found))
    else:
        print_worst_case(scenario, found)
