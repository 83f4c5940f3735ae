"""How everything looks: colours, lines, fonts. Nothing else in this room names a colour.

The colours are Okabe and Ito's: colour-blind readers tell them apart. A figure printed in grey
loses nothing: evaders are round and their lines thick, the pursuer is a triangle and its lines
thin, planned lines are broken. Sizes are for one column of a paper (3.5 in) and scale up to a
slide.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any, ParamSpec, TypeVar

from matplotlib import style

COLUMN_WIDTH = 3.5
"""Inches: one column of a paper."""

INK = "#1a1a1a"
FAINT = "#8c8c8c"
PAPER = "#ffffff"
EVADER = "#0072b2"
CAPTURED = "#d55e00"
PURSUER = INK
DISK = "#dadada"
DISK_EDGE = "#9a9a9a"

# Shades of one blue, from few evaders to many; each has its own mark, for print in grey.
TEAM_SHADES = ("#9ecae1", "#5aa2cf", "#2171b5", "#08306b")
TEAM_MARKS = ("o", "s", "^", "D")

EVADER_LINE = 1.5
PURSUER_LINE = 0.7
THIN_LINE = 0.6
PLANNED_DASHES = (0, (3.0, 1.6))
PURSUER_DOTS = (0, (1.0, 1.8))
GUIDE: dict[str, Any] = {"color": FAINT, "linewidth": THIN_LINE, "linestyle": PURSUER_DOTS}
"""A thin dotted line that helps to read a chart."""

EVADER_SIZE = 5.0
DOT_SIZE = 3.0
CAPTURED_SIZE = 6.2
PURSUER_SIZE = 10.0
CENTER_SIZE = 8.0

TEXT_SIZE = 8.0
SMALL_TEXT_SIZE = 7.0

# From the back to the front.
(
    DISK_LAYER,
    PLANNED_LAYER,
    FLOWN_LAYER,
    PURSUIT_LAYER,
    EVADER_LAYER,
    PURSUER_LAYER,
    CAPTURED_LAYER,
    TEXT_LAYER,
) = range(2, 10)

RC: dict[str, Any] = {
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.labelsize": TEXT_SIZE,
    "axes.linewidth": THIN_LINE,
    "axes.titlesize": TEXT_SIZE,
    "font.family": "DejaVu Sans",  # it comes with matplotlib, so every machine draws the same
    "font.size": TEXT_SIZE,
    "legend.fontsize": SMALL_TEXT_SIZE,
    "legend.frameon": False,
    "lines.dash_capstyle": "butt",
    "mathtext.fontset": "dejavusans",
    "pdf.fonttype": 42,  # TrueType: what journals ask for, and text that can be searched
    "savefig.dpi": 300,
    "svg.hashsalt": "covey",  # the same picture gives the same file
    "text.color": INK,
    "xtick.color": INK,
    "xtick.labelsize": SMALL_TEXT_SIZE,
    "xtick.major.size": 2.5,
    "xtick.major.width": THIN_LINE,
    "ytick.color": INK,
    "ytick.labelsize": SMALL_TEXT_SIZE,
    "ytick.major.size": 2.5,
    "ytick.major.width": THIN_LINE,
}


def team_size_series(k: int, size: int, count: int) -> dict[str, Any]:
    """Return how the k-th of `count` team sizes is drawn, for `Axes.errorbar`.

    The last one is the darkest. Few of them have shades that are far apart.
    """
    darkest = len(TEAM_SHADES) - 1
    apart = max(darkest // max(count - 1, 1), 1)
    shade = (darkest - apart * (count - 1 - k)) % len(TEAM_SHADES)
    return {
        "color": TEAM_SHADES[shade],
        "marker": TEAM_MARKS[shade],
        "markeredgewidth": 0.0,
        "elinewidth": 1.3 * THIN_LINE,
        "label": f"$N = {size}$",
    }


Arguments = ParamSpec("Arguments")
Result = TypeVar("Result")


def styled(function: Callable[Arguments, Result]) -> Callable[Arguments, Result]:
    """Run a function under this style, whatever style its caller has set."""

    @wraps(function)
    def under_style(*args: Arguments.args, **kwargs: Arguments.kwargs) -> Result:
        with style.context(RC, after_reset=True):
            return function(*args, **kwargs)

    return under_style
