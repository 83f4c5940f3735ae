"""Who plays: this process, a pool of processes on this machine, or a Dask cluster."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, Executor, Future
from contextlib import contextmanager
from typing import Any, Protocol

from covey.model import InputError
from covey.model.validation import whole_number
from covey.studies.running.games import load_kernels

_IDLE_SECONDS = 120
"""A process of the pool that has had no work for this long ends; until then the next study finds
its kernels loaded."""

_CLUSTER_SECONDS = 30


class Crew(Protocol):
    """Workers that take chunks."""

    @property
    def size(self) -> int:
        """How many chunks are played at a time."""
        ...

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        """Give work to a worker."""
        ...

    def renew(self) -> None:
        """Replace workers that have died."""
        ...

    def dismiss(self) -> None:
        """Drop all work that has not been done."""
        ...

    def leave(self) -> None:
        """Go when all work has been done."""
        ...


@contextmanager
def hired(workers: int | None, dask: str | None) -> Iterator[Crew]:
    """Return the crew; whatever happens, no work of it goes on afterwards."""
    crew = _crew(workers, dask)
    try:
        yield crew
    except BaseException:
        crew.dismiss()
        raise
    crew.leave()


def _crew(workers: int | None, dask: str | None) -> Crew:
    if dask is not None:
        if workers is not None:
            raise InputError("workers: expected nothing beside dask, which has its own workers")
        return Cluster(dask)
    count = cores() if workers is None else whole_number("workers", workers, low=1)
    return Alone() if count == 1 else Pool(count)


def cores() -> int:
    """Return the number of cores that this process may use; a container often has fewer."""
    from loky import cpu_count

    count: int = cpu_count()
    return count


class Alone:
    """No other process than the one that leads."""

    size = 1

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        """Do the work, at once."""
        future: Future[Any] = Future()
        try:
            future.set_result(function(*arguments))
        except Exception as error:
            future.set_exception(error)
        return future

    def renew(self) -> None:
        """Nothing to do."""

    def dismiss(self) -> None:
        """Nothing to do."""

    def leave(self) -> None:
        """Nothing to do."""


class Pool:
    """Processes on this machine, which stay for the next study."""

    def __init__(self, size: int) -> None:
        self.size = size
        load_kernels()  # or every process would compile them for itself
        self.renew()

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        """Give work to a worker."""
        return submitted(self._executor, function, *arguments)

    def renew(self) -> None:
        """Start processes in place of those that have died."""
        from loky import get_reusable_executor

        self._executor: Executor = get_reusable_executor(
            max_workers=self.size, timeout=_IDLE_SECONDS
        )

    def dismiss(self) -> None:
        """End the processes."""
        self._executor.shutdown(wait=False, kill_workers=True)  # type: ignore[call-arg] # loky's

    def leave(self) -> None:
        """Nothing to do: the processes wait for the next study."""


class Cluster:
    """Workers of a Dask cluster; its scheduler replaces the dead and sends their work anew."""

    def __init__(self, address: str) -> None:
        try:
            import distributed
        except ImportError as error:
            raise InputError("dask: not installed; install covey[dask]") from error
        library: Any = distributed  # some of it has types, and some has none
        try:
            self._client = library.Client(address, timeout=_CLUSTER_SECONDS, set_as_default=False)
            self._client.wait_for_workers(1, timeout=_CLUSTER_SECONDS)
        except (OSError, TimeoutError, ValueError) as error:
            raise InputError(f"dask: no cluster with workers answers at {address}") from error
        self._executor: Executor = self._client.get_executor(pure=False)

    @property
    def size(self) -> int:
        """Threads of all workers; they may come and go."""
        threads: int = sum(self._client.nthreads().values())
        return max(1, threads)

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        """Give work to a worker."""
        return submitted(self._executor, function, *arguments)

    def renew(self) -> None:
        """Nothing to do: the scheduler has done it."""

    def dismiss(self) -> None:
        """Leave the cluster to others, and with it all work that it hasn't begun."""
        self.leave()

    def leave(self) -> None:
        """Leave the cluster to others."""
        self._executor.shutdown(wait=False)
        self._client.close()


def submitted(executor: Executor, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
    """Submit work; a pool that is found broken answers like one that breaks later."""
    try:
        return executor.submit(function, *arguments)
    except BrokenExecutor as error:
        future: Future[Any] = Future()
        future.set_exception(error)
        return future
