"""Processes of a study that are killed or stopped."""

from __future__ import annotations

import logging
import time
from pathlib import Path
from random import Random
from signal import SIGCONT, SIGINT, SIGKILL, SIGSTOP, Signals

from faults.outcome import SkippedError, require_interrupted, require_no_trace, require_told
from faults.processes import COVEY, Run, ended, running, send, workers
from faults.study import (
    begin,
    begin_and_strike_at_file,
    command,
    describe_in,
    moment,
    require_goes_on,
    require_undisturbed,
    require_whole_files,
    undisturbed,
)


def kill_study(random: Random, folder: Path) -> None:
    """The study's process is killed at any moment, and its workers end with it."""
    count = random.choice([1, 2])
    with begin(folder, count) as process:
        time.sleep(moment(random, count))
        process.kill()
        require_no_trace(ended(process))
    require_whole_files(folder)
    require_goes_on(folder, random.choice([1, 2]))


def kill_at_file(random: Random, folder: Path) -> None:
    """The study's process is killed just before it opens, renames or removes a file."""
    with begin_and_strike_at_file(random, folder, SIGKILL) as process:
        require_no_trace(ended(process))
    require_whole_files(folder)
    require_goes_on(folder)


def kill_worker(random: Random, folder: Path) -> None:
    """Workers are killed. A chunk whose worker dies twice is told, and played by the next run."""
    with begin(folder, 2) as process:
        for _ in range(random.randint(1, 3)):
            time.sleep(moment(random, 2) / 2)
            _send_to_a_worker(process, random, SIGKILL)
        done = ended(process)
    if done.status == 0:
        require_undisturbed(folder, done)
    require_told(done, [0, 3])
    require_goes_on(folder)


def stop_worker(random: Random, folder: Path) -> None:
    """A worker is stopped; then it goes on, or the study is interrupted, or the study is killed."""
    then = random.choice([SIGCONT, SIGINT, SIGKILL])
    with begin(folder, 2) as process:
        time.sleep(moment(random, 2))
        stopped = _send_to_a_worker(process, random, SIGSTOP)
        time.sleep(random.uniform(0.0, 1.0))
        send(process.pid, then)
        if stopped is not None and then is not SIGINT:  # an interrupted study ends it itself
            send(stopped, SIGCONT)
        done = ended(process)
    if done.status == 0:
        require_undisturbed(folder, done)
    elif then is SIGINT:
        require_interrupted(done)
    require_no_trace(done)
    require_goes_on(folder)


def _send_to_a_worker(process: Run, random: Random, what: Signals) -> int | None:
    """Send a signal to a worker of the run, if it has any; return the worker's number."""
    found = workers(process.pid)
    if not found:
        return None
    chosen = random.choice(found)
    return chosen if send(chosen, what) else None


def kill_dask_worker(random: Random, folder: Path) -> None:
    """A worker of a Dask cluster is killed; the cluster replaces it, and nothing is lost."""
    try:
        import distributed
    except ImportError as error:
        raise SkippedError("covey[dask] isn't installed") from error
    describe_in(folder)
    with distributed.LocalCluster(
        n_workers=2,
        threads_per_worker=1,
        dashboard_address=None,
        silence_logs=logging.CRITICAL,
    ) as cluster:
        words = command("--dask", cluster.scheduler_address)
        with running(folder, *COVEY, *words) as process:
            time.sleep(random.uniform(0.0, 2.0 * undisturbed().seconds))
            nanny = random.choice(list(cluster.workers.values()))
            if nanny.pid is not None:  # None while the cluster replaces the worker
                send(nanny.pid, SIGKILL)
            require_undisturbed(folder, ended(process))
