"""Bugs that a competent person could make, each in one place, written down before any was tried.

Each bug is wrong for a user: it changes a result, drops a check or loses work. None of them only
changes words or speed. A file has the bugs of a room.
"""

from mutants.bugs import (
    bounds,
    cli,
    envs,
    kernels,
    model,
    planning,
    players,
    scenarios,
    simulation,
    studies,
    views,
    web,
)

ROOMS = (
    kernels,
    model,
    planning,
    bounds,
    simulation,
    players,
    scenarios,
    studies,
    views,
    envs,
    web,
    cli,
)
BUGS = tuple(bug for room in ROOMS for bug in room.BUGS)
