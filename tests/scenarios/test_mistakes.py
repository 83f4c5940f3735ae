"""All mistakes of a scenario file at once; what is no scenario at all is refused."""

from __future__ import annotations

import pytest

import covey
from covey.scenarios import load_scenario
from scenarios.scenario_files import mistakes


def test_all_mistakes_are_told_at_once(tmp_path):
    lines = mistakes(
        tmp_path,
        """
        [pursuer]
        speed = 0.2
        captur_radius = 0.1
        strategy = "comitted"
        [team]
        strategy = { name = "open-loop", strats = 3, starts = 0 }
        [[team.evaders]]
        position = [0.3, 0.1, 0.2]
        speed = 0.1
        [[team.evaders]]
        postion = [0.3, 0.1]
        speed = 0.2
        [game]
        sensing = "seen"
        """,
    )
    assert [line.partition(":")[0] for line in lines] == [
        "game.sensing",
        "pursuer.captur_radius",
        "pursuer.strategy",
        "team.evaders[0].position",
        "team.evaders[1].postion",
        "team.evaders[1].speed",
        "team.strategy.starts",
        "team.strategy.strats",
    ]


@pytest.mark.parametrize(
    ("content", "wanted"),
    [
        (b"position = [1,", "expected a scenario in TOML: Invalid value"),
        (b"a = 1\na = 2\n", "expected a scenario in TOML: Cannot overwrite a value"),
        (b"\xff\xfe\x00\x01", "expected a scenario in TOML, got a binary file"),
        (b"\x00" * 20, "expected a scenario in TOML: "),
    ],
)
def test_a_file_that_is_no_toml_is_refused(content, wanted, tmp_path):
    path = tmp_path / "game.toml"
    path.write_bytes(content)
    with pytest.raises(covey.InputError) as caught:
        load_scenario(path)
    assert str(caught.value).startswith(f"{path}: {wanted}")


def test_a_file_that_is_not_there_and_a_folder_are_refused(tmp_path):
    with pytest.raises(covey.InputError, match=r"none.toml: no such file, and no scenario of"):
        load_scenario(tmp_path / "none.toml")
    with pytest.raises(covey.InputError, match="can't be read: Is a directory"):
        load_scenario(tmp_path)
