"""Notebooks that are run without Jupyter, and shown in a browser."""

from __future__ import annotations

import json
import re
import webbrowser
from pathlib import Path

import pytest

from covey.cli import main


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def write(*sources, name="mine.ipynb", kind="code"):
    cells = [{"cell_type": kind, "source": source.splitlines(keepends=True)} for source in sources]
    Path(name).write_text(json.dumps({"cells": cells}))


def page(name="mine"):
    return Path(f"{name}.html").read_text("utf-8")


def test_the_first_notebook_is_written_run_and_opened(monkeypatch, capsys):
    opened = []
    monkeypatch.setattr(webbrowser, "open", opened.append)
    assert main(["notebook"]) == 0
    assert capsys.readouterr().err == "saved first_notebook.ipynb\nsaved first_notebook.html\n"
    assert opened == [Path("first_notebook.html").resolve().as_uri()]
    shown = page("first_notebook")
    assert "<h1>A first notebook</h1>" in shown
    assert re.search(r"<pre>guaranteed 5\.\d+\n</pre>", shown)
    assert shown.count('src="data:image/png') == 2
    assert re.search(r"<(img|video)[^>]*>|<source", shown.rpartition("covey.animate")[2])


def test_cells_are_run_in_order_and_show_what_they_print_and_their_last_value():
    write("a = 6\nprint('a < 7')", "a * 7", "a = 1;", "a\n")
    assert main(["notebook", "mine.ipynb", "--no-browser"]) == 0
    results = re.findall("<pre>(.*?)</pre>", page(), re.DOTALL)
    assert results == ["a &lt; 7\n", "42", "1"]


def test_values_are_shown_by_their_tables_and_pictures():
    write(
        "import covey\ncovey.PursuerDisk(unit='m')",
        "covey.draw(covey.load_scenario('fig3').plan())",
    )
    assert main(["notebook", "mine.ipynb", "--no-browser"]) == 0
    assert "<th>radius (m)</th>" in page()
    assert page().count("<img ") == 1


def test_a_notebook_that_is_there_is_left_as_it_is():
    write("'mine'", name="first_notebook.ipynb")
    assert main(["notebook", "--no-browser"]) == 0
    assert "mine" in page("first_notebook")


def test_a_cell_that_fails_is_told(capsys):
    write("1", "1 / 0")
    assert main(["notebook", "mine.ipynb", "--no-browser"]) == 2
    told = "covey: mine.ipynb: cell 2 failed: ZeroDivisionError: division by zero\n"
    assert capsys.readouterr().err == told
    assert not Path("mine.html").exists()


@pytest.mark.parametrize("content", ["print(1)", "[]", '{"cells": [3]}', '{"nothing": 1}'])
def test_what_is_no_notebook_is_told(content, capsys):
    Path("mine.ipynb").write_text(content)
    assert main(["notebook", "mine.ipynb", "--no-browser"]) == 2
    assert "mine.ipynb: expected a notebook of Jupyter, got " in capsys.readouterr().err


def test_a_notebook_that_is_missing_is_told(capsys):
    assert main(["notebook", "none.ipynb", "--no-browser"]) == 2
    assert "none.ipynb: No such file or directory" in capsys.readouterr().err
