"""The curves of Fig. 5."""

from __future__ import annotations

import numpy as np
import pytest

from covey import InputError
from covey.views import Curve, draw_gains
from covey.views.kit.style import TEAM_SHADES, team_size_series


def test_the_curves_are_the_ratios():
    curve = Curve([1.0, 1.1, 1.15], [0.0, 0.01, 0.02])
    figure = draw_gains([np.pi / 4, np.pi, 2 * np.pi], {"visible": {2: curve, 5: curve}})
    (axes,) = figure.axes
    assert [text.get_text() for text in axes.get_xticklabels()] == [r"$\pi/4$", r"$\pi$", r"$2\pi$"]
    assert axes.lines[0].get_ydata() == pytest.approx(curve.ratios)
    assert axes.get_ylim()[1] > 1.17


def test_teams_that_answer_captures_are_broken_lines_in_the_colours_of_their_sizes():
    curve, higher = Curve([1.0, 1.1], [0.0, 0.01]), Curve([1.05, 1.3], [0.02, 0.02])
    panels = {"visible": {2: curve, 5: curve}, "hidden": {2: curve, 5: curve}}
    figure = draw_gains([1.0, 2.0], panels, beside={"hidden": {5: higher}})
    visible, hidden = figure.axes
    drawn = {line.get_gid(): line for line in hidden.lines}
    broken = drawn["answering team of 5"]
    assert broken.is_dashed()
    assert broken.get_ydata() == pytest.approx(higher.ratios)
    assert broken.get_color() == drawn["team of 5"].get_color()
    assert hidden.get_title(loc="right") == "broken: answering captures"
    assert visible.get_title(loc="right") == ""
    assert hidden.get_ylim()[1] > 1.3
    with pytest.raises(InputError, match="expected 2 ratios and errors for 5 evaders"):
        draw_gains([1.0, 2.0], panels, beside={"hidden": {5: Curve([1.0], [0.0])}})


def test_several_panels_have_letters_and_a_single_curve_is_dark():
    curve = Curve([1.0, 1.1], [0.0, 0.01])
    names = [
        [axes.get_title(loc="left") for axes in draw_gains([1.0, 2.0], panels).axes]
        for panels in ({"hidden": {2: curve}}, {"hidden": {2: curve}, "visible": {2: curve}})
    ]
    assert names == [["hidden"], ["(a)  hidden", "(b)  visible"]]
    (axes,) = draw_gains([1.0, 2.0], {"hidden": {2: curve}}).axes
    assert axes.lines[0].get_color() == TEAM_SHADES[-1]


@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_every_team_size_has_its_own_shade_and_mark(count):
    series = [team_size_series(k, 2 + k, count) for k in range(count)]
    assert len({each["color"] for each in series}) == len({each["marker"] for each in series})
    assert [each["color"] for each in series] == sorted(
        (each["color"] for each in series), key=TEAM_SHADES.index
    )
    assert series[-1]["color"] == TEAM_SHADES[-1]


def test_a_curve_without_all_turning_rates_is_refused():
    with pytest.raises(InputError, match="expected 2 ratios and errors for 5 evaders"):
        draw_gains([1.0, 2.0], {"visible": {5: Curve([1.0], [0.0])}})


def test_curves_of_a_single_start_have_no_intervals():
    curve = Curve([1.0, 1.1], [0.0, np.nan])
    (axes,) = draw_gains([1.0, 2.0], {"hidden": {2: curve}}).axes
    assert axes.get_ylim()[1] > 1.1
