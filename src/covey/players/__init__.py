"""Strategies that come with the package, and `simulate`, which plays them."""

from covey.players.evaders import IterativeOpenLoop, OpenLoop
from covey.players.outcome import Outcome, survival
from covey.players.pursuers import CommittedPursuer, FixedSequence
from covey.players.simulate import simulate

__all__ = [
    "CommittedPursuer",
    "FixedSequence",
    "IterativeOpenLoop",
    "OpenLoop",
    "Outcome",
    "simulate",
    "survival",
]
