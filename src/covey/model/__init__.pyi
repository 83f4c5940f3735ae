"""The public names of this room, each with the file that it comes from."""

from .angles import turns_to as turns_to
from .angles import wrap_angle as wrap_angle
from .objectives import ExpectedSurvival as ExpectedSurvival
from .objectives import LastCapture as LastCapture
from .objectives import Objective as Objective
from .objectives import TotalSurvival as TotalSurvival
from .objectives import objective_value as objective_value
from .pursuer_disk import PursuerDisk as PursuerDisk
from .team import Team as Team
from .validation import InputError as InputError
