"""Writes mathematics as MathML, which browsers draw without a script.

The pages then need nothing from elsewhere, on a machine without a network too. They bring the font
along, as formulas come out badly where no font for them is installed.
"""

from __future__ import annotations

from importlib.resources import as_file, files
from pathlib import Path
from shutil import copyfile

from docutils import nodes
from latex2mathml.converter import convert
from sphinx.application import Sphinx
from sphinx.util.math import get_node_equation_number
from sphinx.writers.html5 import HTML5Translator

FONT = "STIXTwoMath-Regular.ttf"


def mathml(formula: str, display: str = "inline") -> str:
    """Return a formula as MathML. What stands over a letter is an accent, close to the letter."""
    return convert(formula, display=display).replace("<mover>", '<mover accent="true">')


def visit_inline(self: HTML5Translator, node: nodes.math) -> None:
    """Write a formula in a sentence."""
    self.body.append(mathml(node.astext()))
    raise nodes.SkipNode


def visit_block(self: HTML5Translator, node: nodes.math_block) -> None:
    """Write a formula on a line of its own, with its number if it has one."""
    self.body.append(self.starttag(node, "div", CLASS="equation"))
    self.body.append(mathml(node.astext(), "block"))
    if node["number"]:
        number = get_node_equation_number(self, node)
        self.body.append(f'<span class="eqno">({number})')
        self.add_permalink_ref(node, "Link to this equation")
        self.body.append("</span>")
    self.body.append("</div>")
    raise nodes.SkipNode


def copy_font(app: Sphinx) -> None:
    """Put the font beside the style sheet that names it."""
    folder = Path(app.outdir) / "_static"
    folder.mkdir(parents=True, exist_ok=True)
    with as_file(files("ziamath") / "fonts" / FONT) as font:
        copyfile(font, folder / FONT)


def setup(app: Sphinx) -> dict[str, bool]:
    """Offer MathML under its name."""
    app.add_html_math_renderer("mathml", (visit_inline, None), (visit_block, None))
    app.connect("builder-inited", copy_font)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
