"""Runs of covey in a process group of their own, and what is sent to their processes."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TypeAlias

import covey
from faults.outcome import Ended, SkippedError, require

Run: TypeAlias = "subprocess.Popen[str]"

SOURCES = Path(covey.__file__).parents[1]
_CHECKOUT = Path(__file__).parents[1]
LONGEST = 1200.0
"""Seconds after which a run counts as hanging; a busy machine compiles kernels for minutes."""

_ENDING = 20.0
"""Seconds that processes get to end after the process that they serve."""

COVEY = ("-m", "covey")


def environment(**changes: str) -> dict[str, str]:
    """Return this environment, with this covey and these faults where Python finds them."""
    paths = [str(SOURCES), str(_CHECKOUT), *filter(None, [os.environ.get("PYTHONPATH")])]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(paths), **changes}


@contextmanager
def running(folder: Path, *arguments: str, **variables: str) -> Iterator[Run]:
    """Start Python with arguments in a folder; at the end nothing of it is left."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        # As for all that a shell runs in the background; whatever it starts would ignore it too.
        signal.signal(signal.SIGINT, signal.default_int_handler)
    with subprocess.Popen(
        [sys.executable, *arguments],
        cwd=folder,
        env=environment(**variables),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
        start_new_session=True,
    ) as process:
        try:
            yield process
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)


def ended(process: Run) -> Ended:
    """Wait for a process and for those that it started; return how it ended."""
    try:
        output, errors = process.communicate(timeout=LONGEST)
    except subprocess.TimeoutExpired:
        require(False, f"still running after {LONGEST:.0f} s")
    wait_for(lambda: not group(process.pid), _ENDING, "processes outlive the run")
    return Ended(process.returncode, output, errors)


def run(folder: Path, *arguments: str, **variables: str) -> Ended:
    """Run Python with arguments in a folder, to its end."""
    with running(folder, *arguments, **variables) as process:
        return ended(process)


def send(number: int, what: signal.Signals) -> bool:
    """Send a signal to a process; return whether the process was still there."""
    try:
        os.kill(number, what)
    except ProcessLookupError:
        return False
    return True


def group(leader: int) -> set[int]:
    """Return the numbers of the processes of a group that live."""
    found = set()
    for status in _processes():
        with contextlib.suppress(OSError):
            state, _, number, *_ = (status / "stat").read_text().rpartition(")")[2].split()
            if int(number) == leader and state not in "ZX":
                found.add(int(status.name))
    return found


def workers(leader: int) -> list[int]:
    """Return the numbers of the processes that play a study's games for a run."""
    found = []
    for number in sorted(group(leader)):
        with contextlib.suppress(OSError):
            if b"popen_loky" in Path(f"/proc/{number}/cmdline").read_bytes():
                found.append(number)
    return found


def _processes() -> Iterator[Path]:
    if not Path("/proc/self/stat").exists():
        raise SkippedError("processes are found in /proc, which this system doesn't have")
    return Path("/proc").glob("[0-9]*")


def wait_for(holds: Callable[[], object], seconds: float, otherwise: str) -> None:
    """Wait until a condition holds; that it never does is a consequence that must not be."""
    late = time.monotonic() + seconds
    while not holds():
        require(time.monotonic() < late, f"{otherwise} after {seconds:.0f} s")
        time.sleep(0.02)
