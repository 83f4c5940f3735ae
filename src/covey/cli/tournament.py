"""A tournament on the screen: a table of teams and pursuers for each sensing; and its picture."""

from __future__ import annotations

from pathlib import Path

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table

from covey.cli.outputs import check_output, print_saved
from covey.model import InputError
from covey.studies import StudyResult, load_study
from covey.studies.tournament import Score, is_tournament, labels, scores


def print_tournament(console: Console, result: StudyResult) -> None:
    """Print the mean over the team sizes of each team's survival, relative to the first team."""
    overall = [score for score in scores(result) if score.team_size is None]
    for sensing in result.study["grid"]["sensing"]:
        chosen = [score for score in overall if score.sensing == sensing]
        console.print(_table(f"{sensing} pursuer", chosen))
    sizes = ", ".join(map(str, result.study["grid"]["team_size"]))
    console.print(
        f"Mean survival time over that of {overall[0].evaders}, from the same "
        f"{overall[0].played} starts, ± 95 % confidence; mean over teams of {sizes}."
    )
    if any(score.starts < score.played for score in overall):
        console.print("* Without the starts of which a game was stopped with evaders alive.")


def _table(title: str, chosen: list[Score]) -> Table:
    pursuers = list(dict.fromkeys(score.pursuer for score in chosen))
    cells = {(score.evaders, score.pursuer): _cell(score) for score in chosen}
    table = Table(
        title=title, title_justify="left", box=SIMPLE_HEAD, pad_edge=False, padding=(0, 0, 0, 0)
    )
    table.add_column("team", no_wrap=True)
    for pursuer in pursuers:
        table.add_column(pursuer.replace("-", " "), justify="right")
    for evaders in dict.fromkeys(score.evaders for score in chosen):
        table.add_row(evaders, *(cells[evaders, pursuer] for pursuer in pursuers))
    return table


def _cell(score: Score) -> str:
    value, error = score.relative
    text = f"{value:.3f}" if error == 0.0 else f"{value:.3f} ±{error:.3f}".replace("±0", "±")
    return text + ("*" if score.starts < score.played else "")


def draw_tournament(folder: Path, output: Path) -> None:
    """Draw the picture of a tournament whose results are in a folder."""
    from covey import views
    from covey.views.saving import STILLS
    from covey.views.tournament import Ratio

    check_output(output, STILLS, "a picture")
    result = load_study(folder)
    if not is_tournament(result.study):
        raise InputError(
            f"{folder}: expected a study of several teams in which, beside them, only team sizes, "
            "pursuers and sensing vary; there is no picture of any other"
        )
    base = labels(result.study["grid"]["evaders"])[0]
    ratios = [
        Ratio(f"{each.sensing} pursuer", each.pursuer, each.evaders, each.team_size, *each.relative)
        for each in scores(result)
        if each.team_size is not None and each.evaders != base and each.starts > 1
    ]
    print_saved(views.save(views.draw_tournament(ratios, base), output))
