"""A page's session: what it answers, and that a mistake changes nothing."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import covey
from covey.simulation.storage import read_game
from covey.web import upload
from covey.web.game_json import MAX_FRAMES
from covey.web.messages import MOST_CHARACTERS
from covey.web.session import Session
from web.chase_pages import aim


class Page:
    """Speaks to a session without a socket; its clock is set by hand."""

    def __init__(self, **choices):
        self.session, self.now = Session(), 0.0
        self.game = self.reference = None
        if choices:
            (self.game,) = self.ask(type="new", choices=choices)
            (self.reference,) = self.wait(0.0)

    def ask(self, **message):
        return self.send(json.dumps(message))

    def send(self, content):
        return self.heard(self.session.receive(content, self.now))

    def wait(self, seconds):
        self.now += seconds
        return self.heard(self.session.advance(self.now))

    @staticmethod
    def heard(replies):
        """The messages, without the moments at which others may have a turn."""
        messages = [reply for reply in replies if reply is not None]
        return [json.loads(each) if isinstance(each, str) else each for each in messages]

    def play(self, pace=1.0):
        """Chase to the end; return the score."""
        self.ask(type="run", pace=pace)
        while True:
            frame, *rest = self.wait(1 / 60) or [None]
            if rest:
                return rest[0]
            if frame:
                self.ask(type="steer", target=aim(frame, self.game["cast"]))

    def error(self, content):
        (reply,) = self.send(content)
        assert reply["type"] == "error"
        return reply["text"]


def test_a_game_is_set_up_with_its_plan_and_the_reference_game_follows():
    page = Page(evaders=4, seed=6)
    assert page.game["type"] == "game"
    assert page.game["picture"]["time"] == 0.0
    assert sorted(page.game["picture"]["sequence"]) == [0, 1, 2, 3]
    # The first plan: its last expected capture is what is guaranteed.
    assert page.game["picture"]["expected"][-1] == pytest.approx(page.game["cast"]["guarantee"])
    assert page.reference["survival_time"] >= page.game["cast"]["guarantee"] - 1e-9
    assert page.wait(1.0) == []  # nothing runs before it is asked to


@pytest.mark.parametrize("pace", [0.25, 1.0, 2.0])
def test_the_game_runs_at_its_pace(pace):
    page = Page(evaders=2, seed=1, capture_radius=0.01)
    page.ask(type="run", pace=pace)
    frames = [frame for _ in range(20) for frame in page.wait(1 / 60) if frame["type"] == "frame"]
    assert frames[-1]["time"] == pytest.approx(pace * 20 / 60, abs=0.006)
    assert frames[-1]["rate"] == pytest.approx(pace / 0.005, rel=0.15)


def test_a_machine_that_is_too_slow_plays_slower_and_says_so():
    page = Page(evaders=2, seed=1, capture_radius=0.01)
    page.ask(type="run", pace=1.0)
    frames = [frame for _ in range(20) for frame in page.wait(0.1)]
    assert frames[-1]["time"] == pytest.approx(20 / 30, abs=0.01)
    assert frames[-1]["rate"] == pytest.approx(200 / 3, rel=0.1)


def test_pause_and_step():
    page = Page(evaders=2, seed=1)
    page.ask(type="run", pace=1.0)
    page.wait(1 / 60)
    page.ask(type="pause")
    assert page.wait(1.0) == []
    (frame,) = page.ask(type="step")
    assert frame["time"] == pytest.approx(0.015 + 0.05)
    assert page.wait(1.0) == []


def test_between_two_updates_others_may_have_a_turn():
    page = Page(evaders=2, seed=1, capture_radius=0.01)
    page.ask(type="run", pace=1.0)
    assert [reply and reply["type"] for reply in page.session.advance(0.0151)] == [
        *[None] * 3,
        "frame",
    ]
    step = page.session.receive('{"type": "step"}', 0.02)
    assert [reply and reply["type"] for reply in step] == [*[None] * 10, "frame"]


def test_a_new_game_stands_still_although_the_last_one_ran():
    page = Page(evaders=2, seed=1)
    page.ask(type="run", pace=1.0)
    page.wait(1 / 60)
    page.ask(type="new", choices={"evaders": 2, "seed": 2})
    assert [reply["type"] for reply in page.wait(1.0)] == ["reference"]
    assert page.wait(1.0) == []


def test_played_to_the_end_it_is_scored_saved_and_shown():
    page = Page(evaders=3, seed=8, sensing="hidden")
    assert "isn't over" in page.error('{"type": "save", "game": "yours"}')
    score = page.play()
    assert score["type"] == "over"
    assert score["share"] == pytest.approx(page.reference["survival_time"] / score["time"])
    (content,) = page.ask(type="save", game="yours")
    record = read_game(content, "saved")
    assert record.survival_time == score["time"]
    (film,) = page.ask(type="film", game="yours")
    assert film["survival_time"] == score["time"]
    assert film["pictures"][0] == page.game["picture"]
    assert [i for i, _ in film["pictures"][-1]["captured"]] == record.capture_sequence.tolist()
    assert page.ask(type="run") == []
    assert page.wait(1.0) == []  # over is over


def test_the_reference_game_is_there_from_the_start():
    page = Page(evaders=3, seed=8)
    (content,) = page.ask(type="save", game="reference")
    record = read_game(content, "saved")
    assert record.strategies["pursuer"]["name"] == "committed"
    assert record.survival_time == page.reference["survival_time"]
    (film,) = page.ask(type="film", game="reference")
    assert film["pictures"][-1]["time"] == record.survival_time


def test_a_record_goes_out_and_comes_in_unchanged(tmp_path):
    page = Page(evaders=3, seed=8, sensing="hidden")
    page.play()
    (content,) = page.ask(type="save", game="yours")
    (mine,) = page.ask(type="film", game="yours")
    (opened,) = page.send(content)
    assert opened == {**mine, "game": "opened"}
    path = tmp_path / "game.parquet"
    path.write_bytes(content)
    assert covey.load_game(path).survival_time == mine["survival_time"]


def test_a_record_of_simulate_is_shown(tmp_path):
    team = covey.Team([[300.0, 0.0], [0.0, -400.0]], [0.0, 1.0], 2.5, [math.inf, 0.001])
    game = covey.simulate(team, covey.PursuerDisk(speed=10.0), update_time=0.01)
    assert len(game.times) > MAX_FRAMES
    path = tmp_path / "game.parquet"
    covey.save_game(game, path)
    page = Page()
    (film,) = page.send(path.read_bytes())
    json.dumps(film, allow_nan=False)
    assert film["cast"]["turn_rates"] == [None, 0.001]
    assert len(film["pictures"]) <= MAX_FRAMES + 4
    times = [picture["time"] for picture in film["pictures"]]
    assert times == sorted(times)
    for i, when in zip(game.capture_sequence, game.capture_times, strict=True):
        after = next(p for p in film["pictures"] if [i, when] in p["captured"])
        assert after["time"] == when


def test_what_is_no_record_is_refused(tmp_path, monkeypatch):
    page = Page()
    assert "isn't Parquet" in page.error(b"no record")
    assert "damaged" in page.error(b"PAR1" + bytes(100))
    path = tmp_path / "game.parquet"
    team = covey.Team([[0.3, 0.0]], [0.0])
    covey.save_game(covey.simulate(team, covey.PursuerDisk()), path)
    content = path.read_bytes()
    assert "damaged" in page.error(content[: len(content) // 2])
    assert "damaged" in page.error(content.replace(b"time", b"\x80ime"))  # not UTF-8
    monkeypatch.setattr(upload, "MOST_NUMBERS", 10)
    assert "at most 10 numbers" in page.error(content)
    monkeypatch.setattr(upload, "MOST_BYTES", 10)
    assert "at most 10 bytes" in page.error(content)


@pytest.mark.parametrize(
    "column",
    [
        pa.array(["x" * 10**6] * 5),
        pa.array([b"x" * 10**6] * 5),
        pa.array([[1.0] * 10**6] * 5),
        pa.array([b"x" * 1000] * 5, pa.binary(1000)),
    ],
)
def test_a_small_file_with_a_huge_entry_is_refused_unread(column, tmp_path, monkeypatch):
    pq.write_table(pa.table({"time": column}), tmp_path / "bomb.parquet", compression="zstd")
    monkeypatch.setattr(upload, "read_game", None)
    assert "one number a row" in Page().error((tmp_path / "bomb.parquet").read_bytes())


@pytest.mark.parametrize(
    "forged",
    [
        {"guarantee": math.nan},
        {"guarantees": np.full(3, np.inf)},
        {"critical_sequences": np.full((3, 1), 7)},
        {"evader_positions": np.full((3, 1, 2), np.nan)},
        {"pursuer_positions": np.full((3, 2), np.nan)},
        {"strategies": {"evaders": {"name": "x"}, "pursuer": 3}},
        {"disk_radii": np.full(3, -1.0)},
    ],
)
def test_a_record_that_contradicts_itself_is_refused(tmp_path, forged):
    team = covey.Team([[0.015, 0.0]], [0.0])
    game = covey.simulate(team, covey.PursuerDisk())
    assert len(game.times) == 3
    path = tmp_path / "game.parquet"
    covey.save_game(replace(game, **forged), path)
    assert "record: it contradicts itself" in Page().error(path.read_bytes())


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("", "message"),
        ("{", "message"),
        ("[]", "message"),
        ("{}", "message"),
        ('{"type": "cheat"}', "message"),
        ('{"type": "steer", "target": [1e9, 0]}', "target.0"),
        ('{"type": "steer", "target": [0]}', "target.1"),
        ('{"type": "steer", "target": [NaN, 0]}', "target.0"),
        ('{"type": "steer", "heading": "north"}', "heading"),
        ('{"type": "steer", "heading": 1e300}', "heading"),
        ('{"type": "run", "pace": 50}', "pace"),
        ('{"type": "run", "pace": 0}', "pace"),
        ('{"type": "new", "choices": {"evaders": 1000}}', "choices.evaders"),
        ('{"type": "new", "choices": {"start": "fig3", "evaders": 4}}', "has 5 evaders"),
        ('{"type": "new"}', "choices"),
        ('{"type": "save", "game": "../../etc/passwd"}', "game"),
        ('{"type": "pause", "more": 1}', "more"),
        ("[" * 1500, "message"),
        ('{"type": "steer", "target": ' + "[" * 900 + "]" * 900 + "}", "recursion limit"),
        ('{"type": "new", "choices": ' + '{"evaders": ' * 150 + "1" + "}" * 151, "choices.evaders"),
        ('{"type": "new", "choices": {"seed": ' + "9" * 1900 + "}}", "choices.seed"),
        ('{"type": "new", "choices": {"seed": 1e999}}', "choices.seed"),
        ('{"type": "new", "choices": {"speed": Infinity}}', "choices.speed"),
        ('{"type": "new", "choices": {"speed": -NaN}}', "message"),
        ('{"type": "run", "pace": ' + "9" * 1900 + "}", "pace"),
        ('{"type": "run", "pace": {"a": 1}}', "pace"),
        ('{"type": "steer", "type": "cheat"}', "message"),
        ('{"type": ["steer"]}', "message"),
        ('{"type": null}', "message"),
        ('{"type": "\\ud800"}', "message"),
        ('"steer"', "message"),
        ("null", "message"),
        ("1e9", "message"),
        ("\0", "message"),
        ('{"type": "pause"} {"type": "pause"}', "message"),
        ("x" * (MOST_CHARACTERS + 1), f"at most {MOST_CHARACTERS}"),
    ],
)
def test_a_bad_message_is_answered_and_the_game_goes_on(content, said):
    page = Page(evaders=1, seed=1)
    page.ask(type="run")
    assert said in page.error(content)
    (frame,) = page.wait(1 / 60)
    assert frame["time"] == pytest.approx(0.015)


def test_a_page_without_a_game_is_told_so():
    for message in (
        {"type": "steer"},
        {"type": "run"},
        {"type": "pause"},
        {"type": "step"},
        {"type": "film", "game": "yours"},
        {"type": "save", "game": "reference"},
    ):
        page = Page()
        assert "no game yet" in page.error(json.dumps(message))
        assert not page.session.busy
        assert page.wait(1.0) == []


def test_of_many_mistakes_ten_are_told():
    keys = {f"k{k}": 0 for k in range(150)}
    said = Page().error(json.dumps({"type": "pause", **keys}))
    assert said.count("k") == 10
    assert said.endswith("; and 140 more")


NUMBERS = st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5)
VALUES = st.recursive(NUMBERS, lambda inner: st.lists(inner, max_size=3), max_leaves=5)
MESSAGES = st.one_of(
    st.builds(
        dict,
        type=st.sampled_from(["new", "steer", "run", "pause", "step", "film", "save", "cheat"]),
        choices=st.fixed_dictionaries(
            {"evaders": st.just(1)}, optional={"seed": VALUES, "speed": VALUES, "team": VALUES}
        ),
    ),
    st.fixed_dictionaries(
        {"type": st.just("steer")}, optional={"target": VALUES, "heading": VALUES}
    ),
    st.fixed_dictionaries({"type": st.just("run")}, optional={"pace": VALUES}),
    st.fixed_dictionaries({"type": st.sampled_from(["pause", "step"])}),
    st.fixed_dictionaries(
        {"type": st.sampled_from(["film", "save"]), "game": st.sampled_from(["yours", "reference"])}
    ),
    st.just({"type": "new", "choices": {"evaders": 1, "capture_radius": 0.1}}),
)
SENT = st.one_of(MESSAGES.map(json.dumps), st.text(max_size=50), st.binary(max_size=50))


@settings(max_examples=100)
@given(st.lists(SENT, max_size=12))
def test_any_messages_in_any_order_are_answered(sent):
    page = Page()
    for content in sent:
        for reply in page.send(content) + page.wait(1 / 60):
            if isinstance(reply, dict):
                json.dumps(reply, allow_nan=False)
                assert reply["type"] in {"game", "reference", "frame", "over", "film", "error"}
    (game,) = page.ask(type="new", choices={"evaders": 1, "seed": 1})
    assert game["type"] == "game"


def test_expected_captures_are_those_of_algorithm_1():
    page = Page(evaders=4, seed=2)
    team, disk = covey.web.choices.Choices(evaders=4, seed=2).game()
    plan = covey.plan(team, disk, seed=2)
    picture = page.game["picture"]
    times = covey.capture_times(team, disk, plan.turns, picture["sequence"])
    assert np.array(picture["expected"]) == pytest.approx(times, rel=1e-12)
