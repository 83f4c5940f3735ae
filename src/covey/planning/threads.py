"""Threads that make calls while an interrupt may come to the calling thread at any moment.

The pools of `concurrent.futures` take locks in the calling thread, by functions in Python. An
interrupt in such a function, once it has taken the lock, leaves the lock taken, and a thread of the
pool then waits for ever. Here the calling thread takes no lock. Each of its steps (a thread is
started, a call is put into a queue, the end of a call is awaited) is one function in C, which
Python does not interrupt half-way.
"""

from __future__ import annotations

import math
import time
from _thread import start_new_thread
from collections.abc import Callable, Sequence
from contextlib import suppress
from queue import Empty, SimpleQueue
from typing import Any, NamedTuple, TypeVar

from covey.kernels.arrays import ABANDON, FINISH
from covey.model.validation import Ints

Result = TypeVar("Result")

_PATIENCE = 0.1  # seconds: on Windows a wait without a limit serves no signal


class _Task(NamedTuple):
    """A call, and where its outcome goes."""

    number: int
    call: Callable[[], Any]
    stop: Ints  # (1,) with `ABANDON` the call doesn't begin any more
    outcomes: dict[int, Any]  # results and exceptions, by number
    ended: SimpleQueue[None]  # tells the calling thread that there is an outcome

    def run(self) -> None:
        """Make the call."""
        try:
            self.outcomes[self.number] = self.call() if self.stop[0] != ABANDON else None
        except BaseException as error:
            self.outcomes[self.number] = error
        self.ended.put(None)


_Tasks = SimpleQueue[_Task | None]  # None ends the threads


class Threads:
    """Threads for the length of a block.

    Parameters
    ----------
    count
        How many.
    """

    def __init__(self, count: int) -> None:
        self._count = count
        self._tasks: _Tasks = SimpleQueue()

    def __enter__(self) -> Threads:
        """Start the threads."""
        try:
            for _ in range(self._count):
                start_new_thread(_work, (self._tasks,))
            return self
        except BaseException:
            self.__exit__()
            raise

    def __exit__(self, *exception: object) -> None:
        """Let the threads end, each after the call that it makes."""
        self._tasks.put(None)

    def run(
        self,
        calls: Sequence[Callable[[], Result]],
        stop: Ints,
        deadline: float = math.inf,
    ) -> list[Result]:
        """Make all calls and return their results, or raise the exception of the first that failed.

        Parameters
        ----------
        calls
            Each ends early when `stop` says so.
        stop
            (1,) set to `FINISH` at the deadline, to `ABANDON` when an exception ends the wait.
        deadline
            By `time.perf_counter`; inf: none.
        """
        outcomes: dict[int, Any] = {}
        ended: SimpleQueue[None] = SimpleQueue()
        begun = 0
        try:
            for number, call in enumerate(calls):
                self._tasks.put(_Task(number, call, stop, outcomes, ended))
                begun = number + 1
            left = deadline - time.perf_counter()
            while len(outcomes) < len(calls):
                _await(ended, max(min(_PATIENCE, left), 0.0))
                left = deadline - time.perf_counter()
                if left <= 0.0:
                    stop[0], left, deadline = FINISH, math.inf, math.inf
        except BaseException:
            stop[0] = ABANDON
            while len(outcomes) < begun:
                _await(ended, _PATIENCE)
            raise
        return [_result(outcomes[number]) for number in range(len(calls))]


def _work(tasks: _Tasks) -> None:
    while (task := tasks.get()) is not None:
        task.run()
    tasks.put(None)  # for the next thread


def _await(ended: SimpleQueue[None], seconds: float) -> None:
    """Wait until a call has ended, at most so long. Python serves signals during the wait."""
    with suppress(Empty):
        ended.get(timeout=seconds)


def _result(outcome: Any) -> Any:
    if isinstance(outcome, BaseException):
        raise outcome
    return outcome
