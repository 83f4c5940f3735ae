"""All faults, and at how many moments `make faults` tries each."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from random import Random
from typing import TypeAlias

from faults import company, cuts, disks, interrupts, kernel_cache, kills

Fault: TypeAlias = Callable[[Random, Path], None]
"""A fault at a random moment, in an empty folder. Raises FaultError, or SkippedError."""

FAULTS: dict[Fault, int] = {
    kills.kill_study: 100,
    kills.kill_at_file: 60,
    kills.kill_worker: 30,
    kills.stop_worker: 30,
    kills.kill_dask_worker: 5,
    interrupts.interrupt_study: 60,
    interrupts.interrupt_at_file: 40,
    interrupts.interrupt_calls: 9,
    disks.full_disk: 30,
    disks.long_file: 30,
    disks.full_disk_for_a_game: 10,
    disks.read_only: 10,
    cuts.damaged_parts: 40,
    cuts.cut_manifest: 10,
    company.two_runs: 20,
    company.a_run_after_a_killed_one: 10,
    kernel_cache.cut_kernels: 1,
    kernel_cache.two_builds: 1,
    kernel_cache.full_cache: 1,
    kernel_cache.read_only_home: 1,
}
"""The faults, and their moments."""


def name_of(fault: Fault) -> str:
    """Return the name of a fault on the command line."""
    return fault.__name__.replace("_", "-")


def try_at(fault: Fault, seed: int, folder: Path) -> None:
    """Try a fault at the moment that belongs to a seed."""
    fault(Random(f"{name_of(fault)} {seed}"), folder)
