"""What the commands print and write."""

from __future__ import annotations

import json
import math
from pathlib import Path

import matplotlib.image
import pytest

import covey
from covey import views
from covey.cli import main
from covey.scenarios import example_path, load_scenario

THREE = """
[pursuer]
strategy = { name = "fixed-sequence", sequence = [2, 0, 1] }
[team.random]
count = 3
[game]
update_time = 0.1
seed = 4
"""


@pytest.fixture
def scenario(tmp_path, monkeypatch):
    """A small scenario in an empty working folder."""
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "three.toml"
    path.write_text(THREE)
    return load_scenario(path)


@pytest.fixture
def record(scenario):
    game = scenario.simulate()
    covey.save_game(game, "game.parquet")
    return game


def printed(capsys, *arguments):
    """What a command that succeeds prints to the standard output."""
    assert main(arguments) == 0
    return capsys.readouterr().out


def test_a_contingent_plan_is_printed_with_its_answers(scenario, capsys):
    tree = scenario.plan_contingent()
    text = printed(capsys, "plan", "three.toml", "--contingent")
    for each in (tree.survival_time, tree.with_delays.survival_time, scenario.bracket().upper):
        assert f"{each:.6g}" in text
    for i in tree.evaders:
        for heading in tree.after(i).goal_headings.tolist():
            assert f"{math.degrees(heading):+.1f}" in text
    told = json.loads(printed(capsys, "plan", "three.toml", "--contingent", "--json"))
    assert told["survival_time"] == tree.survival_time
    assert told["after"]["0"]["after"]["2"]["turns"] == tree.after(0).after(2).turns.tolist()
    shallow = json.loads(
        printed(capsys, "plan", "three.toml", "--contingent", "--depth", "1", "--json")
    )
    assert shallow["depth"] == 1
    assert "after" not in shallow["after"]["1"]


def test_what_a_contingent_plan_is_not_for_is_said(scenario, tmp_path, capsys):
    assert main(["plan", "three.toml", "--depth", "1"]) == 2
    assert "--depth: expected --contingent" in capsys.readouterr().err
    (tmp_path / "sum.toml").write_text(THREE + 'objective = "total-survival"\n')
    assert main(["plan", "sum.toml", "--contingent"]) == 2
    assert "about the last capture, got the objective total-survival" in " ".join(
        capsys.readouterr().err.split()
    )
    assert main(["plan", "three.toml", "--contingent", "--time-limit", "1"]) == 2
    assert "--time-limit: expected without --contingent" in capsys.readouterr().err


def test_a_plan_within_a_time_limit_stands_alone(scenario, capsys):
    plan, text = scenario.plan(), printed(capsys, "plan", "three.toml", "--time-limit", "60")
    assert f"guaranteed survival time  {plan.survival_time:.6g}" in text
    assert "no team could be sure" not in text
    assert main(["plan", "three.toml", "--time-limit", "-1"]) == 2
    assert "time_limit: expected a finite number >= 0, got -1" in capsys.readouterr().err


def test_plan_prints_guarantee_headings_sequences_and_how_the_search_ended(scenario, capsys):
    plan, text = scenario.plan(), printed(capsys, "plan", "three.toml")
    upper = scenario.bracket().upper
    assert f"survives at least {plan.survival_time:.6g}; " in text
    assert f"no team could be sure of more than {upper:.6g}\n" in text
    assert f"guaranteed survival time  {plan.survival_time:.6g}" in text
    assert " ".join(map(str, plan.critical_sequences[0])) in text
    assert f"{plan.goal_headings[1]:+.4f}" in text
    assert f"{math.degrees(plan.goal_headings[1]):+.1f}" in text
    assert str(plan.status) in " ".join(text.split())


def test_plan_prints_json_to_the_last_digit(scenario, capsys):
    plan, told = scenario.plan(), json.loads(printed(capsys, "plan", "three.toml", "--json"))
    assert told["survival_time"] == plan.survival_time
    assert told["upper_bound"] == scenario.bracket().upper
    assert sorted(told["announced_sequence"]) == [0, 1, 2]
    assert told["goal_headings"] == plan.goal_headings.tolist()
    assert told["turns"] == plan.turns.tolist()
    assert told["critical_sequences"] == [list(each) for each in plan.critical_sequences]
    assert told["status"] == plan.status


