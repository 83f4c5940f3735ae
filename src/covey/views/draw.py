"""One function that draws whatever has a picture."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.bounds import Bracket
from covey.model import InputError
from covey.model.validation import shown
from covey.planning import ContingentPlan, Plan
from covey.scenarios import Scenario
from covey.simulation import Game
from covey.studies import StudyResult
from covey.views.charts.study import draw_study
from covey.views.games.game import draw_game
from covey.views.games.plan import draw_bracket, draw_plan
from covey.views.games.scenario import draw_scenario
from covey.views.games.tree import draw_contingent

_DRAWN: Mapping[type, Callable[..., Figure]] = {
    Scenario: draw_scenario,
    Plan: draw_plan,
    ContingentPlan: draw_contingent,
    Bracket: draw_bracket,
    Game: draw_game,
    StudyResult: draw_study,
}


def draw(
    x: Scenario | Plan | ContingentPlan | Bracket | Game | StudyResult,
    ax: Axes | None = None,
    *,
    title: str | None = None,
    width: float | None = None,
) -> Figure:
    """Draw a scenario, a plan, a contingent plan, a bracket, a game or the results of a study.

    Parameters
    ----------
    x
        What `covey.load_scenario`, `plan`, `plan_contingent`, `bracket`, `simulate`, `run_study` or
        one of their kind returned. Of a scenario the start is drawn.
    ax
        Axes to draw on; a picture of several panels is drawn in their place. Default: a new figure.
    title
        Above the picture. Default: what it shows in a few words, if it has a single map.
    width
        Of a new figure, inches. Default: one or two columns of a paper, 3.5 or 7.

    Returns
    -------
    matplotlib.figure.Figure
        It shows itself in a notebook. `covey.views.save` and its own `savefig` write it to a file.

    Raises
    ------
    InputError
        If `x` is something else, a study too few of whose games came to their end, or the width
        isn't one of 1 to 100 inches.

    Notes
    -----
    `covey.views` has a function for each, and others: snapshots of a game, the paper's figures.

    Examples
    --------
    >>> import covey
    >>> picture = covey.draw(covey.load_scenario("fig3").plan())
    """
    options: dict[str, Any] = {} if title is None else {"title": title}
    if width is not None:
        options["width"] = width
    for kind, function in _DRAWN.items():
        if isinstance(x, kind):
            return function(x, ax=ax, **options)
    raise InputError(
        "x: expected a scenario, a plan, a contingent plan, a bracket, a game or the results of a "
        f"study, got {shown(x)}"
    )
