"""The open-loop plan: what it guarantees, and the best one."""

from covey.planning.bracket import Bracket, bracket
from covey.planning.fixed_sequence import SequencePlan, SequenceStatus, plan_for_sequence
from covey.planning.guarantee import (
    Guarantee,
    capture_times,
    expected_survival,
    guaranteed_survival,
)
from covey.planning.open_loop import Plan, PlanStatus, plan
from covey.planning.two_evaders import TwoEvaderValue, solve_two_evaders

__all__ = [
    "Bracket",
    "Guarantee",
    "Plan",
    "PlanStatus",
    "SequencePlan",
    "SequenceStatus",
    "TwoEvaderValue",
    "bracket",
    "capture_times",
    "expected_survival",
    "guaranteed_survival",
    "plan",
    "plan_for_sequence",
    "solve_two_evaders",
]
