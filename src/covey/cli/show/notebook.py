"""Runs a notebook without Jupyter, and makes a page of it that any browser shows."""

from __future__ import annotations

import ast
import io
import json
from base64 import b64encode
from collections.abc import Iterator
from contextlib import redirect_stdout
from html import escape
from pathlib import Path
from string import Template
from typing import Any

from markdown_it import MarkdownIt

import covey

FIRST = Path(__file__).parent / "first_notebook.ipynb"
"""The notebook that comes with covey."""

_PAGE = Template((Path(__file__).parent / "notebook.html").read_text(encoding="utf-8"))


def run_notebook(file: Path) -> str:
    """Run all cells of a notebook, one after the other, and return the page.

    Below a cell stand what it printed and the value of its last line, as in Jupyter.

    Raises
    ------
    InputError
        If the file is no notebook, or a cell fails.
    """
    names: dict[str, Any] = {"__name__": "__main__"}
    parts: list[str] = []
    for number, (kind, source) in enumerate(_cells(file), 1):
        if kind == "markdown":
            parts.append(MarkdownIt().render(source))
        elif kind == "code":
            parts.append(f'<pre class="code">{escape(source)}</pre>')
            try:
                parts += _run(source, names)
            except Exception as error:
                told = f"{type(error).__name__}: {error}"
                raise covey.InputError(f"{file}: cell {number} failed: {told}") from error
    return _PAGE.substitute(title=escape(file.stem.replace("_", " ")), body="\n".join(parts))


def _cells(file: Path) -> Iterator[tuple[str, str]]:
    """Return kind and source of each cell."""
    try:
        for cell in json.loads(file.read_text(encoding="utf-8"))["cells"]:
            yield str(cell["cell_type"]), "".join(cell["source"])
    except (ValueError, LookupError, TypeError) as error:
        raise covey.InputError(f"{file}: expected a notebook of Jupyter, got {error}") from error


def _run(source: str, names: dict[str, Any]) -> Iterator[str]:
    """Run a cell, and return what it printed and its value, as HTML."""
    program, last = ast.parse(source), None
    if program.body and isinstance(program.body[-1], ast.Expr) and not source.endswith(";"):
        last = ast.Expression(program.body.pop().value)  # type: ignore[attr-defined]
    with redirect_stdout(io.StringIO()) as printed:
        exec(compile(program, "<cell>", "exec"), names)
        value = None if last is None else eval(compile(last, "<cell>", "eval"), names)
    if printed.getvalue():
        yield f"<pre>{escape(printed.getvalue())}</pre>"
    if value is not None:
        yield _shown(value)


def _shown(value: object) -> str:
    """Return a value as a notebook shows it: its table, its picture, or its text."""
    table = getattr(value, "_repr_html_", lambda: None)()
    if table is not None:
        return str(table)
    picture = getattr(value, "_repr_png_", lambda: None)()
    if picture is not None:
        return f'<img alt="" src="data:image/png;base64,{b64encode(picture).decode()}">'
    return f"<pre>{escape(repr(value))}</pre>"
