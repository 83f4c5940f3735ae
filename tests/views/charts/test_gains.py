"""The curves of Fig. 5."""

from __future__ import annotations

import numpy as np
import pytest

from covey import InputError
from covey.views import Curve, draw_gains


def test_the_curves_are_the_ratios():
    curve = Curve([1.0, 1.1, 1.15], [0.0, 0.01, 0.02])
    figure = draw_gains([np.pi / 4, np.pi, 2 * np.pi], {"visible": {2: curve, 5: curve}})
    (axes,) = figure.axes
    assert [text.get_text() for text in axes.get_xticklabels()] == [r"$\pi/4$", r"$\pi$", r"$2\pi$"]
    assert axes.lines[0].get_ydata() == pytest.approx(curve.ratios)
    assert axes.get_ylim()[1] > 1.17


def test_a_curve_without_all_turning_rates_is_refused():
    with pytest.raises(InputError, match="expected 2 ratios and errors for 5 evaders"):
        draw_gains([1.0, 2.0], {"visible": {5: Curve([1.0], [0.0])}})
