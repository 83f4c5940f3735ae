"""Every public name has an example, and it prints what it says."""

from __future__ import annotations

import doctest

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
