"""Every study has a picture, of the kind that suits what varies in it."""

from __future__ import annotations

import numpy as np
import pytest

import covey
from covey.views import draw_ratios, draw_study
from covey.views.kit.style import TEAM_MARKS


def drawn(tmp_path, **fields):
    study = covey.Study(**({"starts": 4, "update_time": 0.2, "team_size": 2} | fields))
    return draw_study(covey.run_study(study, tmp_path / "results", workers=1))


def test_two_sensings_are_drawn_as_ratios(tmp_path):
    (axes,) = drawn(tmp_path).axes
    assert axes.get_xlabel() == "survival time, hidden / visible"


def test_turn_rates_are_drawn_as_gains(tmp_path):
    (axes,) = drawn(tmp_path, turn_rate=["10 deg", "pi/2"], sensing="hidden").axes
    assert axes.get_xlabel().startswith("maximum turning rate")
    assert [text.get_text() for text in axes.get_xticklabels()] == ["10°", r"$\pi/2$"]


def test_several_teams_are_drawn_as_ratios_of_means(tmp_path):
    figure = drawn(tmp_path, evaders=["open-loop", "straight-away"], sensing="hidden")
    (axes,) = figure.axes
    assert [text.get_text() for text in axes.get_yticklabels()] == ["straight-away"]


def test_any_other_study_is_drawn_as_its_means(tmp_path):
    fields = {"disk_radius": [0.0, 0.1], "speed": [0.2, 0.25], "sensing": "hidden"}
    (axes,) = drawn(tmp_path, **fields).axes
    assert [text.get_text() for text in axes.get_yticklabels()] == [
        f"speed {speed}, disk radius {radius}" for speed in (0.2, 0.25) for radius in (0, 0.1)
    ]
    result = covey.load_study(tmp_path / "results")
    (marks,) = [line for line in axes.lines if line.get_marker() in TEAM_MARKS]
    means = [result.moments.average(case).value for case in range(4)]
    assert marks.get_xdata() == pytest.approx(means)


def test_many_team_sizes_are_drawn_as_curves(tmp_path):
    rates, sizes = ["pi/4", "pi"], [5, 1, 3, 2, 4]
    fields = {"turn_rate": rates, "team_size": sizes, "evaders": "open-loop", "sensing": "hidden"}
    (axes,) = drawn(tmp_path, starts=2, update_time=1.0, **fields).axes
    assert [text.get_text() for text in axes.get_legend().get_texts()] == [
        "turn rate π/4",
        "turn rate π",
    ]
    result = covey.load_study(tmp_path / "results")
    curve = next(each for each in axes.containers if each.get_label() == "turn rate π")
    points = dict(zip(*curve.lines[0].get_data(), strict=True))
    cases = {case["team_size"]: k for k, case in enumerate(result.cases) if case["turn_rate"] > 1.0}
    assert points == {size: result.moments.average(k).value for size, k in cases.items()}
    assert list(points) == sorted(sizes)


def test_units_stand_beside_the_numbers_of_a_study(tmp_path):
    fields = {"turn_radius": [0.1, 0.2], "capture_radius": 0.01, "sensing": "hidden", "unit": "km"}
    figure = drawn(tmp_path, **fields)
    (axes,) = figure.axes
    labels = [text.get_text() for text in axes.get_yticklabels()]
    assert labels == ["turn radius 0.1 km", "turn radius 0.2 km"]
    assert "mean survival time (s), ± 95 % confidence" in [text.get_text() for text in figure.texts]


def test_one_start_has_a_picture_without_an_interval(tmp_path):
    (axes,) = drawn(tmp_path, starts=1, sensing="hidden").axes
    low, high = axes.get_xlim()
    assert np.isfinite([low, high]).all()


def test_nothing_is_drawn_of_games_that_did_not_end(tmp_path, monkeypatch):
    result = covey.run_study(
        covey.Study(starts=1, update_time=0.2, team_size=2), tmp_path / "results", workers=1
    )
    monkeypatch.setattr(result, "parts", lambda: iter(()))
    with pytest.raises(covey.InputError, match="expected games that came to their end, got none"):
        draw_study(result)


@pytest.mark.parametrize("taller", [0.985, 0.955, 1.0])
def test_the_count_of_fig_4_stands_above_all_bars_beneath_it(taller):
    ratios = np.array([1.0] * 20 + [taller] * 60)
    figure = draw_ratios({3: ratios}, beside={3: [0.975] * 9 + [1.0]})
    (axes,) = figure.axes
    figure.canvas.draw()
    (text,) = [text for text in axes.texts if "0.005" in text.get_text()]
    assert text.get_text().endswith(f": {80 if taller == 1.0 else 20}")
    box = text.get_window_extent()
    bars = [bar.get_window_extent() for bar in axes.patches if hasattr(bar, "get_height")]
    assert not any(box.overlaps(bar) for bar in bars)
    assert axes.get_window_extent().y1 >= box.y1
