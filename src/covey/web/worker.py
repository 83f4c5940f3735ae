"""The process in which the server calls what takes long.

In a thread, a film or a long game would hold the interpreter's lock, for which every frame of every
other page waits.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from threading import Thread
from typing import ParamSpec, TypeVar

from covey.model import InputError

Parameters = ParamSpec("Parameters")
Result = TypeVar("Result")

_NICENESS = 10
"""Frames come first where processors are few."""


class Worker:
    """One process of low priority, and its successor if it dies."""

    def __init__(self) -> None:
        self._pool: ProcessPoolExecutor | None = None

    def start(self) -> None:
        """Call in a process of its own from now on."""
        self._pool = ProcessPoolExecutor(1, multiprocessing.get_context("spawn"), _begin)

    def stop(self) -> None:
        """End the process once it has done what it does."""
        if self._pool is not None:
            self._pool.shutdown(cancel_futures=True)
            self._pool = None

    def call(
        self,
        function: Callable[Parameters, Result],
        *arguments: Parameters.args,
        **options: Parameters.kwargs,
    ) -> Result:
        """Return what `function` returns: from the process if one was started, else from here."""
        if self._pool is None:
            return function(*arguments, **options)
        try:
            return self._pool.submit(function, *arguments, **options).result()
        except BrokenProcessPool:
            self.start()
            raise InputError("the server broke off what was asked for; try it again") from None


worker = Worker()
"""Of all pages."""


def _begin() -> None:
    """Leave an interrupt to the server, end when it has died, and let its frames go first."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    Thread(target=_end_with_server, daemon=True).start()
    if hasattr(os, "nice"):  # not on Windows
        os.nice(_NICENESS)


def _end_with_server() -> None:
    server = multiprocessing.parent_process()
    if server is not None:
        server.join()
        os._exit(1)
