"""What a game is: the team, the pursuer's disk, the objective. Values are frozen and checked.

Read `team`, `pursuer_disk` and `objectives`; `angles` and `validation` serve them and all rooms,
`value` and `display` say how values compare and look.
"""

from covey.model.angles import turns_to, wrap_angle
from covey.model.objectives import (
    ExpectedSurvival,
    LastCapture,
    Objective,
    TotalSurvival,
    objective_value,
)
from covey.model.pursuer_disk import PursuerDisk
from covey.model.team import Team
from covey.model.validation import InputError

__all__ = [
    "ExpectedSurvival",
    "InputError",
    "LastCapture",
    "Objective",
    "PursuerDisk",
    "Team",
    "TotalSurvival",
    "objective_value",
    "turns_to",
    "wrap_angle",
]
