"""`covey study`: many games, on all cores or on a cluster."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from covey.cli.shared.arguments import Json


def study(
    file: Annotated[
        str,
        Parameter(
            name="FILE", help="Study, a TOML file; or the name of one that comes with covey."
        ),
    ],
    /,
    *,
    output: Annotated[
        Path | None,
        Parameter(
            name=["--output", "-o"],
            help="Folder for the results; by default results/ and the name of the file. A study "
            "that was stopped goes on where it was.",
        ),
    ] = None,
    workers: Annotated[
        int | None,
        Parameter(help="Processes on this machine; by default as many as it has cores."),
    ] = None,
    dask: Annotated[
        str | None,
        Parameter(help="Play on a Dask cluster: the address of its scheduler, tcp://..."),
    ] = None,
    json: Json = False,
) -> None:
    """Play many games, keep them all in Parquet files, and print averages.

    Every start is played in every case of the study's grid. The tables come out the same, byte for
    byte, for any number of workers and however often the run was stopped and started again.

    Four studies come with covey and are asked for by name: fig4 and fig5, those of the paper,
    tournament, every team against every pursuer, and objectives, games about other things than the
    last capture.

    Try:

        covey study fig4 --output results/fig4
    """
    from covey.cli.show.study import follow, print_study, study_path

    path = study_path(file)
    result = follow(path, output or Path("results") / path.stem, workers, dask)
    if json:
        from covey.cli.show.json_output import print_json
        from covey.cli.show.study import study_as_json

        print_json(study_as_json(result))
    else:
        print_study(result)
    if result.failures:
        raise SystemExit(1)
