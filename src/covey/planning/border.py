"""A team and a disk on their way to the kernels: checked, about the centre, as records."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from covey.kernels.arrays import MOST_EVADERS
from covey.kernels.capture.path import PATH, set_paths
from covey.kernels.capture.pursuit import Pursuit
from covey.model import (
    InputError,
    PursuerDisk,
    Team,
)
from covey.model.validation import Floats, checked_array, require_kind


def check_players(team: Team, disk: PursuerDisk) -> None:
    """Raise InputError unless these are a team and a disk that fit, and every evader is slower."""
    require_kind("team", team, Team)
    require_kind("disk", disk, PursuerDisk)
    if team.unit and disk.unit and team.unit != disk.unit:
        raise InputError(
            f"unit: expected the same for the team and the disk, got {team.unit!r} and "
            f"{disk.unit!r}; nothing is converted"
        )
    disk.require_faster_than(team)


def check_game(team: Team, disk: PursuerDisk) -> None:
    """Raise InputError as `check_players` does, or if the team has too many evaders."""
    check_players(team, disk)
    if len(team) > MOST_EVADERS:
        raise InputError(f"team: expected at most {MOST_EVADERS} evaders, got {len(team)}")


def about_center(team: Team, disk: PursuerDisk) -> tuple[Team, PursuerDisk]:
    """Return the team and the disk in the frame whose origin is the disk's centre.

    There the rounding of positions is relative to the size of the game, wherever the game is.
    """
    if disk.center.tolist() == [0.0, 0.0]:
        return team, disk
    return team.moved(-disk.center), disk.moved(-disk.center)


def pursuit_of(disk: PursuerDisk) -> Pursuit:
    """Return the pursuer in the kernels' form."""
    x, y = disk.center.tolist()
    reach = disk.capture_radius
    return Pursuit(x, y, disk.radius + reach, 2.0 * reach, disk.speed)


def paths_of(team: Team, disk: PursuerDisk, turns: npt.ArrayLike) -> Floats:
    """Return the paths (N, PATH), in the kernels' form, of a team that makes `turns` (N,)."""
    checked = checked_array("turns", turns, (len(team),))
    paths = np.empty((len(team), PATH))
    set_paths(team.as_rows(), checked, disk.speed, paths)
    return paths


def longest_game(team: Team, disk: PursuerDisk) -> float:
    """Return a time by which a pursuer that keeps to any one sequence has captured everybody.

    An evader at distance d is captured within d / (v_p - v). Meanwhile the distance to the next
    evader grows by no more than both can fly.
    """
    offsets = team.positions - disk.center
    farthest = float(np.hypot(offsets[:, 0], offsets[:, 1]).max()) + disk.radius
    fastest = float(team.speeds.max())
    longest = 0.0
    for _ in range(len(team)):
        gap = 2.0 * farthest + (disk.speed + fastest) * longest
        longest += gap / (disk.speed - fastest)
    return longest
