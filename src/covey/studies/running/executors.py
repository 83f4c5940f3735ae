"""Executors of chunks: this process, a pool of processes on this machine, or a Dask cluster."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from concurrent import futures
from concurrent.futures import BrokenExecutor, Future
from contextlib import contextmanager
from typing import Any, ClassVar, TypeVar

from covey.kernels.library.load import load_library
from covey.model import InputError
from covey.model.validation import Ints, whole_number
from covey.planning.long_calls import new_flag
from covey.planning.threads import Threads
from covey.studies.running.worker import depend_on_parent

Result = TypeVar("Result")

_IDLE_SECONDS = 120
"""After so long without work a process of the pool ends. A study that is run before that finds
processes that have loaded the kernels."""

_CLUSTER_SECONDS = 30


class Executor:
    """Runs functions on workers."""

    _pool: futures.Executor

    def supervise(self, work: Callable[[Ints], Result]) -> Result:
        """Return the result of work that submits calls, and that ends early when its flag is set.

        Another thread does the work. A pool takes locks in the thread that submits its calls, and
        an interrupt in this thread could leave a lock taken, see `planning.threads`.
        """
        stop = new_flag()
        with Threads(1) as threads:
            return threads.run([lambda: work(stop)], stop)[0]

    @property
    def size(self) -> int:
        """How many functions run at a time."""
        return 1

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        """Schedule a call. On a broken pool the future fails, as if the pool broke later."""
        try:
            return self._pool.submit(function, *arguments)
        except BrokenExecutor as error:
            return _failed(error)

    def restart(self) -> None:
        """Replace workers that have died."""

    def cancel(self) -> None:
        """Drop all calls that have not returned."""

    def close(self) -> None:
        """Release the workers after the last call has returned."""


class InProcess(Executor):
    """Calls each function in this process, before `submit` returns."""

    def supervise(self, work: Callable[[Ints], Result]) -> Result:
        """Do the work in this thread, where an interrupt ends a call at once."""
        return work(new_flag())

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        """Call the function."""
        future: Future[Any] = Future()
        try:
            future.set_result(function(*arguments))
        except Exception as error:
            return _failed(error)
        return future


class ProcessPool(Executor):
    """Processes on this machine. They outlive a study, and the next study uses them again."""

    latest: ClassVar[futures.Executor | None] = None
    """The pool of the latest study in this process."""

    def __init__(self, size: int) -> None:
        self._size = size
        load_library()  # is built here if need be, with a bar; the processes would wait in silence
        self.restart()

    @property
    def size(self) -> int:
        """The number of processes."""
        return self._size

    def restart(self) -> None:
        """Start a new pool if the present one is broken."""
        from loky import get_reusable_executor

        self._pool = get_reusable_executor(
            max_workers=self._size,
            timeout=_IDLE_SECONDS,
            initializer=depend_on_parent,
            initargs=(os.getpid(),),
        )
        ProcessPool.latest = self._pool

    def cancel(self) -> None:
        """Kill the processes."""
        end_processes()


class DaskCluster(Executor):
    """Workers of a Dask cluster. Dask itself replaces dead workers and repeats their calls."""

    def __init__(self, address: str) -> None:
        try:
            import distributed
        except ImportError as error:
            raise InputError("dask: not installed; install covey[dask]") from error
        library: Any = distributed  # only partly typed
        try:
            self._client = library.Client(address, timeout=_CLUSTER_SECONDS, set_as_default=False)
            self._client.wait_for_workers(1, timeout=_CLUSTER_SECONDS)
        except (OSError, TimeoutError, ValueError) as error:
            raise InputError(f"dask: no cluster with workers answers at {address}") from error
        self._pool = self._client.get_executor(pure=False)

    @property
    def size(self) -> int:
        """Threads of all workers at this moment."""
        threads: int = sum(self._client.nthreads().values())
        return max(1, threads)

    def cancel(self) -> None:
        """Disconnect. The cluster then drops the calls that have not begun."""
        self.close()

    def close(self) -> None:
        """Disconnect. The cluster goes on."""
        self._pool.shutdown(wait=False)
        self._client.close()


def end_processes() -> None:
    """Kill the processes that earlier studies have left for the next study.

    At its exit Python waits for each of these processes, also for a process that has been stopped.
    """
    if ProcessPool.latest is not None:
        ProcessPool.latest.shutdown(wait=False, kill_workers=True)  # type: ignore[call-arg] # loky's
        ProcessPool.latest = None


@contextmanager
def open_executor(workers: int | None, dask: str | None) -> Iterator[Executor]:
    """Return an executor that is closed at the end, or cancelled on an exception."""
    executor = _executor(workers, dask)
    try:
        yield executor
    except BaseException:
        executor.cancel()
        raise
    executor.close()


def _executor(workers: int | None, dask: str | None) -> Executor:
    if dask is not None:
        if workers is not None:
            raise InputError("workers: expected nothing beside dask, which has its own workers")
        return DaskCluster(dask)
    count = cores() if workers is None else whole_number("workers", workers, low=1)
    return InProcess() if count == 1 else ProcessPool(count)


def cores() -> int:
    """Return the number of cores that this process may use. In a container they may be few."""
    from loky import cpu_count

    count: int = cpu_count()
    return count


def _failed(error: Exception) -> Future[Any]:
    future: Future[Any] = Future()
    future.set_exception(error)
    return future
