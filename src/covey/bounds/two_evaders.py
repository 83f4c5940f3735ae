"""The true value of the game of two evaders, by dynamic programming on a grid."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from covey.kernels.bounds.two_evaders import Grid, set_upper_bound, set_upper_bounds, sweep
from covey.model import InputError, PursuerDisk, Team
from covey.model.validation import Floats, frozen_array, number, read_only, whole_number

_MIN_CELLS = 16
_GRADING = 2.0
"""The grid's steps shrink by 1/cosh of this, 3.8 times, towards both evaders at one position."""

_MAX_SWEEPS = 20_000


@dataclass(frozen=True, eq=False)
class TwoEvaderValue:
    """The value of the game of two evaders with simple motion, and a pursuer that is seen.

    Attributes
    ----------
    speeds : numpy.ndarray
        (2,) the evaders' speeds, relative to the pursuer's.
    shares : numpy.ndarray
        (cells + 1, cells + 1) the value divided by the value of the better announced order, <= 1.
        Rows: the balance atan2(b, a) from 0 to π/2, where a and b are the distances of the evaders.
        Columns: the opening from 0 to π, the angle between the evaders as the pursuer sees them.
    sweeps : int
        Sweeps of this grid and of the coarser grids before it.
    """

    speeds: Floats
    shares: Floats
    sweeps: int

    def at(self, offsets: npt.ArrayLike) -> Any:
        """Return the value at positions of the evaders.

        Parameters
        ----------
        offsets
            (..., 2, 2) positions of the two evaders, relative to the pursuer.

        Returns
        -------
        float or numpy.ndarray
            (...), times at pursuer speed 1. The shares are interpolated bilinearly.
        """
        off = np.asarray(offsets, dtype=np.float64)
        distances = np.hypot(off[..., 0], off[..., 1])
        first, second = off[..., 0, :], off[..., 1, :]
        turned = first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]
        opening = np.arctan2(np.abs(turned), (first * second).sum(axis=-1))
        balance = np.arctan2(distances[..., 1], distances[..., 0])
        upper_bounds = np.empty(opening.size)
        situations = np.column_stack([distances.reshape(-1, 2), opening.ravel()])
        set_upper_bounds(situations, self.speeds[0], self.speeds[1], upper_bounds)
        cells = len(self.shares) - 1
        return upper_bounds.reshape(opening.shape) * _bilinear(
            self.shares,
            0.5 * cells * (1.0 + _undo_grading(balance / (math.pi / 4.0) - 1.0)),
            cells * _undo_grading(opening / math.pi),
        )

    def of(self, team: Team, disk: PursuerDisk) -> float:
        """Return the value of a game.

        Parameters
        ----------
        team, disk
            Two evaders of these speeds with unlimited turn rates; a pursuer of radius 0 and capture
            radius 0.

        Raises
        ------
        InputError
            If the game is another one.
        """
        if len(team) != 2 or not np.isinf(team.turn_rates).all():
            raise InputError(
                f"team: expected two evaders with infinite turn rates, got {len(team)} with "
                f"{team.turn_rates.tolist()}"
            )
        if disk.radius > 0.0 or disk.capture_radius > 0.0:
            raise InputError("disk: expected radius 0 and capture radius 0")
        if np.abs(team.speeds / disk.speed - self.speeds).max() > 1e-12:
            raise InputError(
                f"team: expected speeds {(self.speeds * disk.speed).tolist()}, "
                f"got {team.speeds.tolist()}"
            )
        return float(self.at(team.positions - disk.center)) / disk.speed


