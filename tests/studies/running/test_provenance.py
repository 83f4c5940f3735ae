"""The digest of the code: every source that may change a game is in it, and no other."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import covey
from covey.studies import run_study
from covey.studies.running.provenance import code_digest, digest_of
from studies.small_studies import files

PACKAGE = Path(covey.__file__).parent
WITHOUT_GAMES = {"views", "envs", "web", "cli", "testing", "instances"}


@pytest.fixture
def package(tmp_path):
    copy = tmp_path / "covey"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__", "page"))
    return copy


def test_a_copy_of_the_code_has_the_same_digest(package):
    assert digest_of(package) == code_digest() == digest_of(PACKAGE)


def test_one_changed_byte_of_any_source_of_a_game_changes_the_digest(package):
    sources = [
        source
        for room in package.iterdir()
        if room.is_dir() and room.name not in WITHOUT_GAMES
        for source in room.rglob("*.py")
    ]
    assert len(sources) > 100
    digests = {code_digest()}
    for source in sources:
        content = source.read_bytes()
        source.write_bytes(content[:-1] + b" ")
        digests.add(digest_of(package))
        source.write_bytes(content)
    assert len(digests) == 1 + len(sources)
    assert digest_of(package) == code_digest()


def test_a_study_is_not_finished_by_code_that_differs_in_one_byte(package, tmp_path):
    (tmp_path / "small.toml").write_text("starts = 2\n[grid]\nteam_size = 1\nupdate_time = 0.2\n")
    folder = tmp_path / "results"
    run_study(tmp_path / "small.toml", folder, workers=1)
    before = files(folder)
    command = [sys.executable, "-m", "covey", "study", tmp_path / "small.toml", "-o", folder]

    def run():
        environment = {**os.environ, "PYTHONPATH": str(package.parent)}
        return subprocess.run(
            [*command, "--workers", "1"],
            env=environment,
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=False,
        )

    assert run().returncode == 0
    source = package / "players" / "simulate.py"
    source.write_bytes(source.read_bytes().replace(b"Play one game", b"Play any game"))
    refused = run()
    assert refused.returncode == 2
    assert "\n  covey_code: is " in refused.stderr
    assert files(folder) == before


def test_a_source_in_a_sub_room_counts(package):
    sub_room = package / "scenarios" / "layouts"
    sub_room.mkdir()
    (sub_room / "ring.py").write_text("COUNT = 1")
    before = digest_of(package)
    (sub_room / "ring.py").write_text("COUNT = 2")
    assert len({code_digest(), before, digest_of(package)}) == 3


def test_a_source_that_moves_changes_the_digest(package):
    (package / "model" / "sub_room").mkdir()
    (package / "model" / "angles.py").rename(package / "model" / "sub_room" / "angles.py")
    assert digest_of(package) != code_digest()


@pytest.mark.parametrize("room", sorted(WITHOUT_GAMES))
def test_what_plays_no_game_of_a_study_may_change(package, room):
    (package / room / "__init__.py").write_text("# changed")
    assert digest_of(package) == code_digest()
