"""Send chunks to workers, write what comes back, and get over those that fail or die.

A worker that dies takes the whole pool along, and nobody knows which of the chunks in flight was
to blame. All of them are suspects then, and are played alone, one after the other: whoever kills a
worker now is guilty. A chunk that has failed twice is left out and reported.
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable, Iterable
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, wait
from typing import Any, NamedTuple

from covey.studies.design.study import Study
from covey.studies.running.chunks import Chunk
from covey.studies.running.executors import Crew
from covey.studies.running.games import GameError
from covey.studies.running.provenance import code_digest
from covey.studies.running.worker import OtherCodeError, Parts, play_chunk

TRIES = 2
_AHEAD = 2
"""Chunks in flight for each worker: the next one waits there when one is done."""


class Failure(NamedTuple):
    """A chunk that was left out."""

    chunk: Chunk
    start: int
    seed: int
    message: str

    def __str__(self) -> str:
        """Return the line that a person reads."""
        return (
            f"starts {self.chunk.first} to {self.chunk.last - 1} are missing: start {self.start} "
            f"(seed {self.seed}): {self.message}"
        )


class Conductor:
    """One run of a study; `keep` gets what comes back, in the order in which it does."""

    def __init__(self, study: Study, crew: Crew, keep: Callable[[Chunk, Parts], None]) -> None:
        self._study, self._crew, self._keep = study, crew, keep
        self._waiting: deque[Chunk] = deque()
        self._suspects: deque[Chunk] = deque()
        self._flying: dict[Future[Any], Chunk] = {}
        self._tries: Counter[int] = Counter()
        self._failures: list[Failure] = []

    def conduct(self, chunks: Iterable[Chunk]) -> list[Failure]:
        """Play all chunks, and return those that failed."""
        self._waiting.extend(chunks)
        while self._waiting or self._suspects or self._flying:
            self._launch()
            done, _ = wait(self._flying, return_when=FIRST_COMPLETED)
            alone = len(self._flying) == 1
            for future in done:
                self._land(self._flying.pop(future), future, alone)
        return self._failures

    def _launch(self) -> None:
        if self._suspects:
            if not self._flying:
                self._crew.renew()
                self._send(self._suspects.popleft())
            return
        while self._waiting and len(self._flying) < max(1, _AHEAD * self._crew.size - 1):
            self._send(self._waiting.popleft())

    def _send(self, chunk: Chunk) -> None:
        self._flying[self._submit(chunk)] = chunk

    def _submit(self, chunk: Chunk) -> Future[Any]:
        part = self._study.only(chunk.first, chunk.last)
        return self._crew.submit(play_chunk, part, chunk, code_digest())

    def _land(self, chunk: Chunk, future: Future[Any], alone: bool) -> None:
        error = future.exception()
        if error is None:
            self._keep(chunk, future.result())
        elif isinstance(error, OtherCodeError):
            raise error
        elif isinstance(error, BrokenExecutor) and not alone:
            self._suspects.append(chunk)
        else:
            self._retry(chunk, error)

    def _retry(self, chunk: Chunk, error: BaseException) -> None:
        self._tries[chunk.number] += 1
        if self._tries[chunk.number] < TRIES:
            queue = self._suspects if isinstance(error, BrokenExecutor) else self._waiting
            queue.append(chunk)
        else:
            self._failures.append(self._failure(chunk, error))

    def _failure(self, chunk: Chunk, error: BaseException) -> Failure:
        if isinstance(error, GameError):
            start = error.number // len(self._study.cases)
            return Failure(chunk, start, error.seed, error.message)
        start = chunk.first
        if isinstance(error, BrokenExecutor):
            start = self._deadly_start(chunk)
        return Failure(chunk, start, self._seed(start), f"{type(error).__name__}: {error}")

    def _deadly_start(self, chunk: Chunk) -> int:
        """Play the starts of a chunk one by one, to find the one that kills its worker."""
        for start in range(chunk.first, chunk.last):
            self._crew.renew()
            one = self._submit(Chunk(chunk.number, start, start + 1))
            if isinstance(one.exception(), BrokenExecutor):
                self._crew.renew()
                return start
        return chunk.first

    def _seed(self, start: int) -> int:
        return self._study.start(start, min(self._study.team_size)).seed
