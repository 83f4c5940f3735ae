"""Pictures and animations of plans and games. They read records, and never solve.

Importing this room is cheap: matplotlib is loaded with the first picture.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from covey.views.animation import animate
    from covey.views.capture import draw_capture
    from covey.views.closeness import draw_closeness
    from covey.views.comparison import draw_comparison
    from covey.views.control import draw_control
    from covey.views.curves import draw_gains
    from covey.views.game import draw_game
    from covey.views.histogram import draw_ratios
    from covey.views.plan import draw_plan
    from covey.views.saving import save
    from covey.views.snapshots import draw_snapshots

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
    "animate": "animation",
    "draw_capture": "capture",
    "draw_closeness": "closeness",
    "draw_comparison": "comparison",
    "draw_control": "control",
    "draw_gains": "curves",
    "draw_game": "game",
    "draw_plan": "plan",
    "draw_ratios": "histogram",
    "draw_snapshots": "snapshots",
    "save": "saving",
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
