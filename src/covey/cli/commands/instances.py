"""`covey instances`: the covey set, what is known about its games, and whether it holds."""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

import covey
from covey import instances as the_set
from covey.cli.shared.arguments import Json
from covey.cli.shared.waiting import waiting
from covey.cli.show.instances import instance_as_json, print_instances
from covey.cli.show.json_output import print_json
from covey.model.units import counted


def instances(
    *names: Annotated[str, Parameter(name="NAME", help="Games of the set; by default all.")],
    check: Annotated[
        bool,
        Parameter(negative="", show_default=False, help="Compute every number again, and compare."),
    ] = False,
    time_limit: Annotated[
        float, Parameter(help="With --check: seconds for the guarantee of each plan.")
    ] = 60.0,
    json: Json = False,
) -> None:
    """List the covey set: games for comparisons, and what is known about each.

    The guaranteed time is that of the best plan known; where it isn't exact, it is a proven lower
    bound of what this plan guarantees. No team is sure of more than the upper bound. `covey show
    NAME` prints the state of a game, a scenario.

    Try:

        covey instances
        covey instances circle-6 --json
        covey instances circle-6 paper-5 --check
    """
    if check and json:
        raise covey.InputError("--json: leave it out with --check, which prints a line a game")
    chosen = [covey.load_instance(name) for name in names or the_set.instance_names()]
    if check:
        _check(chosen, time_limit)
    elif json:
        print_json({"instances": [instance_as_json(each) for each in chosen]})
    else:
        print_instances(chosen)


def _check(chosen: list[covey.Instance], time_limit: float) -> None:
    """Print a line for each game as soon as it is checked, and raise all mistakes at the end."""
    # Only now, as both load NumPy.
    from covey.instances.check import check
    from covey.model.validation import number

    number("time_limit", time_limit, low=0.0)
    wrong: list[str] = []
    for each in chosen:
        with waiting(f"checking {each.name}"):
            found = check(each, time_limit)
        wrong += [f"{each.name}: {mistake}" for mistake in found.mistakes]
        print(f"{each.name}: {_told(*found)}", flush=True)
    if wrong:
        raise covey.InputError(
            "\n  ".join([f"the covey set: {counted(len(wrong), 'mistake')}", *wrong])
        )


def _told(mistakes: list[str], undecided: list[str]) -> str:
    if mistakes:
        return counted(len(mistakes), "mistake")
    return "; ".join(["no mistake", *undecided]) if undecided else "every number holds"
