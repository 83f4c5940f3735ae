"""Messages of a page: each gets an answer that is JSON, and a mistake gets a short one."""

from __future__ import annotations

import base64
import json

from hypothesis import strategies as st

from covey.web.game.choices import Choices
from covey.web.game.session import Session
from fuzz.mutation import damaged, edited
from fuzz.oracle import LONGEST_MESSAGE, require
from fuzz.records import RECORDS
from fuzz.records import TARGET as RECORD
from fuzz.target import Target

SOUND = (
    {"type": "new", "choices": {}},
    {"type": "new", "choices": {"evaders": 1, "sensing": "hidden", "start": "formation"}},
    {"type": "new", "choices": {"evaders": 2, "team": "straight-away", "seed": 7}},
    {"type": "new", "choices": {"evaders": 2, "team": "smallest-danger", "pursuer_speed": 2.0}},
    {"type": "new", "choices": {"evaders": 3, "team": "contingent", "turn_rate": 10.0}},
    {"type": "steer", "target": [0.3, -0.2]},
    {"type": "steer", "heading": 1.0},
    {"type": "steer", "target": [1e4, -1e4]},
    {"type": "steer"},
    {"type": "run", "pace": 2.0},
    {"type": "pause"},
    {"type": "step"},
    {"type": "film", "game": "yours"},
    {"type": "film", "game": "reference"},
    {"type": "save", "game": "yours"},
)
WORDS = sorted({key for message in SOUND for key in message} | Choices.model_fields.keys())


def check(content):
    """Play what a page sends: a JSON list of {"send": text}, {"upload": bytes}, {"wait": s}."""
    session, now, answers = Session(), 0.0, []
    for event in json.loads(content):
        if "wait" in event:
            now += event["wait"]
            replies = session.advance(now)
        elif "upload" in event:
            replies = session.receive(base64.b64decode(event["upload"]), now)
        else:
            replies = session.receive(event["send"], now)
        answers += [_answer(reply) for reply in replies if reply is not None]
    return "\n".join(answers)


def _answer(reply):
    if isinstance(reply, bytes):
        return "file"
    if isinstance(reply, str):
        return json.loads(reply)["type"]
    json.dumps(reply, allow_nan=False).encode()
    if reply["type"] == "error":
        text = reply["text"]
        require(len(text) <= LONGEST_MESSAGE, f"an error of {len(text)} characters: {text[:200]}")
        return text
    return reply["type"]


def _texts():
    sound = st.sampled_from(SOUND)
    edits = sound.flatmap(lambda message: edited(message, WORDS)).map(json.dumps)
    damage = sound.map(lambda message: json.dumps(message).encode()).flatmap(damaged)
    return st.one_of(
        sound.map(json.dumps), edits, damage.map(lambda text: text.decode("latin-1")), st.text()
    )


_SENT = _texts().map(lambda text: {"send": text})
_UPLOADED = (st.sampled_from(RECORDS) | RECORD.cases).map(
    lambda content: {"upload": base64.b64encode(content).decode()}
)
_WAITED = st.sampled_from((0.0, 1e-9, 1 / 60, 1.0, 1e9)).map(lambda seconds: {"wait": seconds})
_EVENTS = st.lists(st.one_of(_SENT, _SENT, _SENT, _WAITED, _UPLOADED), min_size=1, max_size=8)
TARGET = Target("page", ".json", _EVENTS.map(lambda events: json.dumps(events).encode()), check)
