"""The digest of the code: every source that may change a game is in it, and no other."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import covey
from covey.studies.running.provenance import code_digest, digest_of

PACKAGE = Path(covey.__file__).parent


@pytest.fixture
def package(tmp_path):
    copy = tmp_path / "covey"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__", "page"))
    return copy


def test_a_copy_of_the_code_has_the_same_digest(package):
    assert digest_of(package) == code_digest() == digest_of(PACKAGE)


@pytest.mark.parametrize(
    "room", ["kernels", "model", "planning", "simulation", "players", "scenarios", "studies"]
)
def test_a_changed_source_changes_the_digest(package, room):
    (package / room / "__init__.py").write_text("# changed")
    assert digest_of(package) != code_digest()


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


def test_pictures_may_change(package):
    (package / "views" / "__init__.py").write_text("# changed")
    assert digest_of(package) == code_digest()
