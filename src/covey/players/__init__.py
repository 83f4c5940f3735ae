"""Strategies that come with the package, and `simulate`, which plays them."""

from covey.players.delayed import DelayedSequence
from covey.players.evaders import IterativeOpenLoop, OpenLoop
from covey.players.outcome import Outcome, survival
from covey.players.pursuers import CommittedPursuer, FixedSequence
from covey.players.simulate import simulate
from covey.players.two_evaders import DownhillPursuer
from covey.players.worst_case import WorstCase, WorstCaseScope, worst_case

__all__ = [
    "CommittedPursuer",
    "DelayedSequence",
    "DownhillPursuer",
    "FixedSequence",
    "IterativeOpenLoop",
    "OpenLoop",
    "Outcome",
    "WorstCase",
    "WorstCaseScope",
    "simulate",
    "survival",
    "worst_case",
]
