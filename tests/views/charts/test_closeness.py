"""The picture of how close strategies come to the value."""

from __future__ import annotations

from covey.views.charts.closeness import Closeness, draw_closeness
from views.drawn_artists import points


def test_a_mark_at_the_mean_for_every_strategy_and_speed():
    row = {"0.25/0.25": Closeness(0.99, 0.95), "0.5/0.5": Closeness(0.9, 0.8)}
    better = {"0.25/0.25": Closeness(1.0, 0.99), "0.5/0.5": Closeness(0.97, 0.9)}
    figure = draw_closeness(
        {
            "random pairs": {"open-loop": row, "other": better},
            "close pairs": {"open-loop": row, "other": better},
        }
    )
    assert [axes.get_title(loc="left") for axes in figure.axes] == [
        "(a)  random pairs",
        "(b)  close pairs",
    ]
    for axes in figure.axes:
        assert points(axes, "open-loop")[:, 1].tolist() == [0.99, 0.9]
        assert points(axes, "other")[:, 1].tolist() == [1.0, 0.97]
        assert axes.get_ylim()[0] < 0.8
        assert axes.get_ylim()[1] > 1.0
        assert [label.get_text() for label in axes.get_xticklabels()] == list(row)
