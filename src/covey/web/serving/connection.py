"""One WebSocket: reads messages within a rate limit, runs the session, sends its replies."""

from __future__ import annotations

import asyncio
import json
import math
import time
from collections.abc import Iterator

from starlette.websockets import WebSocket, WebSocketDisconnect

from covey.web.game.messages import is_quick
from covey.web.game.session import Reply, Session, error_reply
from covey.web.serving.fair_threads import FairThreads
from covey.web.serving.origin import address_of
from covey.web.serving.rate_limit import TokenBucket

_FRAME = 1.0 / 60.0
"""Seconds between two frames: enough for every screen, since the page interpolates."""

_MESSAGES_PER_SECOND = 120.0
_FILE_COSTS = 60.0
_MOST_WAITING = 64

_REFUSAL = 0.001
"""Seconds for which nothing is read after a refused message. A flood waits in its own network."""

_TURN = 0.003
"""Seconds after which a page lets others go first. A frame of five evaders takes 2 ms."""

Turn = tuple[list[str | bytes], bool]
"""The contents of messages, and whether all is answered."""

_quick_threads: FairThreads[Turn] = FairThreads(1, "covey-frames")
_slow_threads: FairThreads[Turn] = FairThreads(1, "covey-slow-replies")
"""What takes long waits in one thread for the worker."""

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
            await _send(websocket, json.dumps(error_reply(text)))
        await asyncio.sleep(_REFUSAL)


async def _play(websocket: WebSocket, inbox: Inbox) -> None:
    """Answer the messages that have come and play the updates that are due, frame by frame.

    Both happen in threads, since kernels release the interpreter's lock.
    """
    session = Session()
    while True:
        began = time.monotonic()
        messages = [] if session.busy else [await inbox.get()]
        while not inbox.empty():
            messages.append(inbox.get_nowait())
        for message in messages:
            replies = session.receive(message, time.monotonic())
            await _answer(websocket, replies, slow=not is_quick(message))
            inbox.task_done()
        replies = session.advance(time.monotonic())
        await _answer(websocket, replies, slow=session.reference_pending)
        if session.busy:
            await asyncio.sleep(max(0.0, began + _FRAME - time.monotonic()))


async def _answer(websocket: WebSocket, replies: Iterator[Reply], *, slow: bool) -> None:
    """Compute replies in a thread, whenever it is the turn of the page's address, and send them.

    Slow replies are computed in one turn: they can't be broken off, and the end of a page's last
    would wait behind the slow replies of all others.
    """
    threads, user = _slow_threads if slow else _quick_threads, address_of(websocket.scope)
    seconds = math.inf if slow else _TURN
    answered = False
    while not answered:
        turn = asyncio.wrap_future(threads.submit(user, lambda: _take_turn(replies, seconds)))
        contents, answered = await turn
        for content in contents:
            await _send(websocket, content)


def _take_turn(replies: Iterator[Reply], seconds: float) -> Turn:
    """Compute replies for some seconds, and what is under way then."""
    ends = time.monotonic() + seconds
    contents = []
    for reply in replies:
        if reply is not None:
            contents.append(
                json.dumps(reply, allow_nan=False) if isinstance(reply, dict) else reply
            )
        if time.monotonic() >= ends:
            return contents, False
    return contents, True


async def _send(websocket: WebSocket, content: str | bytes) -> None:
    if isinstance(content, bytes):
        await websocket.send_bytes(content)
    else:
        await websocket.send_text(content)
