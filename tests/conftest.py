"""The frames in which games are tested, and how the properties are drawn.

The examples are the same in every run, so that a failure is never luck.

`pytest --hypothesis-profile=thorough` draws new and many more ones, to look for trouble.
"""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, settings

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
