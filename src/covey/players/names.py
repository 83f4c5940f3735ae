"""The strategies that come with the package, by the names that scenario files know."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from covey.model.validation import choice
from covey.players.pursuers.assured import AssuredPursuer
from covey.players.pursuers.committed import CommittedPursuer, FlyingPursuer, UncommittedPursuer
from covey.players.pursuers.fixed_order import BestSequence, FixedSequence, RandomSequence
from covey.players.pursuers.nearest_first import NearestFirst
from covey.players.teams.constant_heading import ConstantHeading
from covey.players.teams.contingent import Contingent
from covey.players.teams.known_sequence import KnownSequence
from covey.players.teams.largest_distance import LargestDistance
from covey.players.teams.open_loop import IterativeOpenLoop, OpenLoop
from covey.players.teams.simple import HoldCourse, StraightAway
from covey.players.teams.smallest_danger import SmallestDanger
from covey.simulation import PursuerPolicy, PursuerStrategy, TeamPolicy, TeamStrategy

TEAMS: Mapping[str, Callable[..., TeamStrategy]] = {
    "open-loop": OpenLoop,
    "iterative-open-loop": IterativeOpenLoop,
    "contingent": Contingent,
    "constant-heading": ConstantHeading,
    "straight-away": StraightAway,
    "hold-course": HoldCourse,
    "known-sequence": KnownSequence,
    "largest-distance": LargestDistance,
    "smallest-danger": SmallestDanger,
}

PURSUERS: Mapping[str, Callable[..., PursuerStrategy]] = {
    "committed": CommittedPursuer,
    "flying": FlyingPursuer,
    "patient": UncommittedPursuer,
    "fixed-sequence": FixedSequence,
    "best-sequence": BestSequence,
    "assured": AssuredPursuer,
    "random-sequence": RandomSequence,
    "nearest-first": NearestFirst,
}


def team_strategy(evaders: TeamStrategy | TeamPolicy | str) -> TeamStrategy | TeamPolicy:
    """Return the strategy of this name with its defaults; what is no name, as it is.

    Raises
    ------
    InputError
        If no strategy has this name.
    """
    if isinstance(evaders, str):
        return TEAMS[choice("evaders", evaders, list(TEAMS))]()
    return evaders


def pursuer_strategy(
    pursuer: PursuerStrategy | PursuerPolicy | str,
) -> PursuerStrategy | PursuerPolicy:
    """Return the strategy of this name with its defaults; what is no name, as it is.

    Raises
    ------
    InputError
        If no strategy has this name.
    """
    if isinstance(pursuer, str):
        return PURSUERS[choice("pursuer", pursuer, list(PURSUERS))]()
    return pursuer
