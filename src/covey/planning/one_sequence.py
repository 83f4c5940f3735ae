"""Algorithm 1: the capture times of one capture sequence."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from covey.kernels.capture.sequence import capture_times as sequence_times
from covey.model import (
    PursuerDisk,
    Team,
)
from covey.model.validation import Floats, permutation
from covey.planning.border import about_center, check_players, paths_of, pursuit_of


def capture_times(
    team: Team, disk: PursuerDisk, turns: npt.ArrayLike, sequence: npt.ArrayLike
) -> Floats:
    """Least times at which a pursuer from the disk can capture the team in a given order.

    Parameters
    ----------
    team, disk
        The state of the game.
    turns
        (N,) signed turns δ, radians: each evader turns by δ at full rate, then flies straight
        (eq. 5).
    sequence
        (N,) each evader 0..N-1 once.

    Returns
    -------
    numpy.ndarray
        (N,) capture times in the order of `sequence`, not decreasing; the last is f_s of the paper.

    Raises
    ------
    InputError
        If an argument has the wrong shape or an evader is as fast as the pursuer.

    References
    ----------
    Algorithm 1 of the paper.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> covey.capture_times(team, disk, turns=[0.0, 0.0, 0.0], sequence=[0, 1, 2]).round(3).tolist()
    [0.422, 1.363, 3.523]
    """
    check_players(team, disk)
    order = permutation("sequence", sequence, len(team))
    team, disk = about_center(team, disk)
    times = np.empty(len(team))
    sequence_times(paths_of(team, disk, turns), pursuit_of(disk), order, times)
    return times
