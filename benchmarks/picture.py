"""Time against the size of the team, a curve for each method."""

from __future__ import annotations

from covey import views
from covey.views import style
from covey.views.sheet import add_axes, new_figure

_TASKS = {"warm": "warm replan", "cold": "plan from one start"}
_LOOKS = {
    "covey, compiled": ("#0072b2", "o", "-"),
    "covey.plan": ("#56b4e9", "s", "-"),
    "SLSQP, exact gradients": ("#d55e00", "^", "--"),
    "SLSQP, finite differences": ("#e69f00", "v", "--"),
    "CasADi and IPOPT": ("#1a1a1a", "D", ":"),
}
_WIDTH, _HEIGHT = 2.95, 2.5


@style.styled
def draw(rows):
    """Return the figure, two columns of a paper wide: medians as curves, up to the 99th percentile
    as bars.
    """
    left, bottom, gap = 0.55, 0.4, 0.2
    figure = new_figure(2.0 * style.COLUMN_WIDTH, bottom + _HEIGHT + 0.25)
    first = None
    for k, (task, title) in enumerate(_TASKS.items()):
        axes = add_axes(figure, left + k * (_WIDTH + gap), bottom, _WIDTH, _HEIGHT)
        for method, look in _LOOKS.items():
            _curve(axes, [row for row in rows if (row.task, row.method) == (task, method)], look)
        axes.set_yscale("log")
        axes.set_title(f"({'ab'[k]})  {title}", loc="left", pad=3)
        axes.set_xlabel("evaders $N$", labelpad=2)
        axes.set_xticks(sorted({row.size for row in rows}))
        axes.spines[["top", "right"]].set_visible(False)
        axes.grid(axis="y", color="#dadada", linewidth=style.THIN_LINE)
        axes.set_axisbelow(True)
        if first is None:
            first = axes
            axes.set_ylabel("time, µs")
            axes.legend(loc="lower right")
        else:
            axes.sharey(first)
            axes.tick_params(labelleft=False)
    return figure


def _curve(axes, rows, look):
    color, mark, line = look
    if rows:
        medians = [row.median for row in rows]
        axes.errorbar(
            [row.size for row in rows],
            medians,
            yerr=[[0.0] * len(rows), [row.percentile_99 - row.median for row in rows]],
            color=color,
            marker=mark,
            linestyle=line,
            markersize=3.5,
            markeredgewidth=0.0,
            linewidth=1.2,
            elinewidth=style.THIN_LINE,
            label=rows[0].method,
        )


def save(rows, path):
    """Draw and save the figure."""
    views.save(draw(rows), path)
