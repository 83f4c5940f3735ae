"""The open-loop plan: what it guarantees, and the best one."""

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
