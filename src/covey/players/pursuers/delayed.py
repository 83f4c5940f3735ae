"""A hidden pursuer that keeps to a sequence, and delays some captures."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from covey.kernels.play.to_capture import contains, is_due
from covey.model import InputError
from covey.model.validation import checked_sequence, number
from covey.simulation import Chase, Fly, PursuerPolicy, Situation


@dataclass(frozen=True)
class DelayedSequence:
    """Capture the evaders in a given order, each some time after the disk has reached it.

    Until a capture, a team that doesn't see the pursuer can't know how near the pursuer is. So a
    pursuer that waits may learn more from the team's flight than the team learns from the capture.

    Parameters
    ----------
    sequence
        Each evader's number once.
    delays
        (N,) in the order of `sequence`, times >= 0. With 0 the capture comes as soon as the disk
        reaches the evader. With a delay d the capture comes at the first update that is at least d
        after the first update at which the disk holds the evader.
    """

    sequence: tuple[int, ...]
    delays: tuple[float, ...]

    def __init__(self, sequence: Sequence[int], delays: Sequence[float]) -> None:
        order = checked_sequence("DelayedSequence", sequence)
        waits = tuple(number("DelayedSequence.delays", delay, low=0.0) for delay in delays)
        if len(waits) != len(order):
            raise InputError(
                f"DelayedSequence: expected {len(order)} delays, one for each capture, "
                f"got {list(delays)}"
            )
        object.__setattr__(self, "sequence", order)
        object.__setattr__(self, "delays", waits)

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters."""
        return {
            "name": "delayed-sequence",
            "sequence": list(self.sequence),
            "delays": list(self.delays),
        }

    def start(self, seed: int) -> PursuerPolicy:  # noqa: ARG002 the protocol's signature
        """Return the policy of one game."""
        contained_since: dict[int, float] = {}

        def decide(situation: Situation) -> Chase | Fly:
            order = zip(self.sequence, self.delays, strict=True)
            ahead = [(i, delay) for i, delay in order if i in situation.evaders]
            target, delay = ahead[0]
            disk = situation.disk
            x, y = situation.team.positions[situation.evaders.index(target)]
            if contains(disk.center[0], disk.center[1], disk.radius + disk.capture_radius, x, y):
                contained_since.setdefault(target, situation.time)
            due = is_due(situation.time, contained_since.get(target, math.inf), delay)
            return Chase(tuple(i for i, _ in ahead)) if due else Fly()

        return decide
