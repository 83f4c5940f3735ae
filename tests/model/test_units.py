"""The unit of a team's lengths, and what tables and pictures write beside numbers."""

from __future__ import annotations

import re

import numpy as np
import pytest

import covey
from covey.model.units import counted, titled, with_unit

POSITIONS = [(900.0, 300.0), (-200.0, 1000.0)]


def team(**changes):
    return covey.Team(POSITIONS, 0.0, speeds=20.0, turn_radii=60.0, unit="m", **changes)


def test_a_team_tells_its_speeds_and_turn_rates_with_units():
    assert repr(team()) == "Team(2 evaders, speeds=20 m/s, turn_rates=0.333333 rad/s)"
    table = team()._repr_html_()
    for column in ("x (m)", "y (m)", "heading (rad)", "speed (m/s)", "turn rate (rad/s)"):
        assert f"<th>{column}</th>" in table


def disk(**changes):
    return covey.PursuerDisk(speed=45.0, unit="m", **changes)


def test_a_disk_tells_its_numbers_with_units():
    told = "PursuerDisk(center=(0, 0) m, radius=690 m, speed=45 m/s, capture_radius=0 m)"
    seen = covey.PursuerDisk.last_seen((0, 0), within=150, ago=12, speed=45, unit="m")
    assert repr(seen) == told
    for column in ("center (m)", "radius (m)", "speed (m/s)", "capture radius (m)"):
        assert f"<th>{column}</th>" in seen._repr_html_()
    assert (seen.moved(np.ones(2)).unit, seen == disk(radius=690.0)) == ("m", True)


MADE = {
    "plan": lambda: covey.plan(team(), disk(), starts=2),
    "sum": lambda: covey.plan(team(), disk(), starts=2, objective="total-survival"),
    "contingent": lambda: covey.plan_contingent(team(), disk()),
    "delayed": lambda: covey.plan_contingent(team(), disk()).with_delays,
    "guarantee": lambda: covey.guaranteed_survival(team(), disk(), [0.0, 0.0]),
    "bracket": lambda: covey.bracket(team(), disk(), starts=2),
    "sequence": lambda: covey.plan_for_sequence(team(), disk(), [1, 0]),
    "worst": lambda: covey.worst_case(team(), disk(), evaders="hold-course", update_time=1.0),
    "game": lambda: covey.simulate(team(), disk(), evaders="hold-course", update_time=1.0),
}
TIMES = r"\b(survival_time|value|guarantee|time|lower|upper|resolution)="


@pytest.mark.parametrize("name", MADE)
def test_every_time_of_a_line_has_its_unit_and_every_column_too(name):
    made = MADE[name]()
    line, table = repr(made), made._repr_html_()
    assert re.search(TIMES, line)
    assert re.findall(rf"{TIMES}[^ ,)]+(?! s[,)])[,)]", line) == []
    heads = re.findall("<th>(.*?)</th>", table)
    timed = {"time", "delay", "lower", "upper", "captured", "survival time", "resolution"}
    assert not timed & {*heads}
    assert any(head.endswith((" (s)", " (rad)")) for head in heads)


def test_a_strategy_of_ones_own_is_told_the_units():
    told = []

    def straight(situation):
        told.append(situation)
        return [0.0] * len(situation.evaders)

    covey.simulate(team(), disk(), evaders=straight, update_time=1.0)
    assert {(each.team.unit, each.disk.unit, each.pursuer.unit) for each in told} == {("m",) * 3}
    assert repr(told[0]).startswith("Situation(time=0 s, ")


def test_team_and_disk_are_in_one_unit():
    with pytest.raises(covey.InputError, match=r"unit: expected the same .* got 'm' and 'km'"):
        covey.plan(team(), covey.PursuerDisk(speed=45.0, unit="km"))
    assert covey.plan(team(), covey.PursuerDisk(speed=45.0), starts=1).survival_time > 0.0


def test_without_a_unit_none_is_written():
    nameless = covey.Team(POSITIONS, 0.0)
    assert nameless.unit == ""
    assert not any(nameless.units)
    assert "<th>x</th>" in nameless._repr_html_()


def test_a_unit_stays_with_the_team_its_parts_plans_and_games():
    assert team().take(np.array([1])).unit == "m"
    assert team().moved(np.array([1.0, 0.0])).unit == "m"
    assert covey.plan(team(), disk(), starts=2).team == team()
    tree = covey.plan_contingent(team(), disk())
    assert tree.team.unit == tree.after(0).team.unit == tree.disk.unit == "m"
    game = covey.simulate(team(), disk(), evaders="hold-course", update_time=1.0)
    assert game.team.unit == game.disk.unit == "m"
    assert f"survival_time={game.survival_time:.6g} s" in repr(game)
    assert "<th>time (s)</th>" in game._repr_html_()


def test_a_unit_comes_back_with_a_record(tmp_path):
    game = covey.simulate(team(), disk(), evaders="hold-course", update_time=1.0)
    covey.save_game(game, tmp_path / "game.parquet")
    assert covey.load_game(tmp_path / "game.parquet") == game


def test_a_unit_changes_no_number():
    nameless = covey.Team(POSITIONS, 0.0, speeds=20.0, turn_radii=60.0)
    with_one, without = (covey.plan(each, disk(), starts=2) for each in (team(), nameless))
    assert with_one.turns.tolist() == without.turns.tolist()
    assert team() != nameless


@pytest.mark.parametrize("unit", [1.0, None, "two words", "a\nb", "thirteen-long"])
def test_what_is_no_short_word_is_no_unit(unit):
    with pytest.raises(covey.InputError, match=r'unit: expected a short word such as "m", got '):
        covey.Team(POSITIONS, 0.0, unit=unit)
    with pytest.raises(covey.InputError, match=r'unit: expected a short word such as "m", got '):
        covey.PursuerDisk(unit=unit)


def test_numbers_and_titles_with_and_without_units():
    assert with_unit("398", "s") == "398 s"
    assert with_unit("398", "") == "398"
    assert titled("time", "s") == "time (s)"
    assert titled("time", "") == "time"


def test_one_is_singular():
    assert [counted(n, "start") for n in (0, 1, 2)] == ["0 starts", "1 start", "2 starts"]
