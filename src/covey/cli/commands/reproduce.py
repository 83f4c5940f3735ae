"""`covey reproduce`: the paper's figures, from scratch, and a report on its claims."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter

import covey
from covey import studies, views
from covey.cli.shared.outputs import print_saved, save_picture, write_csv, write_text
from covey.cli.shared.sources import read_scenario
from covey.cli.show.film import save_film
from covey.cli.show.study import print_study, require_all_games, run_with_progress
from covey.cli.show.tables import print_game

_GAINS = ("ratio", "ratio_error", "mean", "mean_error")


def reproduce(
    *,
    output: Annotated[
        Path,
        Parameter(name=["--output", "-o"], help="Folder for the report, the figures, the games."),
    ] = Path("results"),
    starts: Annotated[
        int | None,
        Parameter(help="Starts of Figs. 4 and 5: 500, as in the paper, or fewer for a quick look."),
    ] = None,
    assured_starts: Annotated[
        int,
        Parameter(
            help="Starts of Fig. 4 with the assured pursuer, which takes half a second each."
        ),
    ] = 50,
    contingent_starts: Annotated[
        int,
        Parameter(
            help="Starts of Fig. 5 with teams that answer captures, which take half a second each."
        ),
    ] = 50,
    workers: Annotated[
        int | None,
        Parameter(help="Processes on this machine; by default as many as it has cores."),
    ] = None,
) -> None:
    """Reproduce the paper: Figs. 1 to 5, and a report that sets our figures beside its claims.

    Plays the game of Fig. 3 and the studies of Figs. 4 and 5, 19 000 games in all. report.md tells
    what came out; the figures stand beside it as .png, .svg and .pdf, and every game is in the
    folders fig4, fig4-assured, fig5 and fig5-contingent. A run that was stopped goes on where it
    was.

    Try:

        covey reproduce --output results
    """
    from covey.model.validation import whole_number  # only now, as it loads NumPy
    from covey.simulation.files import make_folder

    if workers is not None:
        whole_number("workers", workers, low=1)
    chosen = {
        "fig4": _study("fig4", starts),
        "fig4-assured": _study("fig4-assured", _fewer(assured_starts, starts)),
        "fig5": _study("fig5", starts),
        "fig5-contingent": _study("fig5-contingent", _fewer(contingent_starts, starts)),
    }
    for folder in (output, *(output / name for name in chosen)):
        make_folder(folder)
    game = _reproduce_game(output)
    fig4, assured = (
        _result(chosen[name], output / name, workers) for name in ("fig4", "fig4-assured")
    )
    _draw_ratios(output, fig4, assured)
    fig5, contingent = (
        _result(chosen[name], output / name, workers) for name in ("fig5", "fig5-contingent")
    )
    _draw_gains(output, fig5, contingent)
    write_text(output / "report.md", studies.report(game, fig4, assured, fig5, contingent))


def _fewer(own: int, starts: int | None) -> int:
    return own if starts is None else min(own, starts)


def _reproduce_game(folder: Path) -> covey.Game:
    """Draw Figs. 1 and 2, play and draw the game of Fig. 3."""
    game = read_scenario("fig3", None).simulate()
    print_game(game)
    covey.save_game(game, folder / "fig3.parquet")
    print_saved(folder / "fig3.parquet")
    for name, figure in (
        ("fig1", views.draw_control()),
        ("fig2", views.draw_capture()),
        ("fig3", views.draw_snapshots(game, views.times_around_first_capture(game))),
        ("fig3-game", views.draw_game(game)),
    ):
        save_picture(figure, folder, name)
    save_film(views.animate(game), folder / "fig3.gif")
    return game


def _draw_ratios(folder: Path, fig4: studies.StudyResult, assured: studies.StudyResult) -> None:
    """Draw Fig. 4, and write its numbers."""
    ratios = studies.survival_ratios(fig4)
    beside = studies.survival_ratios(assured)
    save_picture(views.draw_ratios(ratios, beside=beside), folder, "fig4")
    write_csv(
        folder / "fig4.csv",
        ("team_size", "start", "hidden_over_visible"),
        ((size, k, q) for size, values in ratios.items() for k, q in enumerate(values.tolist())),
    )


def _draw_gains(folder: Path, fig5: studies.StudyResult, contingent: studies.StudyResult) -> None:
    """Draw Fig. 5, and write its numbers."""
    gains = studies.turn_rate_gains(fig5)
    beside = studies.raised(gains["hidden"], studies.answer_gains(contingent))
    save_picture(_gains_figure(gains, beside), folder, "fig5")
    rows = [(word, "iterative-open-loop", each) for word, each in gains.items()]
    write_csv(
        folder / "fig5.csv",
        ("sensing", "evaders", "team_size", "turn_rate", *_GAINS),
        (
            (word, team, size, rate, *each.ratios[size][k], *each.survival[size][k])
            for word, team, each in [*rows, ("hidden", "contingent", beside)]
            for size in each.ratios
            for k, rate in enumerate(each.turn_rates)
        ),
    )


def _study(name: str, starts: int | None) -> studies.Study:
    study = studies.read_study(studies.example_path(name))
    return study if starts is None else replace(study, starts=starts)


def _result(study: studies.Study, folder: Path, workers: int | None) -> studies.StudyResult:
    result = run_with_progress(study, folder, workers)
    print_study(result)
    require_all_games(result)
    return result


def _gains_figure(gains: dict[str, studies.Gains], contingent: studies.Gains) -> Any:
    from covey.views.charts.study import curves_of  # only now, as it loads matplotlib

    panels = {f"{word} pursuer": curves_of(each) for word, each in gains.items()}
    beside = {"hidden pursuer": curves_of(contingent)}
    return views.draw_gains(contingent.turn_rates, panels, beside=beside)
