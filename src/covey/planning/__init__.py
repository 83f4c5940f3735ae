"""Plans in open loop and plans that answer captures: what they guarantee, and the searches.

Read `one_sequence` (Algorithm 1) and `guarantee` (the inner half of eq. 6), then `open_loop_plan`
(what a plan is), `open_loop` (`plan` itself) and `multistart`. `contingent` is about plans that
answer captures. `border` and `compiled_objective` turn a game and an objective into the kernels'
form.
"""

from covey.planning.contingent import ContingentPlan, DelayedGuarantee, plan_contingent
from covey.planning.expectation import expected_survival
from covey.planning.guarantee import Guarantee, guaranteed_survival
from covey.planning.one_sequence import capture_times
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
