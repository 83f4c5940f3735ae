"""Lists the error messages of the package, as they stand in its source."""

from __future__ import annotations

from collections import defaultdict

from docutils import nodes
from found_messages import messages
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

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
