"""What a connection lets through to its session, on a clock that is set by hand."""

from __future__ import annotations

import asyncio
import json
import threading
import time
from types import SimpleNamespace

import pytest
from starlette.websockets import WebSocketDisconnect

from covey.web import connection
from covey.web.messages import is_quick
from covey.web.rate_limit import TokenBucket

TEXT, FILE = {"text": "x"}, {"bytes": b"x"}


class Sender:
    """A socket that has `count` messages, `interval` seconds apart, and then is closed."""

    def __init__(self, content, count, interval):
        self.content, self.left, self.interval = content, count, interval
        self.now, self.told = 0.0, []

    def monotonic(self):
        return self.now

    async def receive(self):
        if not self.left:
            return {"type": "websocket.disconnect"}
        self.left -= 1
        self.now += self.interval
        return {"type": "websocket.receive", **self.content}

    async def send_text(self, text):
        self.told.append(text)


async def answer(inbox):
    """Answer what comes, at once; return how much that was."""
    count = 0
    try:
        while True:
            await inbox.get()
            inbox.task_done()
            count += 1
    except asyncio.CancelledError:
        return count


async def passed(sender):
    """How many of its messages are answered."""
    inbox = asyncio.Queue(1)
    answers = asyncio.create_task(answer(inbox))
    with pytest.raises(WebSocketDisconnect):
        await connection._read(sender, inbox)
    await inbox.join()
    answers.cancel()
    return await answers


@pytest.mark.parametrize(("content", "cost"), [(TEXT, 1), (FILE, 60)])
def test_of_40_000_messages_in_two_seconds_the_budget_decides(content, cost, monkeypatch):
    sender = Sender(content, 40_000, 2.0 / 40_000)
    monkeypatch.setattr(connection, "time", SimpleNamespace(monotonic=sender.monotonic))
    monkeypatch.setattr(connection, "_REFUSAL", 0.0)
    at_once, per_second = 240, 120
    expected = (at_once + 2 * per_second) / cost
    assert asyncio.run(passed(sender)) == pytest.approx(expected, abs=1)
    assert len(sender.told) == 2  # once a second
    assert "at most 120 messages a second" in sender.told[0]


def test_who_keeps_to_the_limit_is_never_refused(monkeypatch):
    sender = Sender(TEXT, 5000, 1.0 / 119.0)
    monkeypatch.setattr(connection, "time", SimpleNamespace(monotonic=sender.monotonic))
    assert asyncio.run(passed(sender)) == 5000
    assert sender.told == []


def test_after_a_refusal_nothing_is_read_for_a_while():
    async def refuse():
        sender = Sender(TEXT, 1000, 0.0)
        reading = asyncio.create_task(connection._read(sender, asyncio.Queue()))
        while sender.left > 1000 - 240:
            await asyncio.sleep(0)
        for _ in range(20):
            await asyncio.sleep(0)
        reading.cancel()
        return sender.left

    assert asyncio.run(refuse()) >= 1000 - 240 - 5  # 740 would be gone at once


def test_a_file_is_answered_before_more_is_read():
    """Files are large, and 64 messages may wait."""

    async def send_files():
        sender, inbox = Sender(FILE, 3, 0.0), asyncio.Queue(64)
        reading = asyncio.create_task(connection._read(sender, inbox))
        for left in (2, 1, 0):
            for _ in range(20):
                await asyncio.sleep(0)
            assert (sender.left, inbox.qsize()) == (left, 1)
            await inbox.get()
            inbox.task_done()
        with pytest.raises(WebSocketDisconnect):
            await reading

    asyncio.run(send_files())


@pytest.mark.parametrize(
    ("message", "quick"),
    [
        ('{"type": "steer", "heading": 1.0}', True),
        ('{"type": "run"}', True),
        ('{"type": "pause"}', True),
        ('{"type": "step"}', True),
        ("nonsense", True),
        ('{"type": "new", "choices": {}}', False),
        ('{"type": "steer", "type": "new", "choices": {}}', False),  # the last one counts
        ('{"type": "film", "game": "reference"}', False),
        ('{"type": "save", "game": "yours"}', False),
        (b"PAR1", False),
    ],
)
def test_which_messages_take_no_longer_than_a_frame(message, quick):
    assert is_quick(message) is quick


def answer_many(work, count):
    """Answer `count` times; return the threads that computed the replies."""
    threads = []

    async def send_text(text):
        threads.append(json.loads(text)["thread"])

    def replies():
        yield {"type": "game", "thread": threading.current_thread().name}

    async def answers():
        for _ in range(count):
            await connection._answer(SimpleNamespace(send_text=send_text), replies(), work)

    asyncio.run(answers())
    return threads


def test_one_thread_computes_all_that_takes_long():
    slow = answer_many(TokenBucket(1.0, 1.0), 3)
    assert set(slow) == {"covey-slow-replies_0"}
    assert not set(answer_many(None, 3)) & set(slow)


def test_a_page_waits_when_it_has_used_up_its_time(monkeypatch):
    now = [0.0]

    async def sleep(seconds):
        now[0] += seconds

    monkeypatch.setattr(connection.asyncio, "sleep", sleep)
    monkeypatch.setattr(
        connection, "time", SimpleNamespace(monotonic=lambda: now[0], thread_time=Readings(0.5))
    )
    work = TokenBucket(connection._WORK_RATE, connection._WORK_BURST)
    answer_many(work, 4)
    assert now[0] == 0.0  # 2 s are saved up
    answer_many(work, 4)
    assert now[0] == pytest.approx(4 * 0.5 / 0.2, abs=0.1)
    answer_many(None, 100)
    assert now[0] == pytest.approx(10.0, abs=0.1)


class Readings:
    """A clock that goes on by `interval` at each reading."""

    def __init__(self, interval):
        self.now, self.interval = 0.0, interval

    def __call__(self):
        self.now += self.interval
        return self.now


def test_an_answer_that_took_longer_than_can_be_saved_up_is_paid_all_the_same(monkeypatch):
    monkeypatch.setattr(connection, "_WORK_BURST", 0.01)
    work = TokenBucket(100.0, 0.01)
    monkeypatch.setattr(
        connection, "time", SimpleNamespace(monotonic=time.monotonic, thread_time=Readings(60.0))
    )
    answer_many(work, 2)


def test_replies_are_the_json_that_they_would_be_at_once():
    reply = {"type": "film", "cast": {"speeds": [1.0, 2]}, "pictures": [{"a": [1]}, None], "n": []}
    assert connection._encoded(reply) == json.dumps(reply)
    with pytest.raises(ValueError, match="JSON"):
        connection._encoded({"pictures": [float("nan")]})
