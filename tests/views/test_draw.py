"""`covey.draw`: one function for whatever has a picture, on new axes or on given ones."""

from __future__ import annotations

import inspect
from functools import cache

import matplotlib.image
import numpy as np
import pytest
from matplotlib.figure import Figure

import covey
from covey import views
from covey.bounds.bracket import LowerEnd
from covey.scenarios.examples import TEMPLATE
from covey.views.kit.close_up import fitting_scale
from random_games import random_game
from views.drawn_artists import boxes, labels, points
from views.flown_games import simulated

TEAM, DISK = random_game(np.random.default_rng(2), 3, radius=0.1)
DRAWN = {
    "scenario": lambda: covey.load_scenario("unequal"),
    "plan": lambda: covey.plan(TEAM, DISK, starts=2),
    "contingent plan": lambda: covey.plan_contingent(TEAM, DISK),
    "bracket": lambda: covey.bracket(TEAM, DISK, starts=2),
    "game": simulated,
}
made = cache(lambda name: DRAWN[name]())


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """The results of a small study."""
    study = covey.Study(starts=3, update_time=0.2, team_size=2, sensing="hidden")
    return covey.run_study(study, tmp_path_factory.mktemp("study") / "results", workers=1)


@pytest.fixture
def drawn(request, results):
    """One of those that have a picture."""
    return results if request.param == "study" else made(request.param)


EACH = pytest.mark.parametrize("drawn", [*DRAWN, "study"], indirect=True)


@EACH
def test_a_picture_shows_itself_in_a_notebook(drawn, tmp_path):
    figure = covey.draw(drawn)
    (tmp_path / "picture.png").write_bytes(figure._repr_png_())
    assert matplotlib.image.imread(tmp_path / "picture.png").std() > 0.01


@EACH
def test_given_axes_are_drawn_on(drawn):
    figure = Figure(figsize=(12, 6))
    left, right = figure.subplots(1, 2)
    before = left.get_position().bounds
    assert covey.draw(drawn, ax=right) is figure
    figure.canvas.draw()
    assert figure.axes == [left, right]
    assert left.get_position().bounds == before
    assert not left.has_data()
    place = right.get_position()
    for axes in right.child_axes or [right]:
        inside = axes.get_position()
        assert place.x0 - 1e-9 <= inside.x0 < inside.x1 <= place.x1 + 1e-9
        assert place.y0 - 1e-9 <= inside.y0 < inside.y1 <= place.y1 + 1e-9
    assert right.has_data() or any(axes.has_data() for axes in right.child_axes)


@EACH
def test_a_title_and_a_width_of_ones_own(drawn):
    figure = covey.draw(drawn, title="My title", width=5.5)
    assert figure.get_figwidth() == pytest.approx(5.5)
    above = [axes.get_title(loc="left") for axes in figure.axes]
    assert "My title" in above + [text.get_text() for text in figure.texts]


TITLES = [None, "A rather long title that a person has given to a picture", "of two\nlines"]


@EACH
@pytest.mark.parametrize("title", TITLES)
def test_a_title_stays_within_a_narrow_picture(drawn, title):
    figure = covey.draw(drawn, title=title, width=2.0)
    figure.canvas.draw()
    names = [axes.title for axes in figure.axes] + [axes._left_title for axes in figure.axes]
    above = [text for text in [*names, *figure.texts] if text.get_text()]
    assert above
    for text in above:
        box = text.get_window_extent()
        assert figure.bbox.x0 <= box.x0 < box.x1 <= figure.bbox.x1 + 1.0
        assert box.y1 <= figure.bbox.y1


CURVES = {"hidden": {2: views.Curve([1.0, 1.1], [0.0, 0.0])}}
CHARTS = {
    "ratios": lambda width: views.draw_ratios({3: [1.0, 0.99]}, width=width),
    "gains": lambda width: views.draw_gains([1.0, 2.0], CURVES, width=width),
    "means": lambda width: views.draw_comparison(
        [views.Ratio("hidden", "", "open-loop", 3, 0.9, 0.1)], "mean " * 12, width=width
    ),
}


@pytest.mark.parametrize("chart", CHARTS)
def test_the_name_of_an_axis_stays_within_a_narrow_chart(chart):
    figure = CHARTS[chart](2.0)
    figure.canvas.draw()
    below = [*(axes.xaxis.label for axes in figure.axes), *figure.texts]
    boxes_below = [text.get_window_extent() for text in below if text.get_text()]
    assert boxes_below
    assert all(0.0 <= box.x0 < box.x1 <= figure.bbox.x1 for box in boxes_below)


