"""Puts right what stands otherwise in a docstring or a signature than on a page."""

from __future__ import annotations

import re
from pathlib import Path

from sphinx.application import Sphinx

DECISIONS = Path(__file__).parents[1] / "decisions"


def link_documents(*event: object) -> None:
    """Make a link of docs/decisions/0009, and of docs/yardstick.md."""
    lines = event[-1]
    assert isinstance(lines, list)
    lines[:] = [re.sub(r"docs/decisions/(\d{4})", _decision, line) for line in lines]
    lines[:] = [re.sub(r"docs/(\w+)\.md", r":doc:`/\1`", line) for line in lines]


def _decision(found: re.Match[str]) -> str:
    (note,) = DECISIONS.glob(f"{found[1]}-*.md")
    return f":doc:`decision {found[1]} </decisions/{note.stem}>`"


def name_aliases(*event: object) -> tuple[object, ...]:
    """Write the alias of a type by its name."""
    *_, signature, returned = event
    return _named(signature), _named(returned)


def _named(signature: object) -> object:
    text = re.sub(r"TypeAliasForwardRef\('(.*?)'\)", r"\1", str(signature))
    return signature and text.replace("npt.", "")


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect both."""
    app.connect("autodoc-process-docstring", link_documents)
    app.connect("autodoc-process-signature", name_aliases)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
