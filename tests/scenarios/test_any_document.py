"""Whatever stands in a document, its mistakes are told as lines."""

from __future__ import annotations

import math

from hypothesis import given
from hypothesis import strategies as st

import covey
from covey.scenarios.load import checked

_leaves = st.sampled_from(
    [
        True,
        0,
        -1,
        3,
        19,
        10**400,
        0.5,
        math.inf,
        math.nan,
        "",
        "away",
        "committed",
        "open-loop",
        "fixed-sequence",
        "90 deg",
        [],
        [0, 1],
        [[0, 0]],
        {},
    ]
)
_keys = st.sampled_from(
    [
        "pursuer",
        "team",
        "game",
        "evaders",
        "random",
        "position",
        "heading",
        "headings",
        "speed",
        "turn_rate",
        "strategy",
        "name",
        "sequence",
        "margin",
        "starts",
        "count",
        "side",
        "seed",
        "center",
        "radius",
        "sensing",
        "update_time",
        "wings",
    ]
)
_anything = st.recursive(
    _leaves,
    lambda part: st.lists(part, max_size=3) | st.dictionaries(_keys, part, max_size=6),
    max_leaves=20,
)
_tables = st.dictionaries(_keys, _anything, max_size=6)


@given(
    document=st.fixed_dictionaries(
        {}, optional={"pursuer": _tables, "team": _tables, "game": _tables}
    )
    | st.dictionaries(_keys, _anything)
)
def test_no_document_brings_the_checks_to_fall(document, tmp_path_factory):
    path = tmp_path_factory.getbasetemp() / "any.toml"
    try:
        checked(document, path)
    except covey.InputError as error:
        first, *lines = str(error).split("\n  ")
        count = int(first.removeprefix(f"{path}: ").partition(" mistake")[0])
        if count > 10:
            assert lines.pop() == f"and {count - 10} more"
        assert len(set(lines)) == len(lines) == min(count, 10)
