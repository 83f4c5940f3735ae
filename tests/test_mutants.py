"""The planted bugs still have a place in the sources."""

import shutil
from pathlib import Path

import pytest

from mutants.bugs import BUGS

PACKAGE = Path(__file__).parents[1] / "src" / "covey"


@pytest.mark.parametrize("bug", BUGS, ids=lambda bug: bug.name)
def test_a_bug_can_be_planted(bug, tmp_path):
    (tmp_path / bug.file).parent.mkdir(parents=True)
    shutil.copy(PACKAGE / bug.file, tmp_path / bug.file)
    bug.plant(tmp_path)
    assert (tmp_path / bug.file).read_text("utf-8") != (PACKAGE / bug.file).read_text("utf-8")


def test_no_two_bugs_have_one_name():
    assert len({bug.name for bug in BUGS}) == len(BUGS)
