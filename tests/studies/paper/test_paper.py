"""The figures of the paper's studies and their claims, from made-up times."""

from __future__ import annotations

from itertools import product

import numpy as np
import pyarrow as pa
import pytest

from covey.model import InputError
from covey.studies import Study, StudyResult
from covey.studies.paper.claims import DIFFERS, HOLDS, PARTLY, fig4_claims, fig5_claims
from covey.studies.paper.figures import (
    Gains,
    answer_gains,
    guarantee_ratios,
    raised,
    survival_ratios,
    turn_rate_gains,
)
from covey.studies.statistics import Estimate

RATES = [0.8, 1.6, 3.2]


def gains(*rows):
    ratios = {k + 2: [Estimate(value, 0.01) for value in row] for k, row in enumerate(rows)}
    return {"visible": Gains(RATES, ratios, ratios)}


class MadeUp(StudyResult):
    """Three starts; a survival time is a number that tells the fields of its game's case."""

    def __init__(self, folder, **grid):
        study = Study(starts=3, **grid)
        super().__init__(folder, {"study": study.describe(), "cases": len(study.cases)})
        self.times = [
            start * case.team_size * (2.0 if case.sensing == "hidden" else 1.0) + case.turn_rate
            for start, case in product((1, 2, 3), study.cases)
        ]

    def parts(self):
        yield pa.table({"survival_time": self.times, "guarantee": np.full(len(self.times), 0.5)})


@pytest.mark.parametrize("sensing", [["visible", "hidden"], ["hidden", "visible"]])
def test_figures_take_their_games_by_the_fields_of_the_cases(tmp_path, sensing):
    fig4 = MadeUp(tmp_path, team_size=[5, 3], turn_rate=1.0, sensing=sensing)
    ratios, guarantees = survival_ratios(fig4), guarantee_ratios(fig4)
    for size in (3, 5):
        visible = np.array([1, 2, 3]) * size + 1.0
        hidden = np.array([2, 4, 6]) * size + 1.0
        assert (ratios[size] == hidden / visible).all()
        assert (guarantees[size] == visible / 0.5).all()
    fig5 = MadeUp(tmp_path, team_size=[2, 3], turn_rate=[3.0, 1.0], sensing=sensing)
    gains = turn_rate_gains(fig5)["hidden"]
    assert gains.turn_rates == [1.0, 3.0]
    assert [each.value for each in gains.survival[3]] == pytest.approx([13.0, 15.0])
    assert [each.value for each in gains.ratios[3]] == pytest.approx([1.0, 15.0 / 13.0])


def test_teams_that_answer_captures_are_compared_with_the_first_team_at_each_rate(tmp_path):
    teams = ["iterative-open-loop", {"name": "contingent", "depth": 2}]
    grid = {"team_size": [2, 3], "turn_rate": [3.0, 1.0], "sensing": "hidden"}
    made_up = MadeUp(tmp_path, evaders=teams, **grid)
    answering = made_up.study["grid"]["evaders"][1]
    made_up.times += np.tile([each["evaders"] == answering for each in made_up.cases], 3)
    found = answer_gains(made_up)
    assert [each.value for each in found.survival[3]] == pytest.approx([14.0, 16.0])
    assert [each.value for each in found.ratios[3]] == pytest.approx([14.0 / 13.0, 16.0 / 15.0])


def test_their_line_is_the_papers_times_what_they_gain():
    rates, survival = [1.0, 2.0], {5: [Estimate(4.0, 0.1)] * 2}
    paper = Gains(rates, {3: [], 5: [Estimate(1.0, 0.0), Estimate(1.2, 0.012)]}, survival)
    answers = Gains(rates, {5: [Estimate(1.1, 0.011), Estimate(1.5, 0.0)]}, survival)
    (row,) = raised(paper, answers).ratios.values()
    assert [each.value for each in row] == pytest.approx([1.1, 1.8])
    assert [each.error for each in row] == pytest.approx([0.011, 0.018])


def test_starts_with_a_stopped_game_are_left_out_of_fig4(tmp_path):
    fig4 = MadeUp(tmp_path, team_size=3, turn_rate=1.0)
    fig4.times[2] = np.inf  # start 1, visible
    assert survival_ratios(fig4)[3].tolist() == [7.0 / 4.0, 19.0 / 10.0]


def test_a_study_without_the_games_of_a_figure_is_refused(tmp_path):
    hidden = MadeUp(tmp_path, team_size=3, sensing="hidden")
    with pytest.raises(InputError, match="one case with team_size = 3, sensing = visible, got 0"):
        survival_ratios(hidden)
    twice = MadeUp(tmp_path, team_size=3, speed=[0.2, 0.3])
    with pytest.raises(InputError, match="one case with team_size = 3, sensing = hidden, got 2"):
        survival_ratios(twice)


def test_ratios_like_the_papers_bear_out_its_claims():
    five = np.array([1.0] * 200 + [0.95] * 300)
    verdicts = [claim.verdict for claim in fig4_claims({3: np.ones(500), 5: five})]
    assert verdicts == [HOLDS, HOLDS, HOLDS, HOLDS, PARTLY]


def test_ratios_unlike_the_papers_do_not():
    three, five = np.full(500, 0.85), np.array([1.0] * 400 + [0.88] * 100)
    claims = list(fig4_claims({3: three, 5: five}))
    assert [claim.verdict for claim in claims[:4]] == [DIFFERS, DIFFERS, PARTLY, DIFFERS]
    assert "400 of 500 above 0.9; the 100 others: 0.880" in claims[2].ours


def test_a_share_at_one_that_depends_on_its_width_is_told_as_such():
    five = np.array([1.0] * 150 + [0.992] * 100 + [0.95] * 250)
    claim = list(fig4_claims({3: np.ones(500), 5: five}))[1]
    assert claim.verdict == PARTLY
    assert "150 of 500 (30 ± 4 %) within 0.005 of 1, 250 within 0.01" in claim.ours


def test_gains_like_the_papers_bear_out_its_claims():
    claims = list(fig5_claims(gains([1, 1.02, 1.03], [1, 1.05, 1.08])))
    assert [claim.verdict for claim in claims] == [HOLDS, HOLDS, HOLDS]
    claims = list(fig5_claims(gains([1, 1.02, 1.01], [1, 1.001, 1.004])))
    assert [claim.verdict for claim in claims] == [PARTLY, PARTLY, PARTLY]
