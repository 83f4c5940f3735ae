"""Plans in open loop and plans that answer captures: what they guarantee, and the searches.

Read `guarantee` (the inner half of eq. 6), then `open_loop_plan` (what a plan is), `open_loop`
(`plan` itself), then `multistart`. `contingent` is about plans that answer captures.
`compiled_objective` turns an objective into the kernels' form.
"""

from covey.planning.contingent import ContingentPlan, DelayedGuarantee, plan_contingent
from covey.planning.guarantee import (
    Guarantee,
    capture_times,
    expected_survival,
    guaranteed_survival,
)
from covey.planning.open_loop import plan
from covey.planning.open_loop_plan import Plan, PlanStatus

__all__ = [
    "ContingentPlan",
    "DelayedGuarantee",
    "Guarantee",
    "Plan",
    "PlanStatus",
    "capture_times",
    "expected_survival",
    "guaranteed_survival",
    "plan",
    "plan_contingent",
]
