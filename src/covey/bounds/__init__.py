"""What no team can exceed: the bracket, the flight for a known sequence, two evaders' value."""

from covey.bounds.bracket import Bracket, bracket
from covey.bounds.fixed_sequence import SequencePlan, SequenceStatus, plan_for_sequence
from covey.bounds.two_evaders import TwoEvaderValue, solve_two_evaders

__all__ = [
    "Bracket",
    "SequencePlan",
    "SequenceStatus",
    "TwoEvaderValue",
    "bracket",
    "plan_for_sequence",
    "solve_two_evaders",
]
