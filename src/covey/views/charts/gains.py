"""Survival over the turning rate, a curve for each team size (Fig. 5 of the paper)."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.model import InputError
from covey.views.kit import style
from covey.views.kit.layout import add_axes, new_figure
from covey.views.kit.style import styled

_SIDE = 2.0
_HEADROOM = 0.22


class Curve(NamedTuple):
    """Ratios (K,) of means at K turning rates, and the half widths (K,) of their intervals."""

    ratios: Sequence[float]
    errors: Sequence[float]


@styled
def draw_gains(turn_rates: Sequence[float], panels: Mapping[str, Mapping[int, Curve]]) -> Figure:
    """Draw how the mean survival time grows with the turning rate.

    Parameters
    ----------
    turn_rates
        (K,), radians per time, growing.
    panels
        For each panel, by its title, the curve of each team size.

    Returns
    -------
    matplotlib.figure.Figure
        Panels side by side, two columns of a paper wide if there are two.

    Raises
    ------
    InputError
        If a curve has not a ratio for every turning rate.
    """
    for curves in panels.values():
        for size, curve in curves.items():
            if not len(curve.ratios) == len(curve.errors) == len(turn_rates):
                raise InputError(
                    f"panels: expected {len(turn_rates)} ratios and errors for {size} evaders"
                )
    left, bottom, gap = 0.5, 0.4, 0.18
    width = (2.0 * style.COLUMN_WIDTH - left - 0.28 - gap) / 2.0
    figure = new_figure(left + len(panels) * (width + gap) + 0.1, bottom + _SIDE + _HEADROOM)
    top = _top(panels)
    for k, (title, curves) in enumerate(panels.items()):
        axes = add_axes(figure, left + k * (width + gap), bottom, width, _SIDE)
        _draw_panel(axes, turn_rates, curves)
        axes.set_ylim(2.0 - top if top < 1.02 else 0.99, top)
        axes.set_title(f"({'abcdef'[k]})  {title}", loc="left", pad=3)
        if k == 0:
            handles, labels = axes.get_legend_handles_labels()
            axes.legend(handles[::-1], labels[::-1], loc="upper left")  # as the curves lie
            axes.set_ylabel(f"mean survival time, relative to {_rate_text(turn_rates[0])}")
        else:
            axes.tick_params(labelleft=False)
    return figure


def _top(panels: Mapping[str, Mapping[int, Curve]]) -> float:
    ends = [
        float(np.max(np.add(curve.ratios, curve.errors)))
        for curves in panels.values()
        for curve in curves.values()
    ]
    return 1.0 + 1.06 * (max(ends) - 1.0)


def _draw_panel(axes: Axes, turn_rates: Sequence[float], curves: Mapping[int, Curve]) -> None:
    for k, (size, curve) in enumerate(curves.items()):
        color = style.TEAM_SHADES[k % len(style.TEAM_SHADES)]
        axes.errorbar(
            turn_rates,
            curve.ratios,
            yerr=curve.errors,
            color=color,
            marker=style.TEAM_MARKS[k % len(style.TEAM_MARKS)],
            markersize=0.8 * style.EVADER_SIZE,
            markeredgewidth=0.0,
            linewidth=style.EVADER_LINE,
            elinewidth=1.3 * style.THIN_LINE,
            capsize=2.0,
            capthick=1.3 * style.THIN_LINE,
            label=f"$N = {size}$",
            gid=f"team of {size}",
        )
    axes.axhline(1.0, color=style.FAINT, linewidth=style.THIN_LINE, linestyle=style.PURSUER_DOTS)
    axes.set_xticks(turn_rates, [_rate_text(rate) for rate in turn_rates])
    axes.set_xlim(left=0.0)
    axes.set_xlabel(r"maximum turning rate $\omega$ (rad/s)", labelpad=2)
    axes.spines[["top", "right"]].set_visible(False)


def _rate_text(rate: float) -> str:
    """Write simple multiples of π as such."""
    for divisor in (1, 2, 3, 4, 6, 8):
        times = rate * divisor / math.pi
        if abs(times - round(times)) < 1e-9 and 0 < round(times) < 10:
            factor = "" if round(times) == 1 else str(round(times))
            return rf"${factor}\pi$" if divisor == 1 else rf"${factor}\pi/{divisor}$"
    return f"{rate:.3g}"
