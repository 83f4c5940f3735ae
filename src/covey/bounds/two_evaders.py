"""The yardstick: the true value of the game of two evaders, by dynamic programming on a grid."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from covey.kernels.two_evaders import Grid, set_upper_bound, set_upper_bounds, sweep
from covey.model import InputError, PursuerDisk, Team
from covey.model.validation import Floats, frozen_array, number, read_only, whole_number

_FEWEST_CELLS = 16
_FINENESS = 2.0
"""The grid's steps shrink by 1/cosh of this, 3.8 times, towards both evaders at one place."""

_MOST_SWEEPS = 20_000


@dataclass(frozen=True, eq=False)
class TwoEvaderValue:
    """The value of the game of two evaders with simple motion, and a pursuer that is seen.

    Attributes
    ----------
    speeds : numpy.ndarray
        (2,) the evaders' speeds, relative to the pursuer's.
    shares : numpy.ndarray
        (cells + 1, cells + 1) the value as a share, <= 1, of what it would be if the pursuer
        announced the better order; by balance atan2(b, a) from 0 to π/2, where a and b are the
        distances of the evaders, and by opening from 0 to π, the angle between them.
    sweeps : int
        Sweeps of the grid, and of the coarser ones that it begins and is extrapolated with.
    """

    speeds: Floats
    shares: Floats
    sweeps: int

    def at(self, offsets: npt.ArrayLike) -> Any:
        """Return the value by where the evaders are.

        Parameters
        ----------
        offsets
            (..., 2, 2) places of the two evaders, relative to the pursuer.

        Returns
        -------
        float or numpy.ndarray
            (...), times at pursuer speed 1. The shares are bilinear between the grid's points.
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
        return upper_bounds.reshape(opening.shape) * _between(
            self.shares,
            0.5 * cells * (1.0 + _shrunk(balance / (math.pi / 4.0) - 1.0)),
            cells * _shrunk(opening / math.pi),
        )

    def of(self, team: Team, disk: PursuerDisk) -> float:
        """Return the value of a game.

        Parameters
        ----------
        team, disk
            Two evaders of these speeds, unlimited turn rates, and a pursuer that is a point.

        Raises
        ------
        InputError
            If it is another game.
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
        Of the grid in each direction, >= 16. On 256 the value is known to some 0.02 % for pairs at
        random, and to 0.2 %, at worst 1 %, where the two are close to each other: by so much the
        value moves from 128 cells to 256 (docs/yardstick.md).
    tolerance
        Sweeps end when none changes a value, which are around 1, by more.

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
    can announce an order at any time, so the value never exceeds that of the better announced one,
    which is computed exactly; the grid holds the share that is left of it. The error of the sweeps
    halves as the cells double, so two grids are extrapolated.

    References
    ----------
    J. V. Breakwell, P. Hagedorn, "Point capture of two evaders in succession", Journal of
    Optimization Theory and Applications 27 (1979).
    """
    rates = frozen_array("speeds", speeds, (2,))
    if rates.min() < 0.0 or rates.max() >= 1.0:
        raise InputError(f"speeds: expected two numbers in [0, 1), got {rates.tolist()}")
    whole_number("cells", cells, low=_FEWEST_CELLS)
    number("tolerance", tolerance, low=0.0, strictly=True)
    sizes = [cells]
    while sizes[0] >= _FEWEST_CELLS:
        sizes.insert(0, sizes[0] // 2)
    fine, sweeps = np.ones((2, 2)), 0
    for size in sizes:
        coarse = _refined(fine, size)
        fine, count = _swept(rates, coarse, tolerance)
        sweeps += count
    # The error halves as the cells double: extrapolated, most of it goes.
    shares = np.minimum(2.0 * fine - coarse, 1.0)
    return TwoEvaderValue(rates, read_only(shares), sweeps)


def _swept(speeds: Floats, shares: Floats, tolerance: float) -> tuple[Floats, int]:
    """Sweep shares until they stand still; return them, and after how many sweeps."""
    cells, (v1, v2) = len(shares) - 1, speeds.tolist()
    balances, balance_steps = _stretched(cells, -1.0, math.pi / 4.0)
    balances += math.pi / 4.0
    openings, opening_steps = _stretched(cells, 0.0, math.pi)
    grid = Grid(balances, balance_steps, openings, opening_steps)
    upper_bound = np.empty(shares.shape)
    set_upper_bound(grid, v1, v2, upper_bound)
    values = shares * upper_bound
    for count in range(1, _MOST_SWEEPS):
        change = sweep(values, upper_bound, grid, v1, v2)
        if change < tolerance:
            return values / upper_bound, count
    raise InputError(f"tolerance: expected a larger one, got {tolerance:g}: sweeps don't reach it")


def _refined(shares: Floats, cells: int) -> Floats:
    """Interpolate between the points of a grid of half as many cells."""
    places = np.linspace(0.0, len(shares) - 1.0, cells + 1)
    return _between(shares, places[:, np.newaxis], places)


def _stretched(cells: int, low: float, scale: float) -> tuple[Floats, Floats]:
    """Points from `low` to 1 times `scale`, dense around 0, and the steps between them."""
    even = np.linspace(low, 1.0, cells + 1)
    points = np.sinh(_FINENESS * even) / math.sinh(_FINENESS)
    slopes = _FINENESS * np.cosh(_FINENESS * even) / math.sinh(_FINENESS)
    return scale * points, scale * slopes * (1.0 - low) / cells


def _shrunk(points: Floats) -> Floats:
    """Undo the stretching: even places in [-1, 1]."""
    return np.arcsinh(points * math.sinh(_FINENESS)) / _FINENESS


def _between(table: Floats, rows: Floats, columns: Floats) -> Floats:
    """Interpolate bilinearly at fractional rows and columns."""
    last = len(table) - 1
    i = np.clip(rows.astype(np.int64), 0, last - 1)
    j = np.clip(columns.astype(np.int64), 0, last - 1)
    p, q = rows - i, columns - j
    return (
        (1.0 - p) * ((1.0 - q) * table[i, j] + q * table[i, j + 1])
        + p * ((1.0 - q) * table[i + 1, j] + q * table[i + 1, j + 1])
    )  # fmt: skip
