"""Scenario files to test with."""

from __future__ import annotations

import pytest

import covey
from covey.scenarios import load_scenario

ONE_EVADER = "[[team.evaders]]\nposition = [0.3, 0.4]\n"


def written(folder, text):
    """A file with this text."""
    path = folder / "game.toml"
    path.write_text(text, encoding="utf-8")
    return path


def loaded(folder, text, **options):
    """The scenario that this text describes."""
    return load_scenario(written(folder, text), **options)


def mistakes(folder, text):
    """The lines that tell the mistakes of this text, one each, sorted."""
    path = written(folder, text)
    with pytest.raises(covey.InputError) as caught:
        load_scenario(path)
    first, *lines = str(caught.value).split("\n  ")
    count = "1 mistake" if len(lines) == 1 else f"{len(lines)} mistakes"
    assert first == f"{path}: {count}"
    return sorted(lines)
