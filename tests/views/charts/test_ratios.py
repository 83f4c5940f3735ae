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


def test_a_histogram_of_nothing_is_refused():
    with pytest.raises(InputError, match="at least one ratio"):
        draw_ratios({3: []})
