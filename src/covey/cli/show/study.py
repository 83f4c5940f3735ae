"""Studies on the screen: how far a run is, what came of it, what failed."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)
from rich.table import Table

from covey.cli.shared.outputs import print_saved
from covey.cli.shared.sources import path_of
from covey.cli.show.comparison import print_comparison
from covey.studies import (
    CaseSummary,
    Study,
    StudyResult,
    example_names,
    example_path,
    read_study,
    run_study,
    summary,
)
from covey.studies.analysis.comparison import comparison
from covey.studies.statistics import Estimate

_HEADINGS = {"team_size": "team", "turn_rate": "turn rate", "update_time": "update time"}


def study_path(name: str) -> Path:
    """Return the file of a study, given by its path or by the name of one that comes with covey."""
    return path_of(name, "study", {each: example_path(each) for each in example_names()})


def follow(
    study: Study | Path, folder: Path, workers: int | None = None, dask: str | None = None
) -> StudyResult:
    """Run a study with a bar that shows how far it is, and for how long it will go on."""
    chosen = study if isinstance(study, Study) else read_study(study)
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("games"),
        TimeElapsedColumn(),
        TextColumn("left"),
        TimeRemainingColumn(),
    )
    console = Console(stderr=True)
    with Progress(
        *columns, console=console, transient=True, disable=not console.is_terminal
    ) as bar:
        task = bar.add_task(folder.name, total=chosen.games, start=False)

        def progress(done: int, total: int) -> None:
            # What earlier runs have done says nothing about the speed of this one: the clock
            # starts after it.
            bar.update(task, completed=done, total=total)
            bar.start_task(task)

        return run_study(chosen, folder, workers=workers, dask=dask, progress=progress)


def print_study(result: StudyResult) -> None:
    """Print a line for each case, or the tables of a comparison, and what is missing."""
    console = Console(highlight=False)
    compared = comparison(result)
    if compared is not None:
        print_comparison(console, compared)
    else:
        _print_cases(console, result)
    print_saved(result.folder)
    for failure in result.failures:
        print(f"covey: {failure}", file=sys.stderr)
    if result.failures:
        print("covey: run the study again to try the missing games anew", file=sys.stderr)


def _print_cases(console: Console, result: StudyResult) -> None:
    lines = summary(result)
    table = Table(box=SIMPLE_HEAD, pad_edge=False)
    settings = list(lines[0].settings)
    stopped, valued = any(line.stopped for line in lines), lines[0].value is not None
    for heading in (
        *(_HEADINGS.get(name, name.replace("_", " ")) for name in settings),
        "guaranteed",
        "survival time",
        "relative",
        *(["value"] if valued else []),
        *(["stopped"] if stopped else []),
    ):
        table.add_column(heading, justify="right", no_wrap=True)
    for line in lines:
        table.add_row(*_row(line), *([str(line.stopped)] if stopped else []))
    console.print(table)
    console.print(
        f"Means over {lines[0].starts} starts, ± 95 % confidence. Relative: mean over the mean of "
        "the first line of the same team, from the same starts."
        + (" Value: what came of the objective." if valued else "")
    )


def _row(line: CaseSummary) -> list[str]:
    return [
        *(f"{v:.4g}" if isinstance(v, float) else str(v) for v in line.settings.values()),
        f"{line.guarantee:.4f}",
        estimate(line.survival),
        estimate(line.relative) if line.relative.error > 0.0 else f"{line.relative.value:.4f}",
        *([] if line.value is None else [estimate(line.value)]),
    ]


def estimate(value: Estimate) -> str:
    """Write a number with its uncertainty."""
    return f"{value.value:.4f} ± {value.error:.4f}"


def study_as_json(result: StudyResult) -> dict[str, Any]:
    """Return the lines of a study for programs."""
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
            for line in summary(result)
        ],
    }
