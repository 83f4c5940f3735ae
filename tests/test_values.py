"""Public values at a prompt and in a notebook: one line, a small table, equal by their numbers."""

from __future__ import annotations

import dataclasses
import pickle
from functools import partial

import numpy as np
import pytest

import covey
from covey.model.display import html_table
from covey.studies import StudyResult

POSITIONS = [(0.3, 0.1), (-0.2, 0.4), (0.1, -0.5)]


def team(**changes):
    return covey.Team(**{"positions": POSITIONS, "headings": [0.3, 2.0, -1.5], **changes})


disk = partial(covey.PursuerDisk, (0.0, 0.1), 0.05, 1.0, 0.01)

MADE = {
    "Team": team,
    "PursuerDisk": disk,
    "Plan": lambda: covey.plan(team(), disk(), starts=2),
    "Guarantee": lambda: covey.guaranteed_survival(team(), disk(), np.zeros(3)),
    "Bracket": lambda: covey.bracket(team(), disk(), starts=2),
    "ContingentPlan": lambda: covey.plan_contingent(team(), disk()),
    "DelayedGuarantee": lambda: covey.plan_contingent(team(), disk()).with_delays,
    "WorstCase": lambda: covey.worst_case(team(), disk(), update_time=0.1),
    "SequencePlan": lambda: covey.plan_for_sequence(team(), disk(), [0, 1, 2]),
    "Game": lambda: covey.simulate(team(), disk(), update_time=0.1),
    "Situation": lambda: covey.Situation(0.5, (0, 2, 3), team(), disk(), np.zeros(3)),
    "Scenario": lambda: covey.load_scenario("fig3"),
    "Study": lambda: covey.Study(turn_radius=[0.1, 0.2]),
}
ROWS = {
    "Team": 3,
    "PursuerDisk": 1,
    "Plan": 3,
    "ContingentPlan": 3,
    "DelayedGuarantee": 1,
    "WorstCase": 3,
    "Guarantee": 1,
    "Bracket": 1,
    "Game": 3,
    "Scenario": 9,
    "SequencePlan": 3,
    "Study": 17,
}


@pytest.mark.parametrize("name", MADE)
def test_a_value_is_one_line(name):
    text = repr(MADE[name]())
    assert text.startswith(f"{name}(")
    assert "\n" not in text
    assert len(text) < (200 if name not in ("Scenario", "Study") else 600)


def test_lines_tell_what_matters():
    assert repr(team()) == "Team(3 evaders, speeds=0.25, turn_rates=pi/2)"
    unequal = covey.Team(POSITIONS[:2], 0.0, [0.1, 0.2], [1.0, np.inf])
    assert repr(unequal) == "Team(2 evaders, speeds=0.1 to 0.2, turn_rates=1 to inf)"
    assert repr(covey.Team(POSITIONS[:1], 0.0)).startswith("Team(1 evader,")
    told = "PursuerDisk(center=(0, 0.1), radius=0.05, speed=1, capture_radius=0.01)"
    assert repr(disk()) == told
    plan = MADE["Plan"]()
    assert repr(plan).startswith(f"Plan(survival_time={plan.survival_time:.6g}, evaders=3, crit")
    assert repr(plan).endswith(f"status={plan.status.name})")


def test_a_plan_for_another_objective_tells_its_value():
    plan = covey.plan(team(), disk(), objective=covey.TotalSurvival(), starts=2)
    assert f"value={plan.value:.6g}" in repr(plan)


def test_the_results_of_a_study_tell_where_they_are(tmp_path):
    study = {"unit": "m", "grid": {"speed": [0.2, 0.25]}}
    result = StudyResult(tmp_path, {"games": 12, "study": study, "typed": {}})
    assert "<td>speed (m/s)</td><td>[0.2, 0.25]</td>" in result._repr_html_()
    assert repr(result) == f"StudyResult({str(tmp_path)!r}, 12 games)"


@pytest.mark.parametrize(("name", "rows"), ROWS.items())
def test_a_notebook_gets_a_small_table(name, rows):
    table = MADE[name]()._repr_html_()
    assert table.startswith("<table><caption>")
    assert table.count("<tr>") == 1 + rows
    heads, cells = table.count("<th>"), table.count("<td>")
    assert cells == heads * (table.count("<tr>") - 1)


def test_a_table_shows_the_first_rows_of_many_and_no_markup_of_its_cells():
    table = html_table("a < b", {"n": range(1000), "text": ["<b>"] * 1000})
    assert table.count("<tr>") == 1 + 20 + 1
    assert "<td>…</td>" in table
    assert "a &lt; b" in table
    assert "<b>" not in table


@pytest.mark.parametrize("name", [name for name in MADE if name != "Guarantee"])
def test_values_with_the_same_numbers_are_equal_and_have_equal_hashes(name):
    one, other = MADE[name](), MADE[name]()
    assert one is not other
    assert one == other
    assert name == "Game" or hash(one) == hash(other)  # a game holds mappings
    assert pickle.loads(pickle.dumps(one)) == one


@pytest.mark.parametrize(
    "change",
    [
        {"positions": [*POSITIONS[:2], (0.1, 0.5)]},
        {"positions": POSITIONS[:2], "headings": [0.3, 2.0]},
        {"headings": [0.3, 2.0, 1.5]},
        {"speeds": [0.25, 0.25, 0.2]},
        {"turn_rates": 1.0},
    ],
)
def test_teams_with_different_numbers_differ(change):
    assert team(**change) != team()


@pytest.mark.parametrize(
    "change", [{"center": (1.0, 0.0)}, {"radius": 1.0}, {"speed": 2.0}, {"capture_radius": 0.1}]
)
def test_disks_with_different_numbers_differ(change):
    assert dataclasses.replace(disk(), **change) != disk()


def test_values_of_different_kinds_differ():
    assert team() != disk()
    assert team() != "Team"


def test_zeros_of_both_signs_are_the_same_number():
    one, other = covey.PursuerDisk((0.0, 0.0)), covey.PursuerDisk((-0.0, 0.0))
    assert one == other
    assert len({one, other}) == 1
