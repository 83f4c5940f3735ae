"""The public names, each with the room that it comes from.

`__init__.py` imports a name when it is first used. Type checkers read this file too.
"""

from .bounds import Bracket as Bracket
from .bounds import SequencePlan as SequencePlan
from .bounds import bracket as bracket
from .bounds import plan_for_sequence as plan_for_sequence
from .instances import Instance as Instance
from .instances import load_instance as load_instance
from .model import ExpectedSurvival as ExpectedSurvival
from .model import InputError as InputError
from .model import LastCapture as LastCapture
from .model import PursuerDisk as PursuerDisk
from .model import Team as Team
from .model import TotalSurvival as TotalSurvival
from .model import turns_to as turns_to
from .planning import ContingentPlan as ContingentPlan
from .planning import DelayedGuarantee as DelayedGuarantee
from .planning import Guarantee as Guarantee
from .planning import Plan as Plan
from .planning import PlanStatus as PlanStatus
from .planning import capture_times as capture_times
from .planning import expected_survival as expected_survival
from .planning import guaranteed_survival as guaranteed_survival
from .planning import plan as plan
from .planning import plan_contingent as plan_contingent
from .players import AssuredPursuer as AssuredPursuer
from .players import BestSequence as BestSequence
from .players import CommittedPursuer as CommittedPursuer
from .players import ConstantHeading as ConstantHeading
from .players import Contingent as Contingent
from .players import FixedSequence as FixedSequence
from .players import FlyingPursuer as FlyingPursuer
from .players import HoldCourse as HoldCourse
from .players import IterativeOpenLoop as IterativeOpenLoop
from .players import KnownSequence as KnownSequence
from .players import LargestDistance as LargestDistance
from .players import NearestFirst as NearestFirst
from .players import OpenLoop as OpenLoop
from .players import RandomSequence as RandomSequence
from .players import SmallestDanger as SmallestDanger
from .players import StraightAway as StraightAway
from .players import UncommittedPursuer as UncommittedPursuer
from .players import WorstCase as WorstCase
from .players import simulate as simulate
from .players import worst_case as worst_case
from .scenarios import Scenario as Scenario
from .scenarios import load_scenario as load_scenario
from .simulation import Chase as Chase
from .simulation import Fly as Fly
from .simulation import Game as Game
from .simulation import GameStatus as GameStatus
from .simulation import Situation as Situation
from .simulation import load_game as load_game
from .simulation import save_game as save_game
from .studies import Study as Study
from .studies import load_study as load_study
from .studies import run_study as run_study
from .views import animate as animate
from .views import draw as draw

__version__: str
