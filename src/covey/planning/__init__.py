"""The open-loop plan: the survival time that it guarantees, and the search for the best plan.

Read `guarantee` (the inner half of eq. 6), then `open_loop`, `plan` itself, then `multistart`.
`compiled_objective` turns an objective into the kernels' form.
"""

from covey.planning.guarantee import (
    Guarantee,
    capture_times,
    expected_survival,
    guaranteed_survival,
)
from covey.planning.open_loop import Plan, PlanStatus, plan

__all__ = [
    "Guarantee",
    "Plan",
    "PlanStatus",
    "capture_times",
    "expected_survival",
    "guaranteed_survival",
    "plan",
]