def test_other_objectives_are_told(scenario, tmp_path, capsys):
    summed = tmp_path / "sum.toml"
    summed.write_text(THREE + 'objective = "total-survival"\n')
    plan = load_scenario(summed).plan()
    out = printed(capsys, "plan", "sum.toml")
    assert f"guaranteed sum of survival times  {plan.value:.6g}" in out
    assert "no team could be sure" not in out
    told = json.loads(printed(capsys, "plan", "sum.toml", "--json"))
    assert (told["value"], told["objective"]) == (plan.value, {"name": "total-survival"})
    assert "upper_bound" not in told
    assert "sum of survival times" in printed(capsys, "simulate", "sum.toml")
    assert "least sum of survival times" in printed(capsys, "worst-case", "sum.toml")


def test_worst_case_prints_time_scope_and_captures(scenario, capsys):
    worst, text = scenario.worst_case(), printed(capsys, "worst-case", "three.toml")
    assert f"least survival time  {worst.survival_time:.6g}" in text
    assert str(worst.scope) in " ".join(text.split())
    rows = [line.split()[:2] for line in text.splitlines() if line.strip()[:1] in list("123")]
    assert rows == [[str(k), str(i)] for k, i in enumerate(worst.sequence, start=1)]


def test_worst_case_prints_json_and_takes_delays(scenario, capsys):
    worst = scenario.worst_case([0.0, 0.5])
    told = json.loads(printed(capsys, "worst-case", "three.toml", "--json", "--delays", "0", "0.5"))
    assert told["survival_time"] == worst.survival_time
    assert told["sequence"] == list(worst.sequence)
    assert told["scope"] == str(worst.scope)


def test_simulate_prints_guarantee_survival_time_and_captures(record, capsys):
    text = printed(capsys, "simulate", "three.toml")
    assert f"guaranteed survival time  {record.guarantee:.6g}" in text
    assert f"survival time             {record.survival_time:.6g}" in text
    rows = [line.split()[:3] for line in text.splitlines() if line.strip()[:1] in list("123")]
    times = [f"{time:.5f}" for time in record.capture_times]
    assert rows == [["1", "2", times[0]], ["2", "0", times[1]], ["3", "1", times[2]]]


def test_simulate_prints_json_to_the_last_digit(record, capsys):
    told = json.loads(printed(capsys, "simulate", "three.toml", "--json"))
    assert told["survival_time"] == record.survival_time
    assert told["guarantee"] == record.guarantee
    assert [each["evader"] for each in told["captures"]] == [2, 0, 1]
    assert [each["time"] for each in told["captures"]] == record.capture_times.tolist()
    assert told["captures"][0]["place"] == record.evader_positions[-1, 2].tolist()
    assert told["strategies"]["pursuer"] == {"name": "fixed-sequence", "sequence": [2, 0, 1]}


def test_json_has_null_for_infinity(scenario, tmp_path, capsys):
    text = THREE.replace("seed", "time_limit = 0.2\nseed")
    text = text.replace("fixed-sequence", "committed").replace("sequence = [2, 0, 1]", "margin=inf")
    (tmp_path / "short.toml").write_text(text)
    told = json.loads(
        printed(capsys, "simulate", "short.toml", "--json"),
        parse_constant=lambda name: pytest.fail(f"{name} is no JSON"),
    )
    assert told["survival_time"] is None
    assert told["strategies"]["pursuer"]["margin"] is None
    assert told["captures"] == []


def test_a_game_that_is_stopped_says_so(scenario, tmp_path, capsys):
    (tmp_path / "short.toml").write_text(THREE.replace("seed", "time_limit = 0.2\nseed"))
    text = " ".join(printed(capsys, "simulate", "short.toml").split())
    assert f"survival time more than 0.2: {covey.GameStatus.TIME_LIMIT}" in text


