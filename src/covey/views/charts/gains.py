"""Chart: mean survival time over the turning rate, by team size (Fig. 5 of the paper)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from covey.model import InputError
from covey.model.display import multiple_of_pi
from covey.views.kit import style
from covey.views.kit.layout import panels_in_a_row, width_of_panels
from covey.views.kit.page import fit, sheet_of
from covey.views.kit.style import styled

_SIDE = 2.0
_HEADROOM = 0.22


class Curve(NamedTuple):
    """Ratios (K,) of means at K turning rates, and half widths (K,) of confidence intervals."""

    ratios: Sequence[float]
    errors: Sequence[float]


@styled
def draw_gains(
    turn_rates: Sequence[float],
    panels: Mapping[str, Mapping[int, Curve]],
    *,
    beside: Mapping[str, Mapping[int, Curve]] | None = None,
    ax: Axes | None = None,
    title: str | None = None,
    width: float | None = None,
) -> Figure:
    """Draw how the mean survival time grows with the turning rate.

    Parameters
    ----------
    turn_rates
        (K,) in ascending order, radians per time.
    panels
        For each panel, by its title, the curve of each team size.
    beside
        For some panels, by their titles, curves of teams that answer captures: broken lines.
    ax
        Axes in whose place the panels are drawn. Default: a new figure.
    title
        Above all panels. Default: none.
    width
        Of a new figure, inches. Default: two columns of a paper, 7, for two panels.

    Returns
    -------
    matplotlib.figure.Figure
        Panels side by side.

    Raises
    ------
    InputError
        If a curve lacks a ratio or an error for a turning rate.

    Examples
    --------
    >>> from covey import views
    >>> curve = views.Curve(ratios=[1.0, 1.02], errors=[0.0, 0.01])
    >>> figure = views.draw_gains([0.79, 1.57], {"hidden pursuer": {2: curve}})
    """
    answering = beside or {}
    every = [*panels.values(), *answering.values()]
    for curves in every:
        for size, curve in curves.items():
            if not len(curve.ratios) == len(curve.errors) == len(turn_rates):
                raise InputError(
                    f"panels: expected {len(turn_rates)} ratios and errors for {size} evaders"
                )
    top = _top(every)
    sheet = sheet_of(ax, title, width or width_of_panels(len(panels)))
    page, all_axes = panels_in_a_row(list(panels), _SIDE, _HEADROOM, sheet)
    for axes, (panel, curves) in zip(all_axes, panels.items(), strict=True):
        _draw_panel(axes, turn_rates, curves)
        if panel in answering:
            _draw_broken_lines(axes, turn_rates, answering[panel], list(curves))
        axes.set_ylim(2.0 - top if top < 1.02 else 0.99, top)
    first = all_axes[0]
    handles, labels = first.get_legend_handles_labels()
    first.legend(handles[::-1], labels[::-1], loc="upper left")  # in the order of the curves
    first.set_ylabel(f"mean survival time, relative to {_rate_text(turn_rates[0])}")
    return page.figure


def _top(panels: Iterable[Mapping[int, Curve]]) -> float:
    ends = [
        float(np.max(np.add(curve.ratios, np.nan_to_num(curve.errors))))  # nan: of a single start
        for curves in panels
        for curve in curves.values()
    ]
    return 1.0 + 1.06 * (max(ends) - 1.0)


def _draw_panel(axes: Axes, turn_rates: Sequence[float], curves: Mapping[int, Curve]) -> None:
    for k, (size, curve) in enumerate(curves.items()):
        axes.errorbar(
            turn_rates,
            curve.ratios,
            yerr=curve.errors,
            markersize=0.8 * style.EVADER_SIZE,
            linewidth=style.EVADER_LINE,
            capsize=2.0,
            capthick=1.3 * style.THIN_LINE,
            gid=f"team of {size}",
            **style.team_size_series(k, size, len(curves)),
        )
    axes.axhline(1.0, **style.GUIDE)
    axes.set_xticks(turn_rates, [_rate_text(rate) for rate in turn_rates])
    axes.set_xlim(left=0.0)
    name = axes.set_xlabel(r"maximum turning rate $\omega$ (rad/s)", labelpad=2)
    fit(name, axes.get_window_extent().width / axes.figure.dpi)
    axes.spines[["top", "right"]].set_visible(False)


def _draw_broken_lines(
    axes: Axes, turn_rates: Sequence[float], curves: Mapping[int, Curve], sizes: list[int]
) -> None:
    """Draw curves in the colours that their team sizes have in the panel."""
    for size, curve in curves.items():
        series = style.team_size_series(sizes.index(size), size, len(sizes))
        series["label"] = "_no entry"
        axes.errorbar(
            turn_rates,
            curve.ratios,
            yerr=curve.errors,
            markersize=0.6 * style.EVADER_SIZE,
            linewidth=style.EVADER_LINE,
            linestyle=(0.0, (3.0, 1.5)),
            gid=f"answering team of {size}",
            **series,
        )
    axes.set_title(
        "broken: answering captures",
        loc="right",
        pad=3,
        fontsize=style.SMALL_TEXT_SIZE,
    )


def _rate_text(rate: float) -> str:
    """Write simple multiples of π, and angles that were given in degrees, as such."""
    found = multiple_of_pi(rate)
    if found is not None:
        factor, divisor = found
        times = r"\pi" if factor == 1 else rf"{factor}\pi"
        return f"${times}$" if divisor == 1 else f"${times}/{divisor}$"
    degrees = round(math.degrees(rate), 6)
    return f"{degrees:g}°" if math.radians(degrees) == rate else f"{rate:.3g}"
