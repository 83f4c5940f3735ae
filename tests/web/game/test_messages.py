"""Messages of a page: a mistake is answered and changes nothing."""

from __future__ import annotations

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from covey.web.game.messages import MOST_CHARACTERS
from web.session_pages import Page


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
