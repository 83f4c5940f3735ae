"""Strategies that come with the package, and `simulate`, which plays them."""

from covey.players.constant_heading import ConstantHeading
from covey.players.evaders import IterativeOpenLoop, OpenLoop
from covey.players.headings import HoldCourse, StraightAway
from covey.players.known_sequence import KnownSequence
from covey.players.largest_distance import LargestDistance
from covey.players.nearest_first import NearestFirst
from covey.players.outcome import Outcome, survival
from covey.players.pursuers import CommittedPursuer, FlyingPursuer, PatientPursuer
from covey.players.sequences import BestSequence, FixedSequence, RandomSequence
from covey.players.simulate import simulate
from covey.players.smallest_danger import SmallestDanger

__all__ = [
    "BestSequence",
    "CommittedPursuer",
    "ConstantHeading",
    "FixedSequence",
    "FlyingPursuer",
    "HoldCourse",
    "IterativeOpenLoop",
    "KnownSequence",
    "LargestDistance",
    "NearestFirst",
    "OpenLoop",
    "Outcome",
    "PatientPursuer",
    "RandomSequence",
    "SmallestDanger",
    "StraightAway",
    "simulate",
    "survival",
]
