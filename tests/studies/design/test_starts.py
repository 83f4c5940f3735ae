"""Where the evaders of a study start."""

from __future__ import annotations

import math

import numpy as np
import pytest

from covey.model import InputError
from covey.studies import Disk, FromFile, Square, Study

FROZEN = (
    [[-0.25272862257503526, -0.17384353878691272], [-0.42298629264415555, -0.39351222472721936]],
    [-2.5390565183453164, -2.392276950827379],
    2474225845,
)
"""Positions, headings and seed of a start."""


def test_a_start_depends_on_the_seed_and_its_number_alone():
    few, many = Study(starts=3, seed=5), Study(starts=300, seed=5, turn_rate=[0.1, 7.0])
    for number in range(3):
        one, other = few.start(number, 5), many.start(number, 5)
        assert (one.positions == other.positions).all()
        assert (one.headings == other.headings).all()
        assert one.seed == other.seed
    assert not np.allclose(few.start(0, 5).positions, few.start(1, 5).positions)
    assert not np.allclose(few.start(0, 5).positions, Study(seed=6).start(0, 5).positions)


def test_no_start_is_one_of_a_neighbouring_seed():
    """Start k of seed s isn't start k - 1 of seed s + 1, as it would be if the two were added."""
    drawn = [
        (seed, number, Study(seed=seed).start(number, 2))
        for seed in range(6)
        for number in range(6)
    ]
    assert len({start.positions.tobytes() for _, _, start in drawn}) == 36
    assert len({start.seed for _, _, start in drawn}) == 36


def test_a_start_is_what_it_was_in_every_version():
    """Frozen: the positions, headings and seed of start 5 of seed 3."""
    positions, headings, seed = Study(seed=3).start(5, 2)
    assert positions.tolist() == FROZEN[0]
    assert headings == pytest.approx(FROZEN[1], rel=1e-15)
    assert seed == FROZEN[2]


@pytest.mark.parametrize("sampler", [Square(), Square(headings="random"), Disk()])
def test_a_small_team_is_the_first_of_a_large_one(sampler):
    study = Study(sampler=sampler)
    three, five = study.start(7, 3), study.start(7, 5)
    assert (three.positions == five.positions[:3]).all()
    assert (three.headings == five.headings[:3]).all()


@pytest.mark.parametrize("ending", ["csv", "parquet"])
def test_starts_come_from_a_file(tmp_path, ending):
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame(
        {"start": [1, 1, 0, 0], "x": [0.1, 0.2, 0.3, 0.4], "y": [1.0, 2.0, 3.0, 4.0]}
    )
    path = tmp_path / f"starts.{ending}"
    table.to_csv(path, index=False) if ending == "csv" else table.to_parquet(path)
    study = Study(sampler=FromFile(str(path)), starts=2, team_size=2)
    assert study.start(0, 2).positions.tolist() == [[0.3, 3.0], [0.4, 4.0]]
    assert study.only(1, 2).start(1, 2).positions.tolist() == [[0.1, 1.0], [0.2, 2.0]]
    assert study.start(1, 2).headings.tolist() == pytest.approx(
        [math.atan2(1.0, 0.1), math.atan2(2.0, 0.2)]
    )
    with pytest.raises(InputError, match=r"team_size: expected at most 2.*got 3"):
        Study(sampler=FromFile(str(path)), starts=2, team_size=[2, 3])
    with pytest.raises(InputError, match="starts: expected at most 2"):
        Study(sampler=FromFile(str(path)), starts=3, team_size=2)


def test_a_file_without_its_columns_is_refused(tmp_path):
    path = tmp_path / "starts.csv"
    path.write_text("start,x\n0,1.0\n")
    with pytest.raises(InputError, match="y missing"):
        FromFile(str(path))
    with pytest.raises(InputError, match="can't be read"):
        FromFile(str(tmp_path / "none.csv"))
