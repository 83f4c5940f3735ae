"""The scores of a tournament, from made-up times and from games; its picture and its table."""

from __future__ import annotations

import io
import math
from types import SimpleNamespace

import numpy as np
import pyarrow as pa
import pytest
from rich.console import Console

import covey
from covey import views
from covey.cli import main
from covey.cli.show.comparison import print_comparison
from covey.model import InputError
from covey.scenarios.strategies import EVADERS, PURSUERS
from covey.studies import Study, example_path, read_study, run_study
from covey.studies.analysis.paired_ratios import Comparison, PairedRatio
from covey.studies.analysis.tournament import is_tournament, tournament
from covey.studies.running.tables import labels
from covey.studies.statistics import UNKNOWN, moments_of
from covey.views.charts.comparison import Ratio
from studies.small_studies import files


def made_up(times, **sides):
    """The result of a study whose survival times (starts, sizes, sensing, evaders, pursuers)."""
    study = Study(starts=len(times), **sides).describe()
    flat = pa.table({"survival_time": np.ravel(times)})
    return SimpleNamespace(study=study, parts=lambda: [flat])


def duel(own, first, **sides):
    """The scores of the second team, by size."""
    times = np.stack([first, own], axis=-1)[:, :, None, :, None]
    sides = {"sensing": "hidden", "evaders": ["iterative-open-loop", "hold-course"], **sides}
    found = tournament(made_up(times, **sides)).ratios
    return {score.team_size: score for score in found if score.row == "hold-course"}


def test_a_team_that_always_lives_half_as_long_scores_a_half_for_sure():
    first = np.random.default_rng(0).uniform(1.0, 5.0, (20, 2))
    found = duel(0.5 * first, first, team_size=[2, 3])
    for score in found.values():
        assert score.relative == pytest.approx((0.5, 0.0), abs=1e-12)
        assert score.starts == 20


def test_one_size_is_the_studys_ratio_of_means():
    generator = np.random.default_rng(1)
    first = generator.uniform(1.0, 5.0, (30, 1))
    own = first * generator.uniform(0.5, 1.2, (30, 1))
    table = pa.table({"survival_time": np.ravel(np.hstack([first, own])), "guarantee": np.ones(60)})
    expected = moments_of([table], 2).ratio(1, 0)
    found = duel(own, first, team_size=3)
    assert found[3].relative == pytest.approx(expected, rel=1e-12)
    assert found[None].relative == pytest.approx(expected, rel=1e-12)


def test_the_mean_over_sizes_knows_that_they_share_their_starts():
    """Were the sizes independent, the interval would be narrower by the root of two."""
    generator = np.random.default_rng(2)
    first = np.repeat(generator.uniform(1.0, 2.0, (40, 1)), 2, axis=1)
    own = first * generator.uniform(0.5, 1.2, (40, 1))
    found = duel(own, first, team_size=[2, 3])
    assert found[None].relative == pytest.approx(found[2].relative)
    assert found[2].relative == pytest.approx(found[3].relative)


def test_the_interval_holds_the_truth_about_as_often_as_it_says():
    generator, held = np.random.default_rng(3), 0
    for _ in range(300):
        first = generator.uniform(1.0, 2.0, (50, 2))
        own = first * generator.uniform(0.6, 1.0, (50, 2))
        value, error = duel(own, first, team_size=[2, 3])[None].relative
        held += abs(value - 0.8) <= error
    assert 0.90 <= held / 300 <= 0.99


def test_pairs_with_a_stopped_game_are_left_out():
    first = np.array([[1.0, 1.0], [2.0, math.inf], [3.0, 3.0]])
    own = np.array([[0.5, 0.5], [1.0, 1.0], [1.5, 1.5]])
    found = duel(own, first, team_size=[2, 3])
    assert [found[size].starts for size in (2, 3, None)] == [3, 2, 2]
    assert {score.played for score in found.values()} == {3}
    assert found[None].relative == pytest.approx((0.5, 0.0), abs=1e-12)
    nobody = duel(own, np.full((3, 2), math.inf), team_size=[2, 3])
    assert math.isnan(nobody[None].relative.value)


