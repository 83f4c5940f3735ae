"""Plans how a team of turn-limited vehicles survives, as a team, against a faster hidden pursuer.

Every public name is listed here and imported when it is first used, so that `import covey` stays
quick and doesn't load the compiler.

After S.-Y. Liu, Z. Zhou, C. Tomlin and J. K. Hedrick, "Evasion of a Team of Dubins Vehicles from a
Hidden Pursuer", ICRA 2014.
"""

from __future__ import annotations

import warnings
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from covey.bounds import Bracket as Bracket
    from covey.bounds import SequencePlan as SequencePlan
    from covey.bounds import bracket as bracket
    from covey.bounds import plan_for_sequence as plan_for_sequence
    from covey.model import ExpectedSurvival as ExpectedSurvival
    from covey.model import InputError as InputError
    from covey.model import LastCapture as LastCapture
    from covey.model import PursuerDisk as PursuerDisk
    from covey.model import Team as Team
    from covey.model import TotalSurvival as TotalSurvival
    from covey.model import turns_to as turns_to
    from covey.planning import Guarantee as Guarantee
    from covey.planning import Plan as Plan
    from covey.planning import PlanStatus as PlanStatus
    from covey.planning import capture_times as capture_times
    from covey.planning import expected_survival as expected_survival
    from covey.planning import guaranteed_survival as guaranteed_survival
    from covey.planning import plan as plan
    from covey.players import BestSequence as BestSequence
    from covey.players import CommittedPursuer as CommittedPursuer
    from covey.players import ConstantHeading as ConstantHeading
    from covey.players import FixedSequence as FixedSequence
    from covey.players import FlyingPursuer as FlyingPursuer
    from covey.players import HoldCourse as HoldCourse
    from covey.players import IterativeOpenLoop as IterativeOpenLoop
    from covey.players import KnownSequence as KnownSequence
    from covey.players import LargestDistance as LargestDistance
    from covey.players import NearestFirst as NearestFirst
    from covey.players import OpenLoop as OpenLoop
    from covey.players import RandomSequence as RandomSequence
    from covey.players import SmallestDanger as SmallestDanger
    from covey.players import StraightAway as StraightAway
    from covey.players import UncommittedPursuer as UncommittedPursuer
    from covey.players import WorstCase as WorstCase
    from covey.players import simulate as simulate
    from covey.players import worst_case as worst_case
    from covey.scenarios import Scenario as Scenario
    from covey.scenarios import load_scenario as load_scenario
    from covey.simulation import Chase as Chase
    from covey.simulation import Fly as Fly
    from covey.simulation import Game as Game
    from covey.simulation import GameStatus as GameStatus
    from covey.simulation import Situation as Situation
    from covey.simulation import load_game as load_game
    from covey.simulation import save_game as save_game
    from covey.studies import Study as Study
    from covey.studies import load_study as load_study
    from covey.studies import run_study as run_study

_ROOMS = {
    "covey.model": (
        "ExpectedSurvival",
        "InputError",
        "LastCapture",
        "PursuerDisk",
        "Team",
        "TotalSurvival",
        "turns_to",
    ),
    "covey.bounds": ("Bracket", "SequencePlan", "bracket", "plan_for_sequence"),
    "covey.planning": (
        "Guarantee",
        "Plan",
        "PlanStatus",
        "capture_times",
        "expected_survival",
        "guaranteed_survival",
        "plan",
    ),
    "covey.players": (
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
        "RandomSequence",
        "SmallestDanger",
        "StraightAway",
        "UncommittedPursuer",
        "WorstCase",
        "simulate",
        "worst_case",
    ),
    "covey.scenarios": ("Scenario", "load_scenario"),
    "covey.simulation": (
        "Chase",
        "Fly",
        "Game",
        "GameStatus",
        "Situation",
        "load_game",
        "save_game",
    ),
    "covey.studies": ("Study", "load_study", "run_study"),
}
_HOME = {name: room for room, names in _ROOMS.items() for name in names}

__all__ = sorted(_HOME)


def __getattr__(name: str) -> object:
    """Import a public name from its room when it is first asked for."""
    if name == "__version__":
        from importlib.metadata import version  # it costs more than all the rest

        return version("covey")
    if name == "envs":  # the one room that is used by its name; it needs covey[env]
        return import_module("covey.envs")
    if name == "PatientPursuer":  # for one release
        note = "covey.PatientPursuer is now called covey.UncommittedPursuer"
        warnings.warn(note, DeprecationWarning, stacklevel=2)
        name = "UncommittedPursuer"
    if name not in _HOME:
        raise AttributeError(f"module 'covey' has no attribute {name!r}")
    value = getattr(import_module(_HOME[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
