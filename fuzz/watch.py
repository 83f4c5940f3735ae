"""All targets at the same time, each in processes of its own, until one has a finding.

A process of its own also finds what no exception tells: a crash of the interpreter, and a case that
never ends.
"""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from fuzz.search import TARGETS, load

HANG_SECONDS = 120.0
"""A case that takes longer hangs. The limit is of time that passes: the machine may be busy."""
START_SECONDS = 300.0
"""A worker that has tried nothing until then hangs too."""
FINDINGS = Path("fuzz") / "findings"


class Finding(NamedTuple):
    """A case that failed, and how."""

    target: str
    content: bytes
    error: str


class Worker:
    """A process that searches one target; its command leaves what it does in its folder."""

    def __init__(self, target, command, folder):
        folder.mkdir()
        self.target, self._folder, self._began = target, folder, time.time()
        self._log = folder / "log"
        environment = {**os.environ, "MPLBACKEND": "agg", "PYTHONPATH": os.pathsep.join(sys.path)}
        with self._log.open("wb") as log:
            self._process = subprocess.Popen(
                command, stdout=log, stderr=log, env=environment, cwd=folder
            )

    def stop(self):
        """End the process."""
        self._process.kill()
        self._process.wait()

    def result(self):
        """Return None while it searches, then what it did, or its finding."""
        code = self._process.poll()
        if code is None and not self._hangs():
            return None
        if code == 0:
            return json.loads((self._folder / "result.json").read_text())
        found, current = self._folder / "found", self._folder / "current"
        if code is None:
            self.stop()
            error = f"no end after {HANG_SECONDS:.0f} s"
        elif found.exists():
            return Finding(self.target, found.read_bytes(), (self._folder / "error").read_text())
        else:
            error = f"the process ended with {code}:\n{self._log.read_text(errors='replace')}"
        return Finding(self.target, current.read_bytes() if current.exists() else b"", error)

    def _hangs(self):
        current = self._folder / "current"
        if not current.exists():
            return time.time() - self._began > START_SECONDS
        return time.time() - current.stat().st_mtime > HANG_SECONDS


def fuzz(minutes: float, seed: int) -> int:
    """Search all targets; print what was done. Return 1 for a finding, else 0."""
    each = max(1, (os.cpu_count() or 1) // len(TARGETS))
    print(f"{len(TARGETS)} targets, {each} processes each, {minutes:g} minutes; SEED={seed}")
    with TemporaryDirectory() as folder:
        workers = [
            Worker(
                target,
                [sys.executable, "-m", "fuzz.search", target, f"{seed}.{k}", str(60.0 * minutes)],
                Path(folder) / f"{target}-{k}",
            )
            for target in TARGETS
            for k in range(each)
        ]
        try:
            return watch(workers, minutes)
        finally:
            for worker in workers:
                worker.stop()


def watch(workers, minutes):
    """Wait for all workers, or until one has a finding; return 1 then, else 0."""
    waiting = list(workers)
    while waiting:
        time.sleep(0.2)
        for worker in list(waiting):
            match worker.result():
                case None:
                    continue
                case Finding() as finding:
                    _tell(finding)
                    return 1
                case done:
                    _print_done(worker.target, done, minutes)
                    waiting.remove(worker)
    return 0


def _print_done(target, done, minutes):
    speed = done["cases"] / (60.0 * minutes)
    print(
        f"{target:10} {done['cases']:7} cases, {speed:6.1f} a second, {done['answers']:4} kinds of "
        f"answers, {len(done['new']):4} of them not in the corpus"
    )


def _tell(finding):
    """Save a finding; say how to repeat it."""
    FINDINGS.mkdir(exist_ok=True)
    digest = hashlib.sha256(finding.content).hexdigest()[:8]
    file = FINDINGS / f"{finding.target}-{digest}{load(finding.target).suffix}"
    file.write_bytes(finding.content)
    print(
        f"\nA finding in {finding.target}:\n{finding.error}\n"
        f"Repeat it:       make fuzz CASE={file}\n"
        f"Once repaired:   mv {file} fuzz/corpus/{finding.target}/what-was-wrong{file.suffix}"
    )
