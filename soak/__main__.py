"""The command line: `python -m soak --help`."""

from __future__ import annotations

import argparse
import os
import random
import sys
import time
from contextlib import closing
from pathlib import Path

from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

from soak.summary import Summary
from soak.trial import ViolationError, play
from soak.workers import reports

SAVE_EVERY = 60.0
"""Seconds after which the figures until now are saved, so that nothing takes them away."""


def main(arguments=None):
    """Play, and return the exit status."""
    asked = _parser().parse_args(arguments)
    if asked.seed is not None:
        return play_one(asked.seed)
    first = random.randrange(10**12) if asked.first is None else asked.first
    return soak(asked, Summary(first, asked.workers))


def play_one(seed):
    """Play the game of a seed, and show what came of it."""
    try:
        trial = play(seed)
    except ViolationError as violation:
        print(violation)
        return 1
    for check, error in sorted(trial.errors.items()):
        print(f"{error:.1e}  {check}")
    return 0


def soak(asked, summary):
    """Play until the time or the games are used up, a game fails, or Ctrl-C; save and tell."""
    interrupted = False
    columns = (TextColumn("{task.description}"), BarColumn(), TimeRemainingColumn())
    try:
        with Progress(*columns, transient=True) as progress:
            _play(asked, summary, progress)
    except KeyboardInterrupt:
        interrupted = True
    summary.save(asked.output)
    print(summary.text())
    print(f"saved in {asked.output}")
    if summary.failure is not None:
        return 1
    return 130 if interrupted else 0


def _play(asked, summary, progress):
    last = None if asked.games is None else summary.first + asked.games
    seconds = 3600.0 * asked.hours if asked.games is None else None
    bar = progress.add_task("starting", total=asked.games or seconds)
    saved = time.monotonic()
    with closing(reports(summary.first, last, asked.workers)) as told:
        for report in told:
            summary.add(report)
            done = summary.totals.games if seconds is None else summary.seconds()
            progress.update(bar, completed=done, description=summary.line())
            if summary.failure is not None or (seconds is not None and done >= seconds):
                return
            if time.monotonic() - saved > SAVE_EVERY:
                summary.save(asked.output)
                saved = time.monotonic()


def _parser():
    parser = argparse.ArgumentParser(
        prog="python -m soak",
        description="Play random games of all players, and check each against the rules.",
    )
    parser.add_argument("--hours", type=float, default=1.0, help="how long to play (1)")
    parser.add_argument("--games", type=int, help="how many games to play, instead of a time")
    parser.add_argument("--first", type=int, help="the first seed; else it is drawn")
    parser.add_argument("--seed", type=int, help="play only the game of this seed, and show it")
    parser.add_argument(
        "--workers", type=int, default=os.cpu_count(), help="processes (one for each core)"
    )
    parser.add_argument(
        "--output", type=Path, default=Path("results/soak.json"), help="(results/soak.json)"
    )
    return parser


if __name__ == "__main__":
    sys.exit(main())
