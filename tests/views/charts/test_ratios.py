"""The histograms of Fig. 4."""

from __future__ import annotations

import numpy as np
import pytest

from covey import InputError
from covey.views import draw_ratios


def test_the_histogram_counts_every_start_and_has_a_bin_at_one():
    five = np.array([0.83, 0.897, 0.9949, 0.9951, 1.0, 1.0049, 1.07])
    figure = draw_ratios({3: [1.0, 1.0], 5: five})
    panel = figure.axes[1]
    assert sum(bar.get_height() for bar in panel.patches) == len(five)
    (middle,) = [bar for bar in panel.patches if bar.get_gid() == "bar at one"]
    assert middle.get_height() == 3
    assert middle.get_x() + 0.5 * middle.get_width() == pytest.approx(1.0)
    low, high = panel.get_xlim()
    assert low < 0.83
    assert high > 1.07


def test_the_line_of_the_assured_pursuer_has_the_height_of_its_shares():
    figure = draw_ratios({3: [1.0, 1.0, 0.95, 0.95]}, beside={3: [1.0, 0.85]})
    (line,) = [each for each in figure.axes[0].patches if each.get_gid() == "assured"]
    values, edges, _ = line.get_data()
    assert values.sum() == pytest.approx(4.0)
    middles = 0.5 * (edges[1:] + edges[:-1])
    assert middles[values > 0.0] == pytest.approx([0.85, 1.0])
    assert figure.axes[0].get_xlim()[0] < 0.85


def test_a_histogram_of_nothing_is_refused():
    with pytest.raises(InputError, match="at least one ratio"):
        draw_ratios({3: []})


def test_starts_are_counted_in_whole_numbers():
    (axes,) = draw_ratios({2: [1.0, 0.95]}).axes
    assert all(float(tick).is_integer() for tick in axes.get_yticks())
