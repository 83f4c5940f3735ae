"""The frames in which games are tested, large teams in small, and how the properties are drawn.

The examples are the same in every run, so that a failure is never luck.

`pytest --hypothesis-profile=thorough` draws new and many more ones, to look for trouble.
"""

from __future__ import annotations

import functools

import pytest
from hypothesis import HealthCheck, settings

from covey.kernels.arrays import new_workspace
from covey.planning import workspace as workspaces
from frames import FRAMES

# No deadline: the first example of a run may have to wait for the compiler.
_COMMON = {"deadline": None, "suppress_health_check": [HealthCheck.too_slow]}

settings.register_profile("same", derandomize=True, database=None, max_examples=200, **_COMMON)
settings.register_profile("thorough", max_examples=5000, **_COMMON)
settings.load_profile("same")


@pytest.fixture(params=FRAMES.values(), ids=FRAMES)
def frame(request):
    """Where a game is, how it is turned, and its units: none of them may matter."""
    return request.param


@pytest.fixture
def without_tables(monkeypatch):
    """Plans of four evaders and more are those of large teams, and the minimum keeps no table."""

    def replace_workspaces(largest_table=3):
        walking = functools.partial(new_workspace, fewest_walking=4, largest_table=largest_table)
        monkeypatch.setattr(workspaces, "new_workspace", walking)
        workspaces._kept.__dict__.clear()

    yield replace_workspaces
    workspaces._kept.__dict__.clear()
