"""The programs in the documents run, and the commands exist as they are told."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from covey.cli.app import app
from covey.studies import read_study

ROOT = Path(__file__).parents[1]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]
PAGES = [page for page in PAGES if "generated" not in page.parts]
RUN_ELSEWHERE = {"README.md", "learning.md"}
"""Pages whose programs `test_readme` and `envs/test_documents` run."""
HISTORY = ROOT / "docs" / "decisions"
"""Programs there show what went wrong."""

SHORTER = {"starts=100": "starts=1"}
"""What makes a long program a short one."""


def blocks(page, language):
    """The blocks of a page in a language."""
    return re.findall(
        rf"^```{language}\n(.*?)^```", page.read_text("utf-8"), re.DOTALL | re.MULTILINE
    )


def relative(path):
    return str(path.relative_to(ROOT))


WITH_PROGRAMS = [
    page
    for page in PAGES
    if blocks(page, "python") and page.name not in RUN_ELSEWHERE and page.parent != HISTORY
]


@pytest.mark.parametrize("page", WITH_PROGRAMS, ids=relative)
def test_the_programs_of_a_page_run_one_after_the_other(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    program = "\n".join(blocks(page, "python"))
    for long, short in SHORTER.items():
        program = program.replace(long, short)
    exec(compile(program, page.name, "exec"), {})


def typed(page, program):
    """The command lines of a page that call a program, each as its words."""
    lines = "".join(blocks(page, "sh") + blocks(page, r"\{shell\}")).splitlines()
    words = (shlex.split(line, comments=True) for line in lines)
    return [each for each in words if each and Path(each[0]).name == program]


@pytest.mark.parametrize("page", [page for page in PAGES if typed(page, "covey")], ids=relative)
def test_every_command_of_a_page_exists_with_its_options(page):
    for _, *words in typed(page, "covey"):
        end = next((words.index(each) for each in words if each in {">", "&&", "&"}), len(words))
        app.parse_args(words[:end], exit_on_error=False, print_error=False)


@pytest.mark.parametrize("page", [page for page in PAGES if typed(page, "make")], ids=relative)
def test_every_target_of_make_exists(page):
    targets = re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text("utf-8"), re.MULTILINE)
    assert {words[1] for words in typed(page, "make")} <= set(targets)


def test_the_study_that_is_shown_can_be_read(tmp_path):
    (text,) = blocks(ROOT / "docs" / "how-to" / "studies.md", "toml")
    (tmp_path / "turning.toml").write_text(text)
    assert read_study(tmp_path / "turning.toml").starts == 200
