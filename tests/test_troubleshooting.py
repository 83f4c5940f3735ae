"""Every error message is on the page of troubleshooting, which is made from the source."""

from __future__ import annotations

import ast
import importlib.util
import re
from functools import partial
from pathlib import Path

import pytest

import covey
from covey.cli import main

EXTENSION = Path(__file__).parents[1] / "docs" / "_ext" / "found_messages.py"

JOINED = {
    "envs/vector.py",  # of `_not_compiled`, which the page has
    "scenarios/mistakes.py",  # of mistakes, each of which the page has
    "studies/running/manifest.py",  # of differences
    "cli/commands/instances.py",  # of numbers that don't hold
    "web/game/messages.py",  # of mistakes of a message
}
"""Files in which a message is put together from others."""


@pytest.fixture(scope="module")
def found():
    """The module that finds messages; it needs nothing that builds pages."""
    spec = importlib.util.spec_from_file_location("found_messages", EXTENSION)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_no_error_of_a_user_is_left_out(found):
    without_words = set()
    for file in found.SOURCE.rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.Call) and ast.unparse(node.func).endswith("InputError"):
                text = found.text_of(node.args[0])
                if not text.strip("… :;\n"):
                    without_words.add(file.relative_to(found.SOURCE).as_posix())
    assert without_words == JOINED


TEAM, DISK = covey.Team([[0.3, 0.1]], 0.0), covey.PursuerDisk()
CALLS = {
    "a unit": partial(covey.Team, [[0.3, 0.1]], 0.0, unit="two words"),
    "two units": partial(
        covey.plan, covey.Team([[0.3, 0.1]], 0.0, unit="m"), covey.PursuerDisk(unit="km")
    ),
    "both": partial(covey.Team, [[0.3, 0.1]], 0.0, turn_rates=1.0, turn_radii=1.0),
    "too fast": partial(covey.plan, covey.Team([[0.3, 0.1]], 0.0, 2.0), DISK),
    "a sequence": partial(covey.capture_times, TEAM, DISK, [0.0], [1]),
    "a name": partial(covey.simulate, TEAM, DISK, pursuer="comitted"),
    "a scenario": partial(covey.load_scenario, "fig33"),
    "a study": partial(covey.Study, starts=0),
    "results": partial(covey.load_study, "nowhere"),
    "a record": partial(covey.load_game, __file__),
    "a picture": partial(covey.draw, 3),
    "its width": partial(covey.draw, covey.plan(TEAM, DISK), width="wide"),
}
COMMANDS = {
    "draw fig3 -o game.txt": "expected a name that ends in",
    "draw fig3 --view plan --times 1 -o p.png": "expected the view snapshots",
    "chase --port 70000": "expected a whole number from 0 to 65535",
    "new mine.json": "for a scenario",
}


def is_on_the_page(found, told):
    """Whether a message has the words of one on the page, values aside, and enough of them."""
    for _, text in found.messages():
        words = re.split(r"<\w+>|…", text)
        if max(map(len, words)) >= 12 and re.search(".*?".join(map(re.escape, words)), told, re.S):
            return True
    return False


@pytest.mark.parametrize("name", CALLS)
def test_what_a_call_tells_is_on_the_page(name, found):
    with pytest.raises(covey.InputError) as caught:
        CALLS[name]()
    assert is_on_the_page(found, str(caught.value)), str(caught.value)


@pytest.mark.parametrize("words", COMMANDS)
def test_what_a_command_tells_is_on_the_page(words, found, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(words.split()) == 2
    told = capsys.readouterr().err
    assert COMMANDS[words] in told
    assert is_on_the_page(found, told), told


def test_words_that_are_not_on_the_page_are_not_found_there(found):
    assert not is_on_the_page(found, "expected something that no message says")
