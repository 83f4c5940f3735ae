"""The games of a study: paired by design, and each can be played again by itself."""

from __future__ import annotations

import json
import math
from collections import namedtuple

import numpy as np
import pytest

import covey
from covey.studies import AsVisible, Study, load_study, run_study, turn_rate_gains
from covey.studies.analysis.summary import summary
from covey.studies.design.case import Case
from covey.studies.running.games import play_start
from covey.studies.running.tables import encoded
from studies.small_studies import small_study


def test_a_row_of_the_table_is_a_game_that_can_be_played_again(tmp_path):
    table = run_study(small_study(), tmp_path, workers=1).games
    assert table["game"].to_pylist() == list(range(200))
    for row in table.slice(37, 8).to_pylist():
        team = range(row["team_size"])
        game = covey.simulate(
            covey.Team(
                [(row[f"evader_{i}_x"], row[f"evader_{i}_y"]) for i in team],
                [row[f"evader_{i}_heading"] for i in team],
                row["speed"],
                row["turn_rate"],
            ),
            covey.PursuerDisk(radius=row["disk_radius"], speed=row["pursuer_speed"]),
            sensing=row["sensing"],
            update_time=row["update_time"],
            seed=row["seed"],
        )
        assert row["survival_time"] == game.survival_time
        assert [row[f"captured_{i}"] for i in team] == game.capture_sequence.tolist()
        assert [row[f"capture_time_{i}"] for i in team] == game.capture_times.tolist()
        assert row["guarantee"] == pytest.approx(game.guarantee, rel=1e-12)


def test_turning_radii_stand_in_the_table_as_they_were_given(tmp_path):
    radii = {"turn_radius": [0.2, 0.4], "team_size": 2, "starts": 2, "sensing": "hidden"}
    result = run_study(small_study(**radii), tmp_path, workers=1)
    assert result.games["turn_radius"].to_pylist() == [0.2, 0.4] * 2
    assert result.games["turn_rate"].null_count == 4
    assert [line.settings for line in summary(result)] == [
        {"turn_radius": 0.2},
        {"turn_radius": 0.4},
    ]
    with pytest.raises(covey.InputError, match="expected turn rates to compare, got"):
        turn_rate_gains(load_study(tmp_path))


def test_results_from_before_there_were_radii_can_be_read(tmp_path):
    wanted = run_study(small_study(starts=2, team_size=2), tmp_path, workers=1).games
    (part,) = (tmp_path / "games").glob("*.parquet")
    part.write_bytes(encoded(wanted.drop_columns("turn_radius")))
    manifest = tmp_path / "manifest.json"
    told = json.loads(manifest.read_text())
    del told["study"]["grid"]["turn_radius"]
    manifest.write_text(json.dumps(told))
    assert len(summary(load_study(tmp_path))) == 2


def test_every_start_is_played_in_every_case():
    study = small_study(turn_rate=[0.5, 2.0], team_size=3)
    games = list(play_start(study, 11))
    assert [game.number for game in games] == [44, 45, 46, 47]
    for game in games[1:]:
        assert (game.origin.positions == games[0].origin.positions).all()
        assert game.origin.seed == games[0].origin.seed


@pytest.mark.parametrize("sensing", [["visible", "hidden"], ["hidden", "visible"], "hidden"])
def test_hidden_as_visible_captures_in_the_order_of_the_visible_game(sensing):
    study = small_study(pursuer=AsVisible(), sensing=sensing, team_size=3)
    for number in range(5):
        games = {study.cases[g.case].sensing: g.outcome for g in play_start(study, number)}
        start = study.start(number, 3)
        seen = covey.simulate(
            covey.Team(start.positions, start.headings),
            covey.PursuerDisk(),
            sensing="visible",
            update_time=0.1,
            seed=start.seed,
        )
        for outcome in games.values():
            assert (outcome.capture_sequence == seen.capture_sequence).all()
        if "visible" in games:
            assert games["visible"].survival_time == seen.survival_time


def test_hidden_as_visible_meets_its_own_visible_game_wherever_the_fields_of_a_case_stand(
    monkeypatch,
):
    def survival_times():
        study = small_study(pursuer=AsVisible(), speed=[0.25, 0.6], team_size=3)
        games = (game for number in range(8) for game in play_start(study, number))
        return [game.outcome.survival_time for game in games]

    expected = survival_times()
    cases = small_study(pursuer=AsVisible(), speed=[0.25, 0.6], team_size=3).cases
    moved = namedtuple("Moved", [*(f for f in Case._fields if f != "speed"), "speed"])
    monkeypatch.setattr(Study, "cases", tuple(moved(**case._asdict()) for case in cases))
    assert survival_times() == expected


def test_nobody_dies_before_the_guarantee():
    study = small_study(pursuer=["committed", "as-visible"], team_size=3)
    for number in range(20):
        for game in play_start(study, number):
            assert game.outcome.survival_time >= game.outcome.guarantee * (1 - 1e-9)


def test_the_objective_is_a_dimension_of_the_grid(tmp_path):
    objectives = ["last-capture", "total-survival", "expected-survival"]
    study = small_study(objective=objectives, team_size=3, sensing="hidden", starts=8)
    result = run_study(study, tmp_path, workers=1)
    games = result.to_pandas()
    assert sorted(set(games["objective"])) == [
        'expected-survival (measure = "total")',
        "last-capture",
        "total-survival",
    ]
    last, summed = (games[games["objective"] == name] for name in objectives[:2])
    totals = games[[f"capture_time_{k}" for k in range(3)]].sum(axis=1)
    assert (last["value"] == last["survival_time"]).all()
    assert (last["planned_value"] == last["guarantee"]).all()
    assert summed["value"].to_numpy() == pytest.approx(totals[summed.index].to_numpy(), rel=1e-14)
    assert (summed["value"] >= summed["planned_value"] * (1.0 - 1e-9)).all()
    lines = summary(result)
    assert [line.settings["objective"] for line in lines][:2] == objectives[:2]
    assert lines[1].value.value == pytest.approx(summed["value"].mean(), rel=1e-14)


def test_strategies_of_ones_own_play_by_the_same_rules():
    def straight(situation):
        return np.zeros(len(situation.evaders))

    class Nearest:
        def start(self, seed):
            def decide(situation):
                gaps = situation.team.positions - situation.disk.center
                return covey.Chase((situation.evaders[int(np.hypot(*gaps.T).argmin())],))

            return decide

    study = small_study(evaders=[straight, "open-loop"], pursuer=Nearest(), team_size=2)
    for number in range(3):
        times = [game.outcome.survival_time for game in play_start(study, number)]
        assert all(math.isfinite(time) for time in times)
    assert study.describe()["grid"]["evaders"][0] == {"name": "straight"}


def test_trajectories_are_kept_on_request(tmp_path):
    result = run_study(small_study(trajectories=True, starts=4), tmp_path, workers=1)
    (moments,) = result.trajectories()
    game = result.games.slice(6, 1).to_pylist()[0]
    rows = moments.filter(moments["game"].to_numpy() == 6).to_pydict()
    assert rows["time"][0] == 0.0
    assert rows["time"][-1] == pytest.approx(game["survival_time"], rel=1e-6)
    assert rows["evader_1_x"][0] == pytest.approx(game["evader_1_x"], rel=1e-6)