def test_simulate_saves_the_record_where_asked(record, capsys):
    assert main(["simulate", "three.toml", "--output", "new.parquet"]) == 0
    assert capsys.readouterr().err.endswith("saved new.parquet\n")
    assert covey.load_game("new.parquet").survival_time == record.survival_time


def test_the_seed_replaces_that_of_the_file(scenario, capsys):
    with_seed = load_scenario("three.toml", seed=9)
    told = json.loads(printed(capsys, "plan", "three.toml", "--json", "--seed", "9"))
    assert told["seed"] == 9
    assert told["survival_time"] == with_seed.plan().survival_time
    assert told["survival_time"] != scenario.plan().survival_time


def test_an_example_is_found_by_its_name(scenario, capsys):
    by_name = printed(capsys, "plan", "unequal", "--json")
    assert by_name == printed(capsys, "plan", str(example_path("unequal")), "--json")


def test_a_file_comes_before_an_example_of_its_name(scenario, tmp_path, capsys):
    (tmp_path / "unequal").write_text(THREE)
    of_file = printed(capsys, "plan", "unequal", "--json")
    assert of_file == printed(capsys, "plan", "three.toml", "--json")


@pytest.mark.parametrize(
    "arguments",
    [
        ["game.parquet", "-o", "picture.png"],
        ["game.parquet", "-o", "./picture.png", "--view", "game"],
        ["three.toml", "-o", "picture.PNG", "--view", "plan"],
        ["three.toml", "-o", "picture.png", "--view", "tree", "--size", "5"],
        ["game.parquet", "-o", "picture.png", "--times", "0", "0.5", "--title", "Two moments"],
    ],
)
def test_draw_saves_a_picture(record, arguments, capsys):
    assert main(["draw", *arguments]) == 0
    assert capsys.readouterr().err.endswith(f"saved {Path(arguments[2])}\n")
    assert matplotlib.image.imread(arguments[2], format="png").std() > 0.01


def test_a_drawn_tree_answers_as_many_captures_as_was_asked_for(scenario, monkeypatch):
    drawn, draw_contingent = [], views.draw_contingent

    def noted(tree):
        drawn.append(tree.depth)
        return draw_contingent(tree)

    monkeypatch.setattr(views, "draw_contingent", noted, raising=False)
    for depth in (["--depth", "1"], []):
        arguments = ["draw", "three.toml", "-o", "picture.png", "--view", "tree", *depth]
        assert main(arguments) == 0
    assert drawn == [1, 2]


def few_frames(monkeypatch, animate=views.animate):
    def quick(game, **look):
        return animate(game, seconds=0.2, **look)

    monkeypatch.setattr(views, "animate", quick, raising=False)


def test_draw_saves_a_film(record, tmp_path, monkeypatch):
    few_frames(monkeypatch)
    assert main(["draw", "game.parquet", "-o", "film.gif"]) == 0
    assert (tmp_path / "film.gif").read_bytes().startswith(b"GIF89a")


def test_a_game_that_was_played_is_not_lost_when_its_picture_is(
    scenario, tmp_path, monkeypatch, capsys
):
    def full(figure, path):
        raise OSError(28, "No space left on device", str(path))

    monkeypatch.setattr(views, "save", full, raising=False)
    arguments = ["draw", "three.toml", "-o", "picture.png", "--record", "game.parquet"]
    assert main(arguments) == 2
    said = capsys.readouterr().err.splitlines()
    assert [line for line in said if "compiling" not in line] == [  # kernels may be, at any time
        "saved game.parquet",
        "covey: picture.png: No space left on device",
    ]
    assert covey.load_game("game.parquet").capture_sequence.tolist() == [2, 0, 1]


def test_results_are_printed_before_the_record_is_saved(scenario, monkeypatch, capsys):
    def full(game, path):
        raise OSError(28, "No space left on device", str(path))

    monkeypatch.setattr(covey, "save_game", full)
    assert main(["simulate", "three.toml", "-o", "game.parquet"]) == 2
    output = capsys.readouterr()
    assert "guaranteed survival time" in output.out
    assert output.err.endswith("covey: game.parquet: No space left on device\n")
