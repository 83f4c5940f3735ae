"""Studies on the screen: how far a run is, its results, and what failed."""

from __future__ import annotations

import math
from pathlib import Path

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

from covey import studies
from covey.cli.shared.exit_status import MissingGamesError
from covey.cli.shared.outputs import print_saved
from covey.cli.show.comparison import print_comparison
from covey.kernels.library.load import load_library
from covey.model.units import counted, titled

_HEADINGS = {"team_size": "team"}


def run_with_progress(
    study: studies.Study, folder: Path, workers: int | None, dask: str | None = None
) -> studies.StudyResult:
    """Run a study with a bar that shows how far it is, and the time that is left."""
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("games"),
        TimeElapsedColumn(),
        TextColumn("passed,"),
        TimeRemainingColumn(),
        TextColumn("left"),
    )
    from covey.studies.running.executors import end_processes  # only now, as it loads much

    if dask is None:
        load_library()  # shows a bar of its own while it compiles
    console = Console(stderr=True)
    with Progress(
        *columns, console=console, transient=True, disable=not console.is_terminal
    ) as bar:
        task = bar.add_task(folder.name, total=study.games, start=False)

        def progress(done: int, total: int) -> None:
            # Only now starts the clock: the games of earlier runs took no time in this one.
            bar.update(task, completed=done, total=total)
            bar.start_task(task)

        try:
            return studies.run_study(study, folder, workers=workers, dask=dask, progress=progress)
        except KeyboardInterrupt:
            raise KeyboardInterrupt(
                f"{folder} keeps the games that were finished, and the same command goes on there"
            ) from None
        finally:
            end_processes()


def print_study(result: studies.StudyResult) -> None:
    """Print a line for each case, or the tables of a comparison."""
    console = Console(highlight=False)
    compared = studies.comparison(result)
    if compared is not None:
        print_comparison(console, compared)
    else:
        _print_cases(console, result)
    print_saved(result.folder)


def require_all_games(result: studies.StudyResult) -> None:
    """Raise MissingGamesError if games could not be played."""
    if result.failures:
        head = f"{result.folder}: games are missing; run the study again to try them anew"
        raise MissingGamesError("\n  ".join([head, *result.failures]))


def _print_cases(console: Console, result: studies.StudyResult) -> None:
    lines = studies.summary(result)
    table = Table(box=SIMPLE_HEAD, pad_edge=False)
    settings = list(lines[0].settings)
    second = result.units.time
    stopped, valued = any(line.stopped for line in lines), lines[0].value is not None
    for name in settings:
        heading = titled(_HEADINGS.get(name, name.replace("_", " ")), result.unit_of(name))
        table.add_column(heading, justify="right", overflow="fold")  # where a name is long
    for heading in (
        titled("guaranteed", second),
        titled("survival time", second),
        "relative",
        *([titled("value", second)] if valued else []),
        *(["stopped"] if stopped else []),
    ):
        table.add_column(heading, justify="right", no_wrap=True)
    for line in lines:
        settings_text = (result.text_of(*setting) for setting in line.settings.items())
        table.add_row(*settings_text, *_row(line), *([str(line.stopped)] if stopped else []))
    console.print(table)
    console.print(
        f"Means over {counted(lines[0].starts, 'start')}, ± 95 % confidence. Relative: mean over "
        "the mean of the first line of the same team, from the same starts."
        + (" Value: what came of the objective." if valued else "")
    )


def _row(line: studies.CaseSummary) -> list[str]:
    return [
        f"{line.guarantee:.4f}",
        _estimate(line.survival),
        _estimate(line.relative) if line.relative.error > 0.0 else f"{line.relative.value:.4f}",
        *([] if line.value is None else [_estimate(line.value)]),
    ]


def _estimate(value: studies.Estimate) -> str:
    """Write a number with its uncertainty, which a single start doesn't tell."""
    if math.isnan(value.error):
        return f"{value.value:.4f}"
    return f"{value.value:.4f} ± {value.error:.4f}"
