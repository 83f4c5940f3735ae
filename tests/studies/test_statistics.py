"""Averages over parts, and how sure they are."""

from __future__ import annotations

import numpy as np
import pytest

from covey.studies import run_study, summary
from covey.studies.statistics import moments_of
from studies.small_studies import small_study


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    study = small_study(turn_rate=[0.5, 3.0])
    return run_study(study, tmp_path_factory.mktemp("moments"), workers=1)


@pytest.fixture(scope="module")
def times(result):
    return result.games["survival_time"].to_numpy().reshape(50, 8)


def test_parts_give_what_all_games_give_at_once(result, times):
    moments = result.moments
    assert moments.starts == moments.ended == 50
    assert moments.mean == pytest.approx(times.mean(axis=0), rel=1e-14)
    assert moments.scatter / 49 == pytest.approx(np.cov(times.T), rel=1e-12)
    average = moments.average(3)
    assert average.value == pytest.approx(times[:, 3].mean())
    assert average.error == pytest.approx(1.96 * times[:, 3].std(ddof=1) / np.sqrt(50), rel=1e-4)


def test_the_interval_of_a_ratio_is_that_of_the_bootstrap(result, times):
    ratio = result.moments.ratio(6, 4)
    draws = np.random.default_rng(0).integers(0, 50, (4000, 50))
    spread = np.std(times[draws, 6].mean(axis=1) / times[draws, 4].mean(axis=1))
    assert ratio.value == pytest.approx(times[:, 6].mean() / times[:, 4].mean(), rel=1e-12)
    assert ratio.error == pytest.approx(1.96 * spread, rel=0.1)
    unpaired = np.hypot(*(result.moments.average(k).error / times[:, k].mean() for k in (4, 6)))
    assert ratio.error < 0.5 * unpaired * ratio.value


def test_a_case_compared_with_itself_is_sure(result):
    assert result.moments.ratio(2, 2) == (1.0, 0.0)


def test_a_game_that_never_ended_counts_for_its_start(result):
    tables = list(result.parts())
    stopped = tables[0]["survival_time"].to_numpy().copy()
    stopped[3] = np.inf
    place = tables[0].column_names.index("survival_time")
    tables[0] = tables[0].set_column(place, "survival_time", [stopped])
    moments = moments_of(tables, 8)
    assert (moments.starts, moments.ended) == (50, 49)
    assert moments.stopped.tolist() == [0, 0, 0, 1, 0, 0, 0, 0]
    assert np.isfinite(moments.mean).all()


def test_nothing_played_is_nothing_known():
    assert np.isnan(moments_of([], 2).ratio(0, 1).value)


def test_the_summary_tells_what_differs(result):
    lines = summary(result)
    assert [line.settings for line in lines[:2]] == [
        {"team_size": 2, "turn_rate": 0.5, "sensing": "visible"},
        {"team_size": 2, "turn_rate": 0.5, "sensing": "hidden"},
    ]
    assert [line.relative.value == 1.0 for line in lines][::4] == [True, True]
    assert all(line.survival.value >= line.guarantee for line in lines)