def solve_two_evaders(
    speeds: npt.ArrayLike, *, cells: int = 256, tolerance: float = 1e-7
) -> TwoEvaderValue:
    """Compute the value of the game of two evaders with simple motion and point capture.

    Parameters
    ----------
    speeds
        (2,) relative to the pursuer's, in [0, 1).
    cells
        Cells of the grid in each direction, >= 16. From 128 to 256 cells the value changes by some
        0.02 % for random pairs, and by 0.2 %, at most 1 %, for two that are close to each other
        (docs/yardstick.md).
    tolerance
        Sweeps end when none changes a value by more; values are around 1.

    Returns
    -------
    TwoEvaderValue

    Raises
    ------
    InputError
        If an argument can't be used, or the tolerance isn't reached.

    Notes
    -----
    After the first capture the value is the distance over the difference of the speeds. The pursuer
    can announce an order at any time, so the value of the better announced order is an upper bound.
    It is computed exactly; the grid holds the quotient of the value and this bound. The error of
    the grid halves as the cells double, so the values of two grids are extrapolated.

    References
    ----------
    J. V. Breakwell, P. Hagedorn, "Point capture of two evaders in succession", Journal of
    Optimization Theory and Applications 27 (1979).
    """
    rates = frozen_array("speeds", speeds, (2,))
    if rates.min() < 0.0 or rates.max() >= 1.0:
        raise InputError(f"speeds: expected two numbers in [0, 1), got {rates.tolist()}")
    whole_number("cells", cells, low=_MIN_CELLS)
    number("tolerance", tolerance, low=0.0, strictly=True)
    sizes = [cells]
    while sizes[0] >= _MIN_CELLS:
        sizes.insert(0, sizes[0] // 2)
    fine, sweeps = np.ones((2, 2)), 0
    for size in sizes:
        coarse = _refined(fine, size)
        fine, count = _swept(rates, coarse, tolerance)
        sweeps += count
    # The error halves as the cells double, so extrapolation removes most of it.
    shares = np.minimum(2.0 * fine - coarse, 1.0)
    return TwoEvaderValue(rates, read_only(shares), sweeps)


def _swept(speeds: Floats, shares: Floats, tolerance: float) -> tuple[Floats, int]:
    """Sweep until no value changes by more than `tolerance`; return shares and number of sweeps."""
    cells, (v1, v2) = len(shares) - 1, speeds.tolist()
    balances, balance_steps = _graded(cells, -1.0, math.pi / 4.0)
    balances += math.pi / 4.0
    openings, opening_steps = _graded(cells, 0.0, math.pi)
    grid = Grid(balances, balance_steps, openings, opening_steps)
    upper_bound = np.empty(shares.shape)
    set_upper_bound(grid, v1, v2, upper_bound)
    values = shares * upper_bound
    for count in range(1, _MAX_SWEEPS):
        change = sweep(values, upper_bound, grid, v1, v2)
        if change < tolerance:
            return values / upper_bound, count
    raise InputError(f"tolerance: expected a larger one, got {tolerance:g}: sweeps don't reach it")


def _refined(shares: Floats, cells: int) -> Floats:
    """Interpolate the shares of a coarser grid on one of `cells` cells."""
    rows = np.linspace(0.0, len(shares) - 1.0, cells + 1)
    return _bilinear(shares, rows[:, np.newaxis], rows)


def _graded(cells: int, low: float, scale: float) -> tuple[Floats, Floats]:
    """Return points from `low` to 1, times `scale`, dense around 0, and the steps between them."""
    even = np.linspace(low, 1.0, cells + 1)
    points = np.sinh(_GRADING * even) / math.sinh(_GRADING)
    slopes = _GRADING * np.cosh(_GRADING * even) / math.sinh(_GRADING)
    return scale * points, scale * slopes * (1.0 - low) / cells


def _undo_grading(points: Floats) -> Floats:
    """Return evenly spaced coordinates in [-1, 1] for points of a graded grid."""
    return np.arcsinh(points * math.sinh(_GRADING)) / _GRADING


def _bilinear(table: Floats, rows: Floats, columns: Floats) -> Floats:
    """Interpolate bilinearly at fractional rows and columns."""
    last = len(table) - 1
    i = np.clip(rows.astype(np.int64), 0, last - 1)
    j = np.clip(columns.astype(np.int64), 0, last - 1)
    p, q = rows - i, columns - j
    return (
        (1.0 - p) * ((1.0 - q) * table[i, j] + q * table[i, j + 1])
        + p * ((1.0 - q) * table[i + 1, j] + q * table[i + 1, j + 1])
    )  # fmt: skip
