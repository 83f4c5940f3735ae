"""One WebSocket: reads messages within a rate limit, runs the session, sends its replies."""

from __future__ import annotations

import asyncio
import json
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from starlette.websockets import WebSocket, WebSocketDisconnect

from covey.web.messages import is_quick
from covey.web.rate_limit import TokenBucket
from covey.web.session import Reply, Session, error_reply

_FRAME = 1.0 / 60.0
"""Seconds between two frames: enough for every screen, since the page interpolates."""

_MESSAGES_PER_SECOND = 120.0
_FILE_COSTS = 60.0
_MOST_WAITING = 64

_REFUSAL = 0.001
"""Seconds for which nothing is read after a refused message. A flood waits in its own network."""

_WORK_RATE, _WORK_BURST = 0.2, 2.0
"""Of a processor's time, for what takes long: the share of a page, and the seconds it may save up.

A game of five evaders takes 0.1 s to set up, one of ten at most 1 s.
"""

_slow_thread = ThreadPoolExecutor(1, "covey-slow-replies")
"""Of all pages: what takes long takes one processor at most, and frames have the others."""

Inbox = asyncio.Queue[str | bytes]


async def converse(websocket: WebSocket) -> None:
    """Serve a page until it is closed. Its game ends then."""
    inbox: Inbox = asyncio.Queue(_MOST_WAITING)
    tasks = [
        asyncio.create_task(_read(websocket, inbox)),
        asyncio.create_task(_play(websocket, inbox)),
    ]
    try:
        done, _ = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        for task in done:
            task.result()
    except WebSocketDisconnect:
        pass
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)


async def _read(websocket: WebSocket, inbox: Inbox) -> None:
    """Pass messages on. Those beyond the limit are dropped; the page is told once a second."""
    limit = TokenBucket(_MESSAGES_PER_SECOND, 2.0 * _MESSAGES_PER_SECOND)
    complaints = TokenBucket(1.0, 1.0)
    while True:
        event = await websocket.receive()
        if event["type"] == "websocket.disconnect":
            raise WebSocketDisconnect(event.get("code", 1000))
        message, cost = event.get("text"), 1.0
        if message is None:
            message, cost = event["bytes"], _FILE_COSTS
        if limit.take(time.monotonic(), cost):
            await inbox.put(message)
            if isinstance(message, bytes):
                await inbox.join()  # files are large: one at a time
            continue
        if complaints.take(time.monotonic()):
            text = f"expected at most {_MESSAGES_PER_SECOND:g} messages a second; some were dropped"
            await _send(websocket, _encoded(error_reply(text)))
        await asyncio.sleep(_REFUSAL)


async def _play(websocket: WebSocket, inbox: Inbox) -> None:
    """Answer the messages that have come and play the updates that are due, frame by frame.

    Both happen in threads, since kernels release the interpreter's lock.
    """
    session, work = Session(), TokenBucket(_WORK_RATE, _WORK_BURST)
    while True:
        began = time.monotonic()
        messages = [] if session.busy else [await inbox.get()]
        while not inbox.empty():
            messages.append(inbox.get_nowait())
        for message in messages:
            replies = session.receive(message, time.monotonic())
            await _answer(websocket, replies, None if is_quick(message) else work)
            inbox.task_done()
        replies = session.advance(time.monotonic())
        await _answer(websocket, replies, work if session.reference_pending else None)
        if session.busy:
            await asyncio.sleep(max(0.0, began + _FRAME - time.monotonic()))


async def _answer(websocket: WebSocket, replies: Iterator[Reply], work: TokenBucket | None) -> None:
    """Compute replies in a thread and send them; wait until `work` has paid for slow ones."""
    thread = None if work is None else _slow_thread
    loop = asyncio.get_running_loop()
    contents, seconds = await loop.run_in_executor(thread, _compute, replies)
    for content in contents:
        await _send(websocket, content)
    while work and not work.take(time.monotonic(), min(seconds, _WORK_BURST)):
        await asyncio.sleep(_FRAME)


def _compute(replies: Iterator[Reply]) -> tuple[list[str | bytes], float]:
    """Return the contents of messages, and the processor's time that they took."""
    began = time.thread_time()
    contents = [reply if isinstance(reply, bytes) else _encoded(reply) for reply in replies]
    return contents, time.thread_time() - began


def _encoded(reply: dict[str, Any]) -> str:
    """Return a reply as JSON.

    Lists are encoded item by item: one call would keep the interpreter's lock for a whole film, and
    every other game would wait for it.
    """
    return "{" + ", ".join(f"{_json(key)}: {_by_item(item)}" for key, item in reply.items()) + "}"


def _by_item(value: Any) -> str:
    return f"[{', '.join(map(_json, value))}]" if isinstance(value, list) else _json(value)


def _json(value: Any) -> str:
    return json.dumps(value, allow_nan=False)


async def _send(websocket: WebSocket, content: str | bytes) -> None:
    if isinstance(content, bytes):
        await websocket.send_bytes(content)
    else:
        await websocket.send_text(content)
