"""`covey plan`: the plan that a team would fly, and what it guarantees."""

from __future__ import annotations

from covey.cli.arguments import Json, ScenarioFile, Seed


def plan(file: ScenarioFile, /, *, seed: Seed = None, json: Json = False) -> None:
    """Plan a team's flight, and print the survival time that it guarantees.

    Every evader turns once, at its full rate, and then flies straight. The guaranteed survival
    time holds against any pursuer in the disk, whatever it does; the critical sequences are the
    orders of capture by which it would come closest. Beside it stands a time that no team could be
    sure to exceed, whatever its strategy, even if it saw the pursuer and turned at once.

    Try:

        covey plan fig3
    """
    from covey.cli.sources import read_scenario

    scenario = read_scenario(file, seed)
    found = scenario.bracket()
    if json:
        from covey.cli.report import bracket_as_json, print_json

        print_json(bracket_as_json(scenario, found))
    else:
        from covey.cli.tables import print_bracket

        print_bracket(scenario, found)
