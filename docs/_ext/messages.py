"""Lists the error messages of the package, as they stand in its source."""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

import covey

SOURCE = Path(covey.__file__).parent
MESSAGE = {"InputError": 0, "BuildError": 0, "ImportError": 0, "wanted": 0, "wanted_but_got": 0}
MESSAGE |= {"ValueType": 0, "Mistake": 1}
"""What makes an error message, and which of its arguments is the text."""
EXPECTED = {"wanted", "wanted_but_got", "ValueType"}
"""What makes a message of the words of what was wanted."""

ROOMS = {
    "model": "Teams, disks, objectives",
    "planning": "Plans and guarantees",
    "bounds": "Bounds",
    "simulation": "Games, strategies and records of games",
    "players": "Players",
    "scenarios": "Scenario and study files",
    "studies": "Studies and their results",
    "views": "Pictures and films",
    "envs": "Learning environments",
    "web": "The page of covey chase",
    "cli": "The command line",
    "kernels": "The kernels",
}


def messages() -> Iterator[tuple[str, str]]:
    """Return each message with the room that tells it; values are left out."""
    for file in sorted(SOURCE.rglob("*.py")):
        room = file.relative_to(SOURCE).parts[0]
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call):
                name = ast.unparse(node.func).rpartition(".")[2]
                place = MESSAGE.get(name, len(node.args))
                text = _text(node.args[place]) if place < len(node.args) else ""
                if text.strip("… :;\n"):
                    yield room, f"expected {text}, got …" if name in EXPECTED else text


def _text(node: ast.expr) -> str:
    """Return the text of an expression, with <name> or … for what is known when it is told."""
    match node:
        case ast.Constant(value=str(text)):
            return text
        case ast.FormattedValue(value=ast.Name(id=name)):
            return f"<{name}>"
        case ast.JoinedStr(values=parts):
            return "".join(map(_text, parts))
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            return _text(left) + _text(right)
    return "…"


class Messages(SphinxDirective):
    """All messages, a list for each room."""

    def run(self) -> list[nodes.Node]:
        """Return a section for each room."""
        found = defaultdict(set)
        for room, text in messages():
            found[room].add(text)
        return [self._section(title, sorted(found[room])) for room, title in ROOMS.items()]

    def _section(self, title: str, texts: list[str]) -> nodes.section:
        section = nodes.section("", nodes.title("", title), ids=[nodes.make_id(title)])
        items = [nodes.list_item("", nodes.paragraph("", "", nodes.literal("", t))) for t in texts]
        section += nodes.bullet_list("", *items)
        return section


def setup(app: Sphinx) -> dict[str, bool]:
    """Offer the directive."""
    app.add_directive("messages", Messages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
