"""`covey study`: many games, on all cores or on a cluster."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter

from covey import studies
from covey.cli.shared.arguments import FileOrName, Json
from covey.cli.shared.outputs import results_folder
from covey.cli.show.json_output import print_json
from covey.cli.show.study import print_study, require_all_games, run_with_progress


def study(
    file: Annotated[
        FileOrName,
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
    starts: Annotated[
        int | None,
        Parameter(
            help="Starts in place of the file's. Their results have a folder of their own, named "
            "after their number too."
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

    Games that can't be played are left out and reported; the exit status is 3 then.

    Studies that come with covey are asked for by name: fig4 and fig5, those of the paper;
    tournament, every team against every pursuer; objectives, games about other things than the
    last capture; growth, teams of one to fifty.

    Try:

        covey study fig4 --output fig4
        covey study fig4 --starts 20
    """
    chosen, name = studies.read_study(file), Path(file).stem
    if starts is not None:
        chosen, name = replace(chosen, starts=starts), f"{name}-{starts}-starts"
    folder = results_folder(output, name)
    result = run_with_progress(chosen, folder, workers, dask)
    if json:
        print_json(_as_json(result))
    else:
        print_study(result)
    require_all_games(result)


def _as_json(result: studies.StudyResult) -> dict[str, Any]:
    """Return the cases of a study for programs."""
    return {
        "folder": str(result.folder),
        "games": result.manifest["games"],
        "complete": result.is_complete,
        "failures": list(result.failures),
        "cases": [
            {
                "case": line.case,
                **line.settings,
                "starts": line.starts,
                "stopped": line.stopped,
                "guarantee": line.guarantee,
                "survival_time": line.survival._asdict(),
                "relative": line.relative._asdict(),
                **({} if line.value is None else {"value": line.value._asdict()}),
            }
            for line in studies.summary(result)
        ],
    }
