"""What `covey yardstick` prints and writes."""

from __future__ import annotations

import csv

import pytest

from covey.cli import main
from covey.studies.analysis import yardstick


def test_prints_a_table_and_saves_tables_and_picture(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(yardstick, "SPEEDS", ((0.25, 0.25),))
    folder = tmp_path / "there"
    assert main(["yardstick", "--pairs", "1", "--cells", "64", "-o", str(folder)]) == 0
    rows = [line.split()[:3] for line in capsys.readouterr().out.splitlines() if "0.25/" in line]
    assert ["0.25/0.25", "close", "iterative-open-loop"] in rows
    with (folder / "yardstick.csv").open() as file:
        scores = list(csv.DictReader(file))
    assert len(scores) == len(rows)
    for row in scores:
        plans = row["evaders"] in {"open-loop", "iterative-open-loop"}
        share = float(row["survival_time"]) / float(row["value"])
        assert (0.9 if plans else 0.2) < share < 1.02
    with (folder / "convergence.csv").open() as file:
        assert [row["cells"] for row in csv.DictReader(file)] == ["32", "64", "32", "64"]
    assert {path.suffix for path in folder.iterdir()} == {".csv", ".png", ".svg", ".pdf"}


@pytest.mark.parametrize(
    ("words", "message"),
    [(["--pairs", "0"], "pairs: expected"), (["--cells", "10"], "cells: expected")],
)
def test_refuses_what_it_cannot_measure(words, message, tmp_path, capsys):
    assert main(["yardstick", *words, "-o", str(tmp_path / "out")]) == 2
    assert message in capsys.readouterr().err
