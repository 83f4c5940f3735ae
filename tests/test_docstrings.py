"""Every public name has a page, and an example that prints what it says."""

from __future__ import annotations

import doctest
import re
from pathlib import Path

import pytest

import covey

WITHOUT = {"Bracket", "SequencePlan", "bracket", "plan_for_sequence"}
"""Names of the room `bounds`, which have no examples yet."""


@pytest.mark.parametrize("name", sorted(set(covey.__all__) - WITHOUT))
def test_its_example_prints_what_it_says(name):
    value = getattr(covey, name)
    (case,) = doctest.DocTestFinder(recurse=False).find(value, name, globs={})
    assert case.examples, f"covey.{name} has no example"
    told = []
    doctest.DocTestRunner().run(case, out=told.append)
    assert not told, "".join(told)


def test_every_public_name_has_a_page():
    page = (Path(__file__).parents[1] / "docs" / "reference" / "api.md").read_text("utf-8")
    listed = re.findall(r"^   covey\.(\w+)$", page, re.MULTILINE)
    assert sorted(listed) == sorted(covey.__all__)
