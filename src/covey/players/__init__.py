"""Strategies that come with the package, and `simulate`, which plays them.

Read `teams.open_loop` and `pursuers.committed`, the paper's two players, then `simulate` and
`compiled`; `worst_case` searches the tree of all capture sequences.
"""

from covey.players.pursuers.committed import CommittedPursuer, FlyingPursuer, UncommittedPursuer
from covey.players.pursuers.delayed import DelayedSequence
from covey.players.pursuers.downhill import DownhillPursuer
from covey.players.pursuers.fixed_order import BestSequence, FixedSequence, RandomSequence
from covey.players.pursuers.nearest_first import NearestFirst
from covey.players.simulate import simulate, survival
from covey.players.teams.constant_heading import ConstantHeading
from covey.players.teams.known_sequence import KnownSequence
from covey.players.teams.largest_distance import LargestDistance
from covey.players.teams.open_loop import IterativeOpenLoop, OpenLoop
from covey.players.teams.simple import HoldCourse, StraightAway
from covey.players.teams.smallest_danger import SmallestDanger
from covey.players.worst_case import WorstCase, WorstCaseScope, worst_case

PatientPursuer = UncommittedPursuer
"""The name until version 0.1; it says the opposite of what this pursuer does."""

__all__ = [
    "BestSequence",
    "CommittedPursuer",
    "ConstantHeading",
    "DelayedSequence",
    "DownhillPursuer",
    "FixedSequence",
    "FlyingPursuer",
    "HoldCourse",
    "IterativeOpenLoop",
    "KnownSequence",
    "LargestDistance",
    "NearestFirst",
    "OpenLoop",
    "PatientPursuer",
    "RandomSequence",
    "SmallestDanger",
    "StraightAway",
    "UncommittedPursuer",
    "WorstCase",
    "WorstCaseScope",
    "simulate",
    "survival",
    "worst_case",
]
