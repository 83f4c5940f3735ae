"""Pictures and films of plans, games and studies. They read records, and never solve.

Read `kit` first (what all pictures share), then `games`, `film` and `charts`. Importing this room
is cheap: matplotlib is loaded with the first picture.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from covey.views.charts.capture import draw_capture
    from covey.views.charts.closeness import draw_closeness
    from covey.views.charts.comparison import draw_comparison
    from covey.views.charts.control import draw_control
    from covey.views.charts.gains import draw_gains
    from covey.views.charts.ratios import draw_ratios
    from covey.views.film.animation import animate
    from covey.views.games.game import draw_game
    from covey.views.games.plan import draw_plan
    from covey.views.games.snapshots import draw_snapshots
    from covey.views.kit.saving import save

__all__ = [
    "animate",
    "draw_capture",
    "draw_closeness",
    "draw_comparison",
    "draw_control",
    "draw_gains",
    "draw_game",
    "draw_plan",
    "draw_ratios",
    "draw_snapshots",
    "save",
]

_HOMES = {
    "animate": "film.animation",
    "draw_capture": "charts.capture",
    "draw_closeness": "charts.closeness",
    "draw_comparison": "charts.comparison",
    "draw_control": "charts.control",
    "draw_gains": "charts.gains",
    "draw_game": "games.game",
    "draw_plan": "games.plan",
    "draw_ratios": "charts.ratios",
    "draw_snapshots": "games.snapshots",
    "save": "kit.saving",
}


def __getattr__(name: str) -> object:
    """Import a public name from its file when it is first asked for."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
