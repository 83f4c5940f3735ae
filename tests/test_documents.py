"""The programs in the documents run, and the commands exist as they are told."""

from __future__ import annotations

import re
import shlex
import tomllib
from pathlib import Path

import pytest

from covey.cli import main
from covey.cli.app import app
from covey.studies import read_study

ROOT = Path(__file__).parents[1]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]
PAGES = [page for page in PAGES if "generated" not in page.parts]
RUN_ELSEWHERE = {"README.md", "learning.md"}
"""Pages whose programs `test_readme` and `envs/test_documents` run."""
HISTORY = ROOT / "docs" / "decisions"
"""Programs there show what went wrong: one ends Python itself. They are compiled, and not run."""

CHECKED_HERE = {"python", "sh", "toml"}
RUN_BY_MAKE_DOCS = {"{code-cell}", "{shell}", "{file}", "{result}", "{eval-rst}"}
SHOWN = {"", "text", "console", "markdown"}
"""What programs print, drawings and formulas: nothing there can be run."""

LONG = {"study", "reproduce", "yardstick", "chase"}
"""Commands whose small form `docs/reference/commands.md` shows, and `make docs` runs."""

SHORTER = {"starts=100": "starts=1"}
"""What makes a long program a short one."""


def blocks(page, language):
    """The blocks of a page in a language."""
    return re.findall(
        rf"^```{language}\n(.*?)^```", page.read_text("utf-8"), re.DOTALL | re.MULTILINE
    )


def relative(path):
    return str(path.relative_to(ROOT))


def test_every_block_is_of_a_kind_that_is_run_or_shown():
    kinds = {
        kind
        for page in PAGES
        for kind in re.findall(r"^```+ *(\S*).*\n(?:.*\n)*?```+$", page.read_text("utf-8"), re.M)
    }
    structure = {kind for kind in kinds if kind.startswith("{")} - RUN_BY_MAKE_DOCS
    assert structure <= {
        *("{include}", "{literalinclude}", "{toctree}", "{image}"),
        *("{keys}", "{names}", "{messages}"),
    }
    assert kinds - structure - RUN_BY_MAKE_DOCS <= CHECKED_HERE | SHOWN


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


@pytest.mark.parametrize("page", sorted(HISTORY.glob("*.md")), ids=relative)
def test_a_program_of_a_decision_is_python(page):
    for program in blocks(page, "python"):
        compile(program, page.name, "exec")


@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page, "toml")], ids=relative)
def test_what_is_shown_of_a_file_is_toml(page):
    for text in blocks(page, "toml"):
        tomllib.loads(text)


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


def quick(page):
    """The commands of a page that end soon, and need no results of a longer one."""
    lines = [line for block in blocks(page, "sh") for line in block.splitlines()]
    words = [shlex.split(line, comments=True) for line in lines]
    own = [each[1:] for each in words if each[:1] == ["covey"]]
    kept = [each for each in own if each[0] not in LONG and not each[0].startswith("--")]
    return [each for each in kept if not any(needs_more(word) for word in each)]


def needs_more(word):
    """Whether a command with this word needs results, a module, or minutes."""
    return word.startswith(("results/", "my_module")) or word == "--check"


@pytest.mark.parametrize("page", [page for page in PAGES if quick(page)], ids=relative)
def test_the_quick_commands_of_a_page_run_one_after_the_other(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("webbrowser.open", lambda address: True)
    for words in quick(page):
        end = words.index(">") if ">" in words else len(words)
        assert main(words[:end]) == 0, words


@pytest.mark.parametrize("page", [page for page in PAGES if typed(page, "python")], ids=relative)
def test_every_program_that_is_called_by_name_exists(page):
    for _, first, *rest in typed(page, "python"):
        path = rest[0].replace(".", "/") if first == "-m" else first
        assert any(
            (root / f"{path}{end}").exists() for root in (ROOT, ROOT / "src") for end in ("", ".py")
        )


@pytest.mark.parametrize("page", [page for page in PAGES if typed(page, "make")], ids=relative)
def test_every_target_of_make_exists(page):
    targets = re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text("utf-8"), re.MULTILINE)
    assert {words[1] for words in typed(page, "make")} <= set(targets)


def test_the_study_that_is_shown_can_be_read(tmp_path):
    (text,) = blocks(ROOT / "docs" / "how-to" / "studies.md", "toml")
    (tmp_path / "turning.toml").write_text(text)
    assert read_study(tmp_path / "turning.toml").starts == 200
