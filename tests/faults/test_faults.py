"""A moment of each quick fault; `make faults` tries many, and the slow faults too."""

from __future__ import annotations

import sys
from pathlib import Path
from random import Random

import pytest

import covey
from faults import __main__ as program
from faults import cuts, disks, interrupts, kills
from faults.catalogue import name_of, try_at
from faults.outcome import (
    Ended,
    FaultError,
    SkippedError,
    require_interrupted,
    require_told,
)
from faults.study import RESULTS, put_files, require_undisturbed, undisturbed

pytestmark = pytest.mark.skipif(
    not Path("/proc/self/stat").exists(), reason="the processes are found in /proc"
)

QUICK = [
    kills.kill_study,
    interrupts.interrupt_at_file,
    interrupts.interrupt_calls,
    disks.full_disk,
    cuts.damaged_parts,
]


@pytest.mark.parametrize("fault", QUICK, ids=name_of)
def test_a_fault_changes_no_result(fault, tmp_path, monkeypatch):
    monkeypatch.setattr(interrupts, "INTERRUPTS", 20)
    try:
        try_at(fault, 0, tmp_path)
    except SkippedError as reason:
        pytest.skip(str(reason))


def test_a_seed_is_a_moment():
    drawn = []

    def fault(random: Random, _folder: Path) -> None:
        drawn.append(random.random())

    for seed in (0, 1, 0):
        try_at(fault, seed, Path())
    assert drawn[0] == drawn[2] != drawn[1]


def test_a_result_that_differs_is_noticed(tmp_path):
    whole = undisturbed()
    done = Ended(0, whole.output, "")
    put_files(tmp_path, whole.files)
    require_undisturbed(tmp_path, done)
    with pytest.raises(FaultError, match="another table"):
        require_undisturbed(tmp_path, done._replace(output="no table"))
    part = tmp_path / RESULTS / "trajectories" / "part-00001.parquet"
    part.write_bytes(part.read_bytes()[:-1])
    with pytest.raises(FaultError, match=r"missing or differ: trajectories/part-00001\.parquet"):
        require_undisturbed(tmp_path, done)
    put_files(tmp_path, whole.files)
    (part.parent / ".part-00001.parquet.0.part").touch()
    with pytest.raises(FaultError, match="should not be there: trajectories"):
        require_undisturbed(tmp_path, done)


@pytest.mark.parametrize(
    ("ended", "reason"),
    [
        (Ended(2, "", "Traceback (most recent call last):\n"), "traceback"),
        (Ended(2, "", "covey: stopped\nFatal Python error: x\n"), "traceback"),
        (Ended(2, "", "RuntimeWarning: x\n"), "not covey's"),
        (Ended(2, "", ""), "without a word"),
        (Ended(1, "", "covey: x\n"), "exit status 1"),
    ],
)
def test_an_end_that_no_user_understands_is_noticed(ended, reason):
    with pytest.raises(FaultError, match=reason):
        require_told(ended, [0, 2])


def test_only_an_interrupt_before_covey_begins_may_have_a_traceback():
    start = 'Traceback (most recent call last):\n  File "site.py", line 1, in main\n'
    require_interrupted(Ended(-2, "", start))
    require_interrupted(Ended(130, "", "covey: stopped\n"))
    with pytest.raises(FaultError, match="traceback"):
        require_interrupted(Ended(-2, "", f'{start}  File "{covey.__file__}", line 1\n'))


def test_a_failure_is_told_with_the_command_that_repeats_it(monkeypatch, capsys):
    def sore(random, folder):
        assert folder.is_dir()
        if random.random() < 0.5:
            raise FaultError("a file differs")

    monkeypatch.setattr(program, "FAULTS", {sore: 20})
    monkeypatch.setattr(sys, "argv", ["faults"])
    assert program.main() == 1
    told = capsys.readouterr().out
    command = "python -m faults --fault sore --seed "
    failed = [line.partition(command)[2] for line in told.splitlines() if command in line]
    assert 0 < len(failed) < 20
    monkeypatch.setattr(sys, "argv", ["faults", *f"--fault sore --seed {failed[-1]}".split()])
    assert program.main() == 1
    assert "1 moments    1 failed" in capsys.readouterr().out


def test_a_fault_that_cannot_be_made_is_skipped_with_a_reason(monkeypatch, capsys):
    def rootless(random, folder):
        raise SkippedError("it takes root")

    monkeypatch.setattr(program, "FAULTS", {rootless: 20})
    monkeypatch.setattr(sys, "argv", ["faults"])
    assert program.main() == 0
    assert capsys.readouterr().out.split() == ["rootless", "skipped:", "it", "takes", "root"]