def test_a_title_on_given_axes_is_no_wider_than_they_are():
    figure = Figure(figsize=(6, 2))
    axes = figure.subplots(1, 3)[1]
    covey.draw(made("plan"), ax=axes, title=TITLES[1])
    figure.canvas.draw()
    assert axes._left_title.get_window_extent().width <= axes.get_window_extent().width


def test_a_scenario_shows_where_the_game_starts():
    scenario = made("scenario")
    (axes,) = covey.draw(scenario).axes
    assert axes.get_title(loc="left") == "4 evaders, hidden pursuer"
    team = scenario.team
    assert points(axes, "evaders").tolist() == team.positions.tolist()
    ahead = points(axes, "headings").reshape(4, 2, 2)
    assert ahead[:, 0].tolist() == team.positions.tolist()
    x, y = (ahead[:, 1] - ahead[:, 0]).T
    assert np.arctan2(y, x) == pytest.approx(team.headings)
    assert np.hypot(x, y) / np.hypot(x, y).max() == pytest.approx(team.speeds / team.speeds.max())
    assert [text.get_text() for text in labels(axes)] == ["0", "1", "2", "3"]
    assert points(axes, "disk center").tolist() == [scenario.disk.center.tolist()]


@pytest.mark.parametrize("name", [name for name in views.__all__ if name.startswith("draw")])
def test_every_drawing_takes_axes_a_title_and_a_width(name):
    assert {"ax", "title", "width"} <= inspect.signature(getattr(views, name)).parameters.keys()


@pytest.mark.parametrize("depth", [0, 1])
def test_a_bracket_shows_the_plan_that_guarantees_most_and_names_both_bounds(depth):
    scenario = covey.load_scenario(TEMPLATE)  # whose team gains much by answers
    bracket = covey.bracket(scenario.team, scenario.disk, starts=2, depth=depth)
    figure = covey.draw(bracket)
    above = [axes.get_title(loc="left") for axes in figure.axes]
    above += [text.get_text() for text in figure.texts]
    both = f"sure of {bracket.lower:.0f} s; nobody of more than {bracket.upper:.0f} s"
    assert both in above
    assert bracket.lower_by is (LowerEnd.CONTINGENT if depth else LowerEnd.OPEN_LOOP)
    assert len(figure.axes) == (1 + len(scenario.team) if depth else 1)


@pytest.mark.parametrize("other", [None, 3, TEAM, "fig3"])
def test_what_has_no_picture_is_told(other):
    with pytest.raises(covey.InputError, match=r"^x: expected a scenario, .* a study, got "):
        covey.draw(other)


@pytest.mark.parametrize("width", [0.5, "wide"])
def test_a_width_is_in_inches(width):
    with pytest.raises(covey.InputError, match="width: "):
        covey.draw(made("plan"), width=width)


def test_a_start_that_is_small_beside_the_game_has_a_close_up():
    team = covey.Team([(9.0, 3.0), (-2.0, 10.0), (-8.0, -5.0)], 0.0, 0.5)
    disk = covey.PursuerDisk(radius=5.0)
    for x in (covey.plan(team, disk), covey.simulate(team, disk, update_time=0.5)):
        (axes,) = covey.draw(x).axes
        (inset,) = axes.child_axes
        assert [text.get_text() for text in labels(inset)] == ["0", "1", "2"]
        low, high = inset.get_xlim()
        assert low < -8.0 < 9.0 < high < axes.get_xlim()[1]
        name = "evaders" if isinstance(x, covey.Plan) else "dots"
        assert points(inset, name) == pytest.approx(team.positions)


def test_labels_keep_clear_of_the_close_up():
    positions = np.random.default_rng(3).uniform(-6.0, 6.0, (8, 2))
    team = covey.Team(positions, 0.0, 0.5)
    (axes,) = covey.draw(covey.simulate(team, covey.PursuerDisk(), update_time=0.5)).axes
    (inset,) = axes.child_axes
    assert len(labels(axes)) == 8
    for box in boxes(axes):
        assert not box.overlaps(inset.get_window_extent())


def test_markers_of_a_close_team_are_smaller():
    figure = Figure()
    axes = figure.add_subplot()
    axes.set(xlim=(0.0, 1.0), ylim=(0.0, 1.0))
    apart = np.array([[0.1, 0.1], [0.9, 0.9]])
    assert fitting_scale(axes, apart) == fitting_scale(axes, apart[:1]) == 1.0
    near = np.array([[0.1, 0.1], [0.1, 0.12], [0.9, 0.9]])
    nearer = np.array([[0.1, 0.1], [0.1, 0.1001], [0.9, 0.9]])
    assert 1.0 > fitting_scale(axes, near) > fitting_scale(axes, nearer) > 0.5


def test_a_start_as_wide_as_the_game_has_none():
    (axes,) = covey.draw(simulated()).axes
    assert axes.child_axes == []
