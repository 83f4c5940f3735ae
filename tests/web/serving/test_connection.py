"""What a connection lets through to its session, on a clock that is set by hand."""

from __future__ import annotations

import asyncio
import json
from concurrent.futures import Future
from types import SimpleNamespace

import pytest
from starlette.websockets import WebSocketDisconnect

from covey.web.game.messages import is_quick
from covey.web.serving import connection

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


class Threads:
    """Compute at once, and note for whom."""

    def __init__(self):
        self.users = []

    def submit(self, user, call):
        self.users.append(user)
        future = Future()
        future.set_result(call())
        return future


@pytest.mark.parametrize("slow", [False, True])
def test_replies_are_computed_when_it_is_the_turn_of_the_address(monkeypatch, slow):
    quick_threads, slow_threads = Threads(), Threads()
    monkeypatch.setattr(connection, "_quick_threads", quick_threads)
    monkeypatch.setattr(connection, "_slow_threads", slow_threads)
    told = []

    async def send(content):
        told.append(content)

    page = SimpleNamespace(scope={"client": ("h", 80)}, send_text=send, send_bytes=send)
    replies = iter([{"type": "over", "time": None}, '{"type": "film"}', b"PAR1"])
    asyncio.run(connection._answer(page, replies, slow=slow))
    assert told == ['{"type": "over", "time": null}', '{"type": "film"}', b"PAR1"]
    assert (slow_threads if slow else quick_threads).users == ["h"]
    assert (quick_threads if slow else slow_threads).users == []


def test_long_answers_take_several_turns(monkeypatch):
    """Nothing is sent twice, and a turn ends with the update that is under way."""
    threads, now = Threads(), [0.0]
    monkeypatch.setattr(connection, "_quick_threads", threads)
    monkeypatch.setattr(connection, "time", SimpleNamespace(monotonic=lambda: now[0]))
    told = []

    async def send(content):
        told.append((len(threads.users), content))

    def updates():
        for _ in range(5):
            now[0] += 0.6 * connection._TURN
            yield None
        yield {"type": "frame"}
        yield {"type": "over"}

    page = SimpleNamespace(scope={"client": ("h", 80)}, send_text=send)
    asyncio.run(connection._answer(page, updates(), slow=False))
    assert threads.users == ["h"] * 3
    assert told == [(3, '{"type": "frame"}'), (3, '{"type": "over"}')]


def test_games_and_films_wait_elsewhere_than_frames(monkeypatch):
    """Whatever a page sends, `_play` says which of the two it is."""
    computed = []

    async def answer(websocket, replies, *, slow):
        computed.append((slow, [reply["type"] for reply in replies if reply]))

    monkeypatch.setattr(connection, "_answer", answer)

    async def play():
        inbox = asyncio.Queue()
        for message in (
            {"type": "new", "choices": {"evaders": 1}},
            {"type": "step"},
            {"type": "run"},
        ):
            inbox.put_nowait(json.dumps(message))
        playing = asyncio.create_task(connection._play(None, inbox))
        while len(computed) < 6 and not playing.done():
            await asyncio.sleep(0.01)
        playing.cancel()

    asyncio.run(play())
    assert computed[:4] == [
        (True, ["game"]),
        (False, ["frame"]),
        (False, []),
        (True, ["reference"]),
    ]
    assert computed[5] == (False, ["frame"])
