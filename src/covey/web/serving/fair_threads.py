"""Threads that share their time fairly among those who ask for it."""

from __future__ import annotations

import time
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from threading import Lock
from typing import Generic, TypeVar

from covey.web.serving.fair_queue import FairQueue

Result = TypeVar("Result")


class FairThreads(Generic[Result]):
    """`count` threads. Who has had least of their time is served next, however many others wait."""

    def __init__(self, count: int, name: str) -> None:
        self._threads = ThreadPoolExecutor(count, name)
        self._queue: FairQueue[tuple[Future[Result], Callable[[], Result]]] = FairQueue()
        self._lock = Lock()

    def submit(self, user: str, call: Callable[[], Result]) -> Future[Result]:
        """Have `call` called when it is the turn of `user`, unless it is cancelled before."""
        future: Future[Result] = Future()
        with self._lock:
            self._queue.put(user, (future, call))
        self._threads.submit(self._serve_next)  # whose turn it is then
        return future

    def _serve_next(self) -> None:
        with self._lock:
            user, (future, call) = self._queue.take()
        if not future.set_running_or_notify_cancel():
            return
        began = time.monotonic()
        try:
            future.set_result(call())
        except BaseException as error:  # raised where the result is awaited
            future.set_exception(error)
        # Time on the clock, since kernels may run in further threads. It counts, too, for who left.
        with self._lock:
            self._queue.charge(user, time.monotonic() - began)
