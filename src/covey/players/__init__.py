"""Strategies that come with the package, and `simulate`, which plays them."""

from covey.players.constant_heading import ConstantHeading
from covey.players.delayed import DelayedSequence
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
from covey.players.two_evaders import DownhillPursuer
from covey.players.worst_case import WorstCase, WorstCaseScope, worst_case

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
    "Outcome",
    "PatientPursuer",
    "RandomSequence",
    "SmallestDanger",
    "StraightAway",
    "WorstCase",
    "WorstCaseScope",
    "simulate",
    "survival",
    "worst_case",
]