def test_a_cell_of_a_table_without_games_has_no_number():
    ratio = PairedRatio("hidden", "patient", "open-loop", None, UNKNOWN, 1, 2)
    screen = Console(file=io.StringIO(), width=80)
    print_comparison(screen, Comparison("team", "contingent", "mean", [ratio]))
    assert "nan" not in screen.file.getvalue()
    assert "–*" in screen.file.getvalue()


def test_names_alone_where_they_tell_strategies_apart():
    slow = {"name": "open-loop", "starts": 1}
    assert labels([slow, {"name": "hold-course"}]) == ["open-loop", "hold-course"]
    slower = {**slow, "starts": 2}
    assert labels([slow, slower]) == ["open-loop (starts = 1)", "open-loop (starts = 2)"]


def test_the_tournament_that_comes_with_covey_has_all_players():
    study = read_study(example_path("tournament"))
    assert is_tournament(study.describe())
    assert {team.describe()["name"] for team in study.evaders} == set(EVADERS)
    assert {pursuer.describe()["name"] for pursuer in study.pursuer} == set(PURSUERS)
    assert study.evaders[0] == covey.IterativeOpenLoop()


SMALL = """
starts = 2
[grid]
team_size = [1, 3]
disk_radius = 0.1
capture_radius = 0.02
update_time = 0.4
evaders = [
    "iterative-open-loop", "open-loop", "constant-heading", "known-sequence", "largest-distance",
    "smallest-danger", "straight-away", "hold-course",
]
pursuer = ["flying", "best-sequence", "assured", "nearest-first", "random-sequence"]
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A small tournament, played by two workers."""
    place = tmp_path_factory.mktemp("tournament")
    (place / "small.toml").write_text(SMALL)
    run_study(place / "small.toml", place / "results", workers=2)
    return place


def test_everybody_meets_everybody_and_every_game_ends(folder):
    result = covey.load_study(folder / "results")
    times = result.games["survival_time"].to_numpy()
    assert len(times) == 2 * 2 * 2 * 8 * 5
    assert np.isfinite(times).all()
    safe = [team.startswith("it") for team in result.games["evaders"].to_pylist()]
    spare = times - result.games["guarantee"].to_numpy()
    assert spare[safe].min() > -1e-9


def test_one_worker_writes_what_two_do(folder, tmp_path):
    run_study(folder / "small.toml", tmp_path, workers=1)
    assert files(tmp_path) == files(folder / "results")


def test_its_table_is_printed_and_its_picture_drawn(folder, tmp_path, capsys):
    arguments = ["--output", str(folder / "results"), "--workers", "1"]
    assert main(["study", str(folder / "small.toml"), *arguments]) == 0
    told = capsys.readouterr().out
    assert "visible pursuer" in told
    assert "hold-course" in told
    assert "mean over teams of 1, 3" in " ".join(told.split())
    picture = tmp_path / "small.png"
    assert main(["draw", str(folder / "results"), "--output", str(picture)]) == 0
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_what_is_no_study_has_no_picture(tmp_path, capsys):
    run_study(Study(starts=2, update_time=0.2, team_size=2), tmp_path / "plain", workers=1)
    picture = str(tmp_path / "plain.png")
    assert main(["draw", str(tmp_path), "--output", picture]) == 2
    assert "expected the results of a study" in capsys.readouterr().err
    assert main(["draw", str(tmp_path / "plain"), "--output", picture, "--view", "game"]) == 2
    assert "--view, --depth, --record, --times and --seed are for games" in capsys.readouterr().err


def test_the_picture_shows_every_ratio_once():
    ratios = [
        Ratio(row, column, team, size, 0.9 + 0.01 * size, 0.02)
        for row in ("seen", "unseen")
        for column in ("a", "b", "c")
        for team in ("x", "y")
        for size in (2, 3)
    ]
    figure = views.draw_comparison(ratios, "z")
    assert len(figure.axes) == 6
    for axes in figure.axes:
        drawn = [list(line.get_xdata()) for line in axes.lines if len(line.get_xdata()) == 2]
        assert [0.92, 0.92] in drawn
        assert [0.93, 0.93] in drawn
        low, high = axes.get_xlim()
        assert low < 0.9 < 1.0 < high
    with pytest.raises(InputError, match="at least one"):
        views.draw_comparison([], "z")
