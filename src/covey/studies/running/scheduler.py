"""Sends chunks to workers, saves their results, and recovers from chunks that fail or crash.

A worker that dies breaks the whole pool, and all chunks that were running come back with the same
error. All of them are quarantined: they run again one at a time, so that the next crash names its
chunk. A chunk that has failed twice is left out and reported.
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable, Collection, Iterable
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, wait
from typing import Any, NamedTuple

from covey.kernels.arrays import GO_ON
from covey.model.validation import Ints
from covey.studies.design.study import Study
from covey.studies.running.chunks import Chunk
from covey.studies.running.executors import Executor
from covey.studies.running.games import GameError
from covey.studies.running.provenance import code_digest
from covey.studies.running.worker import ChunkResult, OtherCodeError, play_chunk

_MAX_TRIES = 2
_QUEUED = 2
"""Chunks submitted for each worker, so that none waits for its next chunk."""
_PATIENCE = 0.1
"""Seconds after which the flag is read again."""


class Failure(NamedTuple):
    """A chunk that was left out."""

    chunk: Chunk
    start: int
    seed: int
    message: str

    def __str__(self) -> str:
        """Return the line that is shown to the user."""
        return (
            f"starts {self.chunk.first} to {self.chunk.last - 1} are missing: start {self.start} "
            f"(seed {self.seed}): {self.message}"
        )


class Scheduler:
    """Runs the chunks of a study once.

    Parameters
    ----------
    study, executor
        What is played, and where.
    save
        Gets each result as soon as its chunk is done.
    stop
        (1,) flag that another thread sets to end the run, by KeyboardInterrupt.
    """

    def __init__(
        self,
        study: Study,
        executor: Executor,
        save: Callable[[Chunk, ChunkResult], None],
        stop: Ints,
    ) -> None:
        self._study, self._executor, self._save, self._stop = study, executor, save, stop
        self._waiting: deque[Chunk] = deque()
        self._quarantined: deque[Chunk] = deque()
        self._running: dict[Future[Any], Chunk] = {}
        self._alone = False  # whether the running chunk was submitted while no other ran
        self._tries: Counter[int] = Counter()
        self._failures: list[Failure] = []

    def run(self, chunks: Iterable[Chunk]) -> list[Failure]:
        """Play all chunks, and return those that failed."""
        self._waiting.extend(chunks)
        while self._waiting or self._quarantined or self._running:
            self._submit_next()
            done = self._ended(self._running)
            for future in done:
                self._collect(self._running.pop(future), future)
        return self._failures

    def _ended(self, futures: Collection[Future[Any]]) -> set[Future[Any]]:
        """Wait for the next futures that are done."""
        while self._stop[0] == GO_ON:
            if done := wait(futures, _PATIENCE, FIRST_COMPLETED).done:
                return done
        raise KeyboardInterrupt

    def _submit_next(self) -> None:
        """Submit one quarantined chunk if no other runs, or else as many as keep workers busy."""
        if not self._running:
            self._executor.restart()
        most = 1 if self._quarantined else max(1, _QUEUED * self._executor.size - 1)
        queue = self._quarantined or self._waiting
        while queue and len(self._running) < most:
            chunk = queue.popleft()
            self._running[self._submit(chunk)] = chunk
            self._alone = most == 1

    def _submit(self, chunk: Chunk) -> Future[Any]:
        study = self._study.only(chunk.first, chunk.last)
        return self._executor.submit(play_chunk, study, chunk, code_digest())

    def _collect(self, chunk: Chunk, future: Future[Any]) -> None:
        error = future.exception()
        if error is None:
            self._save(chunk, future.result())
        elif isinstance(error, OtherCodeError):
            raise error
        elif isinstance(error, BrokenExecutor) and not self._alone:
            self._quarantined.append(chunk)
        else:
            self._retry(chunk, error)

    def _retry(self, chunk: Chunk, error: BaseException) -> None:
        self._tries[chunk.number] += 1
        if self._tries[chunk.number] < _MAX_TRIES:
            queue = self._quarantined if isinstance(error, BrokenExecutor) else self._waiting
            queue.append(chunk)
        else:
            self._failures.append(self._failure(chunk, error))

    def _failure(self, chunk: Chunk, error: BaseException) -> Failure:
        if isinstance(error, GameError):
            start = error.number // len(self._study.cases)
            return Failure(chunk, start, error.seed, error.message)
        crashed = isinstance(error, BrokenExecutor)
        start = self._find_crashing_start(chunk) if crashed else chunk.first
        seed = self._study.start(start, min(self._study.team_size)).seed
        told = f"{type(error).__name__}: {error}".partition("\n")[0]
        return Failure(chunk, start, seed, told)

    def _find_crashing_start(self, chunk: Chunk) -> int:
        """Play the starts of a chunk one at a time, until one of them kills its worker."""
        self._executor.restart()
        for start in range(chunk.first, chunk.last):
            (future,) = self._ended([self._submit(Chunk(chunk.number, start, start + 1))])
            if isinstance(future.exception(), BrokenExecutor):
                return start
        return chunk.first
