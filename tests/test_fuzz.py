"""The fuzzer: its cases begin with what is sound, and a finding is told with its simplest case."""

from __future__ import annotations

import json
import sys
from dataclasses import replace

import pytest
from hypothesis import strategies as st

import covey
from fuzz import calls, page, records, results, scenarios, search, studies, watch
from fuzz.oracle import FindingError, refusal, require_game, require_plan
from fuzz.target import Target, corpus

CASES = [(name, file) for name in search.TARGETS for file in corpus(name)]
LEGAL = {
    "call": "plan",
    "team": {"positions": [[0.3, 0.1]], "headings": [0.0]},
    "disk": {},
    "with": {"starts": 1},
}
GAME = [
    {"send": '{"type": "new", "choices": {"evaders": 1}}'},
    {"wait": 0.1},
    {"send": '{"type": "step"}'},
]
SOUND = [
    *[(scenarios, file.read_bytes(), "played: TIME_LIMIT") for file in scenarios.FILES[:5]],
    *[(studies, file.read_bytes(), "set up") for file in studies.FILES[:4]],
    *[(records, content, "drawn") for content in records.RECORDS],
    (results, results.archive(results.FOLDER), "summed up, complete"),
    (page, json.dumps(GAME).encode(), "game\nreference\nframe"),
    (calls, json.dumps(LEGAL).encode(), "plan"),
]


@pytest.mark.parametrize(("name", "file"), CASES, ids=lambda part: getattr(part, "stem", part))
def test_a_case_of_the_corpus_keeps_what_is_promised(name, file):
    assert search.try_case(search.load(name), file.read_bytes())


# Not by their content: a zip file holds the time at which it was made.
@pytest.mark.parametrize(("module", "content", "answer"), SOUND, ids=map(str, range(len(SOUND))))
def test_what_cases_are_made_from_is_sound(module, content, answer):
    assert module.check(content) == answer


def fragile(content):
    if len(content) > 3:
        raise OverflowError("too long")
    return "short"


def test_a_search_ends_at_the_simplest_case_that_fails(monkeypatch, tmp_path):
    target = Target("scenarios", ".toml", st.binary(), fragile)
    monkeypatch.setattr(search, "load", lambda name: target)
    monkeypatch.setattr(search, "corpus", lambda name: [])
    assert search.main("scenarios", "1", "30", str(tmp_path)) == 1
    assert (tmp_path / "found").read_bytes() == bytes(4)
    assert "OverflowError: too long" in (tmp_path / "error").read_text()


def test_a_search_says_what_it_did(monkeypatch, tmp_path):
    target = Target("scenarios", ".toml", st.binary(max_size=3), fragile)
    monkeypatch.setattr(search, "load", lambda name: target)
    monkeypatch.setattr(search, "corpus", lambda name: [])
    assert search.main("scenarios", "1", "0.2", str(tmp_path)) == 0
    done = json.loads((tmp_path / "result.json").read_text())
    assert done["cases"] > 0
    assert done["new"] == ["short"]


@pytest.mark.parametrize(
    ("program", "told"),
    [
        ("import os; os.abort()", "the process ended with -6"),
        ("import time; time.sleep(60)", "no end after 0 s"),
    ],
)
def test_a_crash_and_a_hang_are_findings_too(program, told, monkeypatch, tmp_path, capsys):
    sleep = f"import pathlib; pathlib.Path('current').write_bytes(b'x'); {program}"
    worker = watch.Worker("page", [sys.executable, "-c", sleep], tmp_path / "page-0")
    monkeypatch.setattr(watch, "HANG_SECONDS", 0.4)
    monkeypatch.setattr(watch, "FINDINGS", tmp_path)
    assert watch.watch([worker], 1.0) == 1
    output = capsys.readouterr().out
    assert told in output
    (file,) = tmp_path.glob("page-*.json")
    assert file.read_bytes() == b"x"
    assert f"make fuzz CASE={file}" in output


def test_a_long_message_is_a_finding():
    with pytest.raises(FindingError, match="a message of 5000 characters"):
        refusal(ValueError("x" * 5000))


def test_a_broken_promise_is_a_finding():
    team, disk = covey.Team([[0.3, 0.1]], [0.0]), covey.PursuerDisk()
    plan = covey.plan(team, disk, starts=1)
    with pytest.raises(FindingError, match="guaranteed again"):
        require_plan(team, disk, replace(plan, survival_time=1.001 * plan.survival_time))
    game = covey.simulate(team, disk)
    with pytest.raises(FindingError, match="game: guarantee"):
        require_game(replace(game, guarantee=1.001 * game.survival_time))
