"""Interrupts, as Ctrl-C sends them, into a study and into calls of the library."""

from __future__ import annotations

import os
import time
from contextlib import suppress
from pathlib import Path
from random import Random
from signal import SIGINT
from threading import Timer

from faults.outcome import Ended, require, require_interrupted, require_told
from faults.processes import LONGEST, ended, running, send
from faults.study import (
    begin,
    begin_and_strike_at_file,
    moment,
    require_goes_on,
    require_undisturbed,
)

INTERRUPTS = 100
"""Interrupts into the same process of calls, one after the other."""

_LONGEST_WAIT = 0.1


def interrupt_study(random: Random, folder: Path) -> None:
    """A study gets an interrupt at any moment: its process alone, or the workers too."""
    count = random.choice([1, 2])
    strike = random.choice([os.kill, os.killpg])
    with begin(folder, count) as process:
        time.sleep(moment(random, count))
        with suppress(ProcessLookupError):  # it was quicker than an undisturbed run
            strike(process.pid, SIGINT)
        done = ended(process)
    _require_stopped_or_done(done, folder)


def interrupt_at_file(random: Random, folder: Path) -> None:
    """A study gets an interrupt just before it opens, renames or removes a file."""
    with begin_and_strike_at_file(random, folder, SIGINT) as process:
        done = ended(process)
    _require_stopped_or_done(done, folder)


def _require_stopped_or_done(done: Ended, folder: Path) -> None:
    if done.status == 0:
        require_undisturbed(folder, done)
    else:
        require_interrupted(done)
    require_goes_on(folder)


def interrupt_calls(random: Random, folder: Path) -> None:
    """A loop of plans and games gets interrupts; later calls give what they give undisturbed."""
    with running(folder, "-m", "faults.calls", str(INTERRUPTS)) as process:
        assert process.stdout is not None
        hanging = Timer(LONGEST, process.kill)  # an interrupt that nobody notices
        hanging.start()
        try:
            for _ in range(INTERRUPTS):
                require(process.stdout.readline() == "ready\n", "an interrupt was not noticed")
                time.sleep(random.uniform(0.0, _LONGEST_WAIT))
                send(process.pid, SIGINT)
            done = ended(process)
        finally:
            hanging.cancel()
    require_told(done, [0])
    require(done.output == "[]\n", f"calls that give something else: {done.output}")
