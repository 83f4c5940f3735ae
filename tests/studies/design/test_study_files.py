"""Study files and study values: all mistakes at once, and the grid that they span."""

from __future__ import annotations

import math

import pytest

import covey
from covey.model import InputError
from covey.studies import AsVisible, Formation, Study, example_names, example_path, read_study
from covey.studies.design.case import game_of


def test_a_file_says_what_the_value_says(tmp_path):
    path = tmp_path / "study.toml"
    path.write_text(
        """
        starts = 12
        seed = 4
        sampler = { name = "formation", shape = "ring", spacing = 0.2 }
        trajectories = true
        unit = "km"
        [grid]
        team_size = [2, 4]
        turn_rate = ["pi/2", "180 deg", inf]
        sensing = "hidden"
        evaders = ["open-loop", { name = "iterative-open-loop", starts = 3 }]
        pursuer = "as-visible"
        """
    )
    study = read_study(path)
    assert (
        study.describe()
        == Study(
            starts=12,
            seed=4,
            sampler=Formation("ring", spacing=0.2),
            trajectories=True,
            unit="km",
            team_size=(2, 4),
            turn_rate=[math.pi / 2, math.pi, math.inf],
            sensing="hidden",
            evaders=[covey.OpenLoop(), covey.IterativeOpenLoop(starts=3)],
            pursuer=AsVisible(),
        ).describe()
    )
    assert len(study.cases) == 2 * 3 * 2
    assert study.games == 12 * 12


def test_all_mistakes_of_a_file_are_told_at_once(tmp_path):
    path = tmp_path / "study.toml"
    path.write_text(
        """
        starts = 0
        sed = 4
        speed = 0.2
        sampler = { name = "circle" }
        [grid]
        team_size = [2, 60]
        turn_rate = [1.0, 1.0]
        sensing = "hiden"
        pursuer = { name = "committed", margn = 0.1 }
        """
    )
    with pytest.raises(InputError) as caught:
        read_study(path)
    message = str(caught.value)
    for part in (
        "8 mistakes",
        "starts: expected a whole number >= 1, got 0",
        'sed: unknown key; did you mean "seed"?',
        'speed: unknown key; did you mean "seed"?; "speed" belongs to [grid]',
        'sampler.name: expected one of "square"',
        "grid.team_size[1]: expected a whole number from 1 to 50, got 60",
        "grid.turn_rate[1]: given twice",
        "grid.sensing: expected one of",
        'grid.pursuer.margn: unknown key; did you mean "margin"?',
    ):
        assert part in message


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"speed": [0.1, 1.0]}, "expected every evader to be slower than the pursuer"),
        ({"team_size": []}, "expected a value or a list of values"),
        ({"pursuer": covey.FixedSequence([0, 1])}, "expected a sequence of all 5 evaders"),
        ({"pursuer": iter([{"name": "committed", "margn": 1}])}, r"pursuer\[0\].margn: unknown"),
        ({"evaders": 3}, "evaders: expected a name, or a table"),
        ({"objective": "totl-survival"}, 'did you mean "total-survival"'),
        (
            {"objective": covey.ExpectedSurvival([(0, 1)])},
            "objective.0.: ExpectedSurvival: expected sequences of all 5 evaders",
        ),
        ({"pursuer": covey.RandomSequence([(0, 1)])}, "pursuer.0.: RandomSequence: expected"),
        ({"objective": covey.TotalSurvival}, "objective: expected LastCapture"),
        ({"objective": "expected-survival", "team_size": [2, 9]}, "are too many"),
        ({"unit": "two words"}, 'unit: expected a short word such as "m", got'),
        ({"turn_rate": "pi/0"}, "turn_rate: expected a turn rate >= 0"),
        ({"turn_radius": [1, -1]}, r"turn_radius\[1\]: expected a turning radius >= 0"),
        ({"turn_rate": 1, "turn_radius": 1}, "turn_radius: expected turn_rate or turn_radius, got"),
    ],
)
def test_what_cannot_be_is_refused(given, message):
    with pytest.raises(InputError, match=message):
        Study(**given)


def test_a_turning_radius_stands_for_the_turn_rate(tmp_path):
    path = tmp_path / "study.toml"
    path.write_text("[grid]\nspeed = [0.1, 0.2]\nturn_radius = [0.4, inf]\nsensing = 'hidden'\n")
    study = read_study(path)
    grid = study.describe()["grid"]
    assert (grid["turn_rate"], grid["turn_radius"]) == ([None], [0.4, math.inf])
    teams = [game_of(case, study.start(0, 5))[0] for case in study.cases]
    assert [team.turn_rates[0] for team in teams] == [0.25, 0.0, 0.5, 0.0]


def test_a_file_that_is_none_is_an_error(tmp_path):
    with pytest.raises(InputError, match="no such file, and no study of that name"):
        read_study(tmp_path / "none.toml")
    (tmp_path / "broken.toml").write_text("starts = ")
    with pytest.raises(InputError, match="expected a study in TOML"):
        read_study(tmp_path / "broken.toml")


def test_the_papers_studies_come_along():
    studies = [
        "fig4",
        "fig4-assured",
        "fig5",
        "fig5-contingent",
        "growth",
        "objectives",
        "tournament",
    ]
    assert example_names() == studies
    fig4, fig5 = (read_study(example_path(name)) for name in ("fig4", "fig5"))
    assert fig4.games == 500 * 2 * 2
    assert fig5.games == 500 * 4 * 4 * 2
    # The same starts, so that the figures can be compared.
    assert (fig4.start(9, 5).positions == fig5.start(9, 5).positions).all()
