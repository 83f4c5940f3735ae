"""Bounds on what any team can guarantee, whatever its strategy.

Read `fixed_sequence` with `root_search`, then `announced_sequence`, `polygon_bound` with
`reachable_hull`, and `upper_end`, then `bracket`, which joins them, and `candidates`, which
compares sequences as a game goes on.
`two_evaders` stands alone: the true value of one small game.
"""

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
