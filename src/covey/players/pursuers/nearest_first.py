"""The greedy pursuer."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from covey.simulation import Chase, PursuerPolicy, Situation


@dataclass(frozen=True)
class NearestFirst:
    """Make for the nearest evader until it is captured, then for the next nearest.

    A pursuer that is a disk only takes the evader nearest to the disk's centre.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> game = covey.simulate(team, disk, pursuer=covey.NearestFirst())
    >>> game.capture_sequence.tolist()
    [0, 1, 2]
    """

    def describe(self) -> Mapping[str, Any]:
        """Return the name, as a scenario file gives it."""
        return {"name": "nearest-first"}

    def start(self, seed: int) -> PursuerPolicy:  # noqa: ARG002 the protocol's signature
        """Return the policy of one game."""
        target = -1

        def decide(situation: Situation) -> Chase:
            nonlocal target
            if target not in situation.evaders:
                off = situation.team.positions - situation.pursuer.center
                target = situation.evaders[int(np.hypot(off[:, 0], off[:, 1]).argmin())]
            return Chase((target,))

        return decide
