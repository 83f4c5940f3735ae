"""Means of any number of games and their confidence intervals, in constant memory.

Every start is played in every case, so the cases are correlated. Their covariances are kept: with
them the interval of a ratio of two means is much narrower than those of the means.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from covey.model.validation import Floats, Ints

if TYPE_CHECKING:
    import pyarrow as pa

Z95 = 1.959963984540054
"""Half width of a 95 % interval of a normal distribution, in standard deviations."""


class Estimate(NamedTuple):
    """A number, and the half width of its 95 % confidence interval."""

    value: float
    error: float


UNKNOWN = Estimate(float("nan"), float("nan"))


class Moments(NamedTuple):
    """Means and covariances in K cases, over the starts whose games all ended."""

    starts: int  # all that were played
    ended: int  # starts whose games all ended
    stopped: Ints  # (K,) games that were stopped at their time limit
    mean: Floats  # (K,)
    scatter: Floats  # (K, K) sums of products of deviations from the means
    guarantee: Floats  # (K,) mean guarantee of the first plans, over all starts

    def average(self, case: int) -> Estimate:
        """Return the mean of a case with its normal 95 % interval."""
        if self.ended == 0:
            return UNKNOWN
        return Estimate(float(self.mean[case]), self._half_width(self.scatter[case, case]))

    def ratio(self, case: int, base: int) -> Estimate:
        """Return mean over mean, with the 95 % interval of the delta method for paired samples.

        To first order the ratio of means R = y/x varies as the mean of (y_i - R x_i) / x.
        """
        if self.ended == 0:
            return UNKNOWN
        ratio = float(self.mean[case] / self.mean[base])
        scatter = self.scatter
        spread = scatter[case, case] - 2.0 * ratio * scatter[case, base]
        spread += ratio**2 * scatter[base, base]
        return Estimate(ratio, self._half_width(max(spread, 0.0)) / float(self.mean[base]))

    def _half_width(self, scatter: float) -> float:
        if self.ended < 2:
            return float("nan")
        return Z95 * float(np.sqrt(scatter / (self.ended - 1) / self.ended))


def moments_of(parts: Iterable[pa.Table], cases: int, column: str = "survival_time") -> Moments:
    """Return means and covariances of a column of the games.

    Each part is a table of whole starts, `cases` rows a start. A value that is not finite counts as
    a game that was stopped.
    """
    zeros = np.zeros(cases)
    total = Moments(0, 0, zeros.astype(np.int64), zeros, np.zeros((cases, cases)), zeros)
    for part in parts:
        values = part[column].to_numpy().reshape(-1, cases)
        guarantees = part["guarantee"].to_numpy().reshape(-1, cases)
        total = _joined(total, _of_sample(values, guarantees))
    return total


def _of_sample(values: Floats, guarantees: Floats) -> Moments:
    finite = np.isfinite(values)
    whole = values[finite.all(axis=1)]
    mean = whole.mean(axis=0) if len(whole) else np.zeros(values.shape[1])
    off = whole - mean
    stopped, scatter = (~finite).sum(axis=0), off.T @ off
    return Moments(len(values), len(whole), stopped, mean, scatter, guarantees.mean(axis=0))


def _joined(a: Moments, b: Moments) -> Moments:
    """Join two samples without cancellation (Chan, Golub and LeVeque 1979)."""
    starts, ended = a.starts + b.starts, a.ended + b.ended
    share = b.ended / ended if ended else 0.0
    step = b.mean - a.mean
    return Moments(
        starts,
        ended,
        a.stopped + b.stopped,
        a.mean + share * step,
        a.scatter + b.scatter + a.ended * share * np.outer(step, step),
        a.guarantee + b.starts / max(starts, 1) * (b.guarantee - a.guarantee),
    )
