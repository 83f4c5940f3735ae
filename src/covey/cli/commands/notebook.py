"""`covey notebook`: a notebook, run and shown in the browser."""

from __future__ import annotations

import webbrowser
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from covey.cli.shared.outputs import check_output, write_text


def notebook(
    file: Annotated[
        Path | None,
        Parameter(name="FILE", help="The notebook; by default the first one, which is written."),
    ] = None,
    /,
    *,
    browser: Annotated[bool, Parameter(help="Open the page in the browser.")] = True,
) -> None:
    """Run a notebook, and show it in the browser. Nothing but covey is needed.

    Without FILE, first_notebook.ipynb is written to the working folder, unless a file of that name
    is there. All cells are run, and the page is written beside the notebook. Any editor of
    notebooks changes the cells: Jupyter, VS Code. Give the command again to run them anew.

    Try:

        covey notebook
        covey notebook mine.ipynb
    """
    # Only now, as it loads what reads Markdown.
    from covey.cli.show.notebook import FIRST, run_notebook

    chosen = Path(FIRST.name) if file is None else file
    page = chosen.with_suffix(".html")
    check_output(page, [".html"], "a page")
    if file is None and not chosen.exists():
        write_text(chosen, FIRST.read_text(encoding="utf-8"))
    write_text(page, run_notebook(chosen))
    if browser:
        webbrowser.open(page.resolve().as_uri())
