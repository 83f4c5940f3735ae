"""Finds the error messages of the package, as they stand in its source."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import covey

SOURCE = Path(covey.__file__).parent
MESSAGE = {"InputError": 0, "BuildError": 0, "ImportError": 0, "wanted": 0, "wanted_but_got": 0}
MESSAGE |= {"ValueType": 0, "Mistake": 1, "DamagedPartError": 0, "_NotARecordError": 0}
MESSAGE |= {"OtherCodeError": 0, "MissingGamesError": 0, "RuntimeError": 0, "ValueError": 0}
MESSAGE |= {"TypeError": 0, "KeyboardInterrupt": 0}
"""What makes an error message, and which of its arguments is the text."""
EXPECTED = {"wanted", "wanted_but_got", "ValueType"}
"""What makes a message of the words of what was wanted."""
BEGINNINGS = ("expected ", "missing; ", "unknown key")
"""Of the text after the name of an argument or a key. Such a text is a message anywhere."""


def messages() -> Iterator[tuple[str, str]]:
    """Return each message with the room that tells it; values are left out."""
    for file in sorted(SOURCE.rglob("*.py")):
        room = file.relative_to(SOURCE).parts[0]
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            for text in _told(node):
                if text.strip("… :;\n"):
                    yield room, text


def _told(node: ast.AST) -> Iterator[str]:
    """Return the message of a call that makes one, or of a text that is one by its words."""
    if isinstance(node, ast.Call):
        name = ast.unparse(node.func).rpartition(".")[2]
        place = MESSAGE.get(name, len(node.args))
        text = text_of(node.args[place]) if place < len(node.args) else ""
        yield f"expected {text}, got …" if name in EXPECTED and text.strip("… ") else text
    elif isinstance(node, ast.Assign | ast.Return) and node.value is not None:
        text = text_of(node.value)
        if text.rpartition(": ")[2].startswith(BEGINNINGS):
            yield text


def text_of(node: ast.expr) -> str:
    """Return the text of an expression, with <name> or … for what is known when it is told."""
    match node:
        case ast.Constant(value=str(text)):
            return text
        case ast.FormattedValue(value=ast.Name(id=name)):
            return f"<{name}>"
        case ast.JoinedStr(values=parts):
            return "".join(map(text_of, parts))
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            return text_of(left) + text_of(right)
    return "…"
