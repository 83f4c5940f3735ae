"""`covey simulate`: play a game, and tell what happened."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

import covey
from covey.cli.shared.arguments import Json, ScenarioFile, Seed
from covey.cli.shared.outputs import check_output, print_saved
from covey.cli.shared.sources import read_scenario
from covey.cli.shared.waiting import waiting
from covey.cli.show.json_output import game_as_json, print_json
from covey.cli.show.tables import print_game


def simulate(
    file: ScenarioFile,
    /,
    *,
    output: Annotated[
        Path | None,
        Parameter(
            name=["--output", "-o"],
            help="Save the record of the game here, as game.parquet for example.",
        ),
    ] = None,
    seed: Seed = None,
    json: Json = False,
) -> None:
    """Play a game, and print how long the team survived and who was captured when.

    The team survives until its last evader is captured. In open loop, iterative or not, that is
    never less than its first plan guarantees, nor is the sum where the game is about that. The
    record is one table, a row for every update, that `covey draw`, Python and any reader of Parquet
    files understand.

    Try:

        covey simulate fig3 --output game.parquet
    """
    scenario = read_scenario(file, seed)
    if output is not None:
        check_output(output, [".parquet"], "the record of a game")
    with waiting("playing"):
        game = scenario.simulate()
    if json:
        print_json(game_as_json(game))
    else:
        print_game(game)
    if output is not None:
        covey.save_game(game, output)
        print_saved(output)
