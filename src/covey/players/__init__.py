"""The strategies that come with the package, and the functions that play them.

Teams and pursuers stand in rooms of their own; neither knows how a game is played. Read `teams` and
`pursuers`, then `names`, `compiled` (games played by the kernels), `simulate` and `worst_case`.
"""

from covey.players.pursuers.assured import AssuredPursuer
from covey.players.pursuers.committed import CommittedPursuer, FlyingPursuer, UncommittedPursuer
from covey.players.pursuers.delayed import DelayedSequence
from covey.players.pursuers.downhill import DownhillPursuer
from covey.players.pursuers.fixed_order import BestSequence, FixedSequence, RandomSequence
from covey.players.pursuers.nearest_first import NearestFirst
from covey.players.simulate import simulate, survival
from covey.players.teams.constant_heading import ConstantHeading
from covey.players.teams.contingent import Contingent
from covey.players.teams.known_sequence import KnownSequence
from covey.players.teams.largest_distance import LargestDistance
from covey.players.teams.open_loop import IterativeOpenLoop, OpenLoop
from covey.players.teams.simple import HoldCourse, StraightAway
from covey.players.teams.smallest_danger import SmallestDanger
from covey.players.worst_case import WorstCase, WorstCaseScope, worst_case
from covey.simulation import Outcome

__all__ = [
    "AssuredPursuer",
    "BestSequence",
    "CommittedPursuer",
    "ConstantHeading",
    "Contingent",
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
    "Outcome",
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
