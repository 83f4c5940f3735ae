"""`covey score`: a strategy of one's own on the covey set."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter

import covey
from covey import instances
from covey.cli.shared.arguments import Json
from covey.cli.shared.outputs import check_output, write_csv
from covey.cli.shared.own_strategy import load_strategy
from covey.cli.shared.waiting import counting
from covey.cli.show.instances import print_scores
from covey.cli.show.json_output import print_json

_BESIDE = ("iterative-open-loop", "open-loop", "straight-away")


def score(
    strategy: Annotated[
        str,
        Parameter(
            name="MODULE:NAME",
            help="A team's strategy: a function, a value, or a class that needs no arguments, in "
            "a Python module of this folder or an installed one.",
        ),
    ],
    /,
    *names: Annotated[
        str, Parameter(name="NAME", help="Games of the set; by default all up to a size.")
    ],
    evaders: Annotated[
        int, Parameter(help="The most evaders of a game, where no games are named.")
    ] = 8,
    beside: Annotated[
        list[str] | None,
        Parameter(
            consume_multiple=True,
            negative="",
            help="Strategies that come with covey and play the same games; by default "
            f"{', '.join(_BESIDE)}.",
        ),
    ] = None,
    seed: Annotated[int, Parameter(help="Of the strategies.")] = 0,
    output: Annotated[
        Path | None,
        Parameter(name=["--output", "-o"], help="Save every game here, as scores.csv for example."),
    ] = None,
    json: Json = False,
) -> None:
    """Play a team's strategy of one's own on the covey set, beside some that come with covey.

    Each game is played against four pursuers: one that keeps to the capture sequence that is worst
    for the best plan known, and the committed one, both hidden and visible. The table has the least
    of the four survival times, relative to what the best plan known guarantees. A team that flies
    that plan comes to 1 at least.

    Try:

        covey score my_module:MyTeam
        covey score my_module:MyTeam circle-12 mixed-12 -o scores.csv
    """
    if output is not None:
        check_output(output, [".csv"], "the scores")
    chosen = [covey.load_instance(name) for name in names or instances.instance_names()]
    if not names:
        chosen = _up_to(evaders, chosen)
    scores = _play(
        {strategy: load_strategy(strategy), **_built_in(beside or _BESIDE)}, chosen, seed
    )
    if json:
        print_json({name: [each._asdict() for each in rows] for name, rows in scores.items()})
    else:
        print_scores(scores)
    if output is not None:
        heads = ("strategy", *instances.Score._fields)
        rows = [(name, *each) for name, scored in scores.items() for each in scored]
        write_csv(output, heads, rows)


def _up_to(most: int, chosen: list[covey.Instance]) -> list[covey.Instance]:
    from covey.model.validation import whole_number  # only now, as it loads NumPy

    whole_number("evaders", most, low=min(len(each.team) for each in chosen))
    return [each for each in chosen if len(each.team) <= most]


def _built_in(names: Sequence[str]) -> dict[str, Any]:
    from covey.players.names import team_strategy  # only now, as it loads the kernels

    return {name: team_strategy(name) for name in names}


def _play(
    strategies: Mapping[str, Any], chosen: list[covey.Instance], seed: int
) -> dict[str, list[instances.Score]]:
    """Play all games of all strategies, and show in a terminal how far that is."""
    scores: dict[str, list[instances.Score]] = {name: [] for name in strategies}
    with counting("playing", len(chosen) * len(strategies)) as played:
        for game in chosen:
            for name, strategy in strategies.items():
                try:
                    scores[name] += instances.score(game, strategy, seed=seed)
                except covey.InputError as error:
                    raise covey.InputError(f"{game.name}: {name}: {error}") from error
                played()
    return scores
