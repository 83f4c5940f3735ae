"""Every public name has a page, and an example that prints what it says."""

from __future__ import annotations

import doctest
import re
from importlib import import_module
from pathlib import Path

import pytest

import covey

REFERENCE = Path(__file__).parents[1] / "docs" / "reference"
LISTED = {
    name
    for page in ("api.md", "environments.md")
    for name in re.findall(
        r"^   (covey[.\w]+)$", (REFERENCE / page).read_text("utf-8"), re.MULTILINE
    )
}
"""Names that have a page."""


@pytest.mark.parametrize("name", sorted(LISTED))
def test_its_example_prints_what_it_says(name):
    room, _, own = name.rpartition(".")
    value = getattr(import_module(room), own)
    (case,) = doctest.DocTestFinder(recurse=False).find(value, name, globs={})
    assert case.examples, f"{name} has no example"
    told = []
    doctest.DocTestRunner().run(case, out=told.append)
    assert not told, "".join(told)


def test_every_public_name_has_a_page():
    assert {f"covey.{name}" for name in covey.__all__} <= LISTED
