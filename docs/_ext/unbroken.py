"""Keeps the parts of a number on one line: 135 180, and 2 %."""

from __future__ import annotations

import re
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform

GAP = re.compile(r"(?<=\d) (?=\d{3}(?!\d)|%)|(?<=±) (?=[.\d])")
CODE = (nodes.literal, nodes.literal_block, nodes.math, nodes.math_block)


class UnbrokenNumbers(SphinxPostTransform):
    """Writes a space that is no place for a line break inside of each number."""

    default_priority = 900

    def run(self, **_: Any) -> None:
        """Replace the texts that have such a number."""
        for text in list(self.document.findall(nodes.Text)):
            if GAP.search(text) and not isinstance(text.parent, CODE):
                text.parent.replace(text, nodes.Text(GAP.sub("\N{NO-BREAK SPACE}", text)))


def setup(app: Sphinx) -> dict[str, bool]:
    """Offer the transform."""
    app.add_post_transform(UnbrokenNumbers)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
