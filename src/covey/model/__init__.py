"""What a game is: teams, the pursuer's disk, angles. Frozen, and checked on construction."""

from covey.model.angles import turns_to, wrap_angle
from covey.model.checks import InputError
from covey.model.disk import PursuerDisk
from covey.model.team import Team

__all__ = ["InputError", "PursuerDisk", "Team", "turns_to", "wrap_angle"]
