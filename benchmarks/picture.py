"""Time against the size of the team, a curve for each method."""

from __future__ import annotations

from covey import views
from covey.views.kit import style
from covey.views.kit.page import add_axes, new_figure

_TASKS = {"warm": "warm replan", "cold": "plan from one start"}
_LOOKS = {
    "covey, compiled": ("#0072b2", "o", "-"),
    "covey.plan": ("#56b4e9", "s", "-"),
    "SLSQP, exact gradients": ("#d55e00", "^", "--"),
    "SLSQP, finite differences": ("#e69f00", "v", "--"),
    "CasADi and IPOPT": ("#1a1a1a", "D", ":"),
}
_ASIDE = {"o": 0.0, "s": 0.1, "^": -0.1, "v": -0.2, "D": 0.2}
_WIDTH, _HEIGHT = 3.0, 2.6


@style.styled
def draw(rows):
    """Return the figure, two columns of a paper wide."""
    left, bottom, gap = 0.55, 0.4, 0.3
    figure = new_figure(2.0 * style.COLUMN_WIDTH, bottom + _HEIGHT + 0.25)
    drawn = [row for row in rows if row.task in _TASKS]
    lowest, highest = min(r.median for r in drawn), max(r.percentile_99 for r in drawn)
    for k, (task, title) in enumerate(_TASKS.items()):
        axes = add_axes(figure, left + k * (_WIDTH + gap), bottom, _WIDTH, _HEIGHT)
        for method, look in _LOOKS.items():
            _curve(axes, [row for row in drawn if (row.task, row.method) == (task, method)], look)
        axes.set_yscale("log")
        axes.set_title(f"({'ab'[k]})  {title}", loc="left", pad=3)
        axes.set_xlabel("evaders $N$", labelpad=2)
        axes.set_xticks(sorted({row.size for row in drawn}))
        axes.tick_params(which="minor", left=False)
        axes.spines[["top", "right"]].set_visible(False)
        axes.grid(axis="y", color="#dadada", linewidth=style.THIN_LINE)
        axes.set_axisbelow(True)
        axes.set_ylim(0.5 * lowest, 2.0 * highest)
        if k == 0:
            axes.set_ylabel("time, µs")
            axes.legend(loc="lower right")
        else:
            axes.tick_params(labelleft=False)
    return figure


def _curve(axes, rows, look):
    """Medians as a curve; the bars, side by side, end at the 99th percentile."""
    color, mark, line = look
    if not rows:
        return
    sizes = [row.size + _ASIDE[mark] for row in rows]
    medians = [row.median for row in rows]
    axes.vlines(
        sizes, medians, [row.percentile_99 for row in rows], color=color, linewidth=style.THIN_LINE
    )
    axes.plot(
        sizes,
        medians,
        color=color,
        marker=mark,
        linestyle=line,
        markersize=3.5,
        markeredgewidth=0.0,
        linewidth=1.2,
        label=rows[0].method,
    )


def save(rows, path):
    """Draw and save the figure."""
    views.save(draw(rows), path)
