"""A target: how its cases are drawn, and what is checked of each."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from hypothesis.strategies import SearchStrategy

CORPUS = Path(__file__).parent / "corpus"
"""A folder for each target, with a file for each case that once failed or is worth a replay."""


class Target(NamedTuple):
    """Something that takes input from outside.

    Attributes
    ----------
    name : str
        Also the name of its folder in the corpus.
    suffix : str
        Of the files that hold its cases.
    cases : SearchStrategy
        Draws contents of such files.
    check : callable
        Takes the content of a file. Returns what came of it, as a text. Raises an exception for a
        finding.
    """

    name: str
    suffix: str
    cases: SearchStrategy[bytes]
    check: Callable[[bytes], str]


def corpus(name: str) -> list[Path]:
    """Return the files of a target's corpus."""
    return sorted((CORPUS / name).glob("[!.]*"))
