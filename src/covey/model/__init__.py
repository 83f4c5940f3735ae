"""What a game is: teams, the pursuer's disk, objectives, angles; frozen, checked when made."""

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
