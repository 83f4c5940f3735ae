"""How the properties are drawn: the same examples in every run, so that a failure is never luck.

`pytest --hypothesis-profile=thorough` draws new and many more ones, to look for trouble.
"""

from __future__ import annotations

from hypothesis import HealthCheck, settings

# No deadline: the first example of a run may have to wait for the compiler.
_COMMON = {"deadline": None, "suppress_health_check": [HealthCheck.too_slow]}

settings.register_profile("same", derandomize=True, database=None, max_examples=200, **_COMMON)
settings.register_profile("thorough", max_examples=5000, **_COMMON)
settings.load_profile("same")
