"""Runs of one study in one folder at the same time."""

from __future__ import annotations

import time
from contextlib import ExitStack
from pathlib import Path
from random import Random

from faults.outcome import require, require_no_trace, require_told
from faults.processes import ended
from faults.study import begin, moment, require_goes_on, require_undisturbed


def two_runs(random: Random, folder: Path) -> None:
    """Two runs begin, one a little after the other. One plays, the other says that it may not."""
    with ExitStack() as stack:
        first = stack.enter_context(begin(folder, random.choice([1, 2])))
        time.sleep(moment(random) * random.random())
        second = stack.enter_context(begin(folder, random.choice([1, 2])))
        done = [ended(first), ended(second)]
    for each in done:
        require_told(each, [0, 2])
    played = [each for each in done if each.status == 0]
    require(bool(played), "neither run has played")
    require_undisturbed(folder, played[0])
    require_goes_on(folder)


def a_run_after_a_killed_one(random: Random, folder: Path) -> None:
    """A run begins the moment after another was killed, whose workers may still be there."""
    with begin(folder, 2) as first:
        time.sleep(moment(random, 2))
        first.kill()
        require_goes_on(folder, random.choice([1, 2]))
        require_no_trace(ended(first))
