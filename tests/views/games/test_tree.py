"""The picture of a contingent plan: a map for now, and a map for each first capture."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.transforms import Bbox

import covey
from covey import views
from covey.scenarios.examples import TEMPLATE
from random_games import random_game
from views import drawn_artists


@pytest.fixture(scope="module")
def tree():
    return covey.plan_contingent(*random_game(np.random.default_rng(2), 3, radius=0.1))


def test_there_is_a_map_for_now_and_one_for_each_first_capture(tree):
    figure = views.draw_contingent(tree)
    assert len(figure.axes) == 4
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    assert titles[0].startswith("now: survives ")
    assert [title.split(":")[0] for title in titles[1:]] == ["after 0", "after 1", "after 2"]


def test_a_map_shows_who_lives_where_and_who_was_captured(tree):
    now, *after = views.draw_contingent(tree).axes
    assert drawn_artists.points(now, "evaders") == pytest.approx(tree.team.positions)
    for i, axes in enumerate(after):
        rest = tree.after(i)
        assert drawn_artists.points(axes, "evaders") == pytest.approx(rest.team.positions)
        captured = drawn_artists.points(axes, "captured evaders")
        assert captured == pytest.approx(rest.disk.center[np.newaxis])


def test_the_captures_are_those_of_the_worst_sequence(tree):
    now, *_ = views.draw_contingent(tree).axes
    captures = drawn_artists.points(now, "predicted captures")
    first, second, _ = tree.critical_sequences[0]
    assert captures[0] == pytest.approx(tree.after(first).disk.center)
    assert captures[1] == pytest.approx(tree.after(first).after(second).disk.center)


def test_a_plan_for_one_evader_is_one_map():
    game = random_game(np.random.default_rng(1), 1)
    assert len(views.draw_contingent(covey.plan_contingent(*game)).axes) == 1


@pytest.mark.parametrize("width", [2.5, 5.0, 9.0])
def test_names_and_numbers_do_not_touch_in_axes_of_any_size(width):
    scenario = covey.load_scenario(TEMPLATE)
    figure = Figure(figsize=(width, width))
    covey.draw(scenario.plan_contingent(), ax=figure.add_axes((0.0, 0.0, 1.0, 1.0)))
    maps = figure.axes[0].child_axes
    assert len(maps) == 5
    titles = [axes._left_title.get_window_extent() for axes in maps]  # there is no public way
    numbers = []
    for axes in maps:
        below = drawn_artists.numbers_below(axes)
        numbers += [Bbox.union(below)] if below else []
    for boxes in (titles, numbers):
        assert not any(one.overlaps(other) for one, other in combinations(boxes, 2))


def test_a_narrow_picture_has_fewer_columns():
    tree = covey.load_scenario(TEMPLATE).plan_contingent()

    def columns(width):
        axes = views.draw_contingent(tree, width=width).axes
        return len({round(each.get_position().x0, 3) for each in axes})

    assert [columns(width) for width in (7.0, 3.5, 2.0)] == [3, 2, 1]
