"""Runs the commands of a page when the page is built, and shows what they print.

A page has a folder of its own. `file` writes and shows a file there. `shell` runs commands there.
`result` shows a picture or film that a command has left there. A command that fails is an error.
"""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
from pathlib import Path
from shutil import copyfile, rmtree
from typing import Any, ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

ENVIRONMENT = {"COLUMNS": "80", "NO_COLOR": "1", "TERM": "dumb"}
"""Output is the same on every machine."""


class PageDirective(SphinxDirective):
    """What the directives of this file share."""

    @property
    def folder(self) -> Path:
        """The folder of this page."""
        folder = Path(self.env.app.doctreedir) / "shell" / self.env.docname
        folder.mkdir(parents=True, exist_ok=True)
        return folder

    def shown(self, text: str, language: str) -> nodes.literal_block:
        """Return a block of text."""
        block = nodes.literal_block(text, text, language=language)
        self.set_source_info(block)
        return block


class File(PageDirective):
    """A file that the reader writes; its name is the argument."""

    has_content = True
    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Write the file and show it."""
        text = "\n".join(self.content)
        (self.folder / self.arguments[0]).write_text(text + "\n", encoding="utf-8")
        return [self.shown(text, Path(self.arguments[0]).suffix.removeprefix("."))]


class Shell(PageDirective):
    """Commands, one a line.

    `:status:` is the exit status of each, by default 0. `:first:` is how many lines are shown.
    """

    has_content = True
    option_spec: ClassVar = {
        "status": directives.nonnegative_int,
        "first": directives.positive_int,
    }

    def run(self) -> list[nodes.Node]:
        """Run the commands and show what they print."""
        shown: list[str] = []
        for line in self.content:
            shown += [f"$ {line}", *self._printed(line)]
        # In a console a line that begins with # would be a prompt.
        language = "text" if any(line.startswith("#") for line in shown) else "console"
        return [self.shown("\n".join(shown), language)]

    def _printed(self, line: str) -> list[str]:
        words = shlex.split(line, comments=True)
        program = [sys.executable, "-m", "covey"] if words[0] == "covey" else words[:1]
        done = subprocess.run(
            [*program, *words[1:]],
            cwd=self.folder,
            env=os.environ | ENVIRONMENT,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            check=False,
        )
        if done.returncode != self.options.get("status", 0):
            raise self.error(f"{line}: exit status {done.returncode}\n{done.stdout}")
        told = done.stdout.replace(str(Path.home() / ".cache"), "~/.cache")
        printed = [each.rstrip() for each in told.splitlines()]
        first = self.options.get("first", len(printed))
        return printed[:first] + ["..."] * (first < len(printed))


class Result(PageDirective):
    """A picture or film from the page's folder; the text is its description."""

    has_content = True
    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Copy the file to where Sphinx finds it, and show it."""
        name = self.env.docname.replace("/", "-") + "-" + self.arguments[0]
        target = Path(self.env.srcdir) / "generated" / "results" / name
        target.parent.mkdir(parents=True, exist_ok=True)
        copyfile(self.folder / self.arguments[0], target)
        uri = f"/generated/results/{name}"
        return [nodes.image(uri=uri, alt=" ".join(self.content))]


def forget(app: Sphinx, _env: Any, docname: str) -> None:
    """Empty the folder of a page before the page is read."""
    rmtree(Path(app.doctreedir) / "shell" / docname, ignore_errors=True)


def setup(app: Sphinx) -> dict[str, bool]:
    """Offer the directives."""
    app.add_directive("file", File)
    app.add_directive("shell", Shell)
    app.add_directive("result", Result)
    app.connect("env-purge-doc", forget)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
