"""The claims of the paper's section V, and whether the figures of the studies support them."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from covey.model.validation import Floats
from covey.studies.paper.figures import HIDDEN, VISIBLE, Gains
from covey.studies.statistics import Z95

AT_ONE = 0.005
"""Half width of the histogram's bin at 1. A ratio in this bin counts as 1."""

_PAPER_AT_ONE = 200 / 500
_LOWEST = 0.9


class Claim(NamedTuple):
    """A statement of the paper, our figures, and whether they support it."""

    paper: str
    ours: str
    verdict: str


HOLDS, PARTLY, DIFFERS = "holds", "holds in part", "differs"


def fig4_claims(ratios: Mapping[int, Floats]) -> Iterator[Claim]:
    """Compare the paper's claims about Fig. 4 with the ratios of teams of 3 and 5."""
    three, five = ratios[3], ratios[5]
    at_one = {size: int((np.abs(values - 1.0) < AT_ONE).sum()) for size, values in ratios.items()}
    yield Claim(
        "Most starts of three evaders have a ratio of 1.",
        f"{at_one[3]} of {len(three)} within {AT_ONE} of 1, {_exactly(three)} within 0.000 001.",
        HOLDS if at_one[3] > len(three) / 2 else DIFFERS,
    )
    yield _five_at_one(five, at_one[5])
    low = np.sort(five[five <= _LOWEST])
    others = f"; the {len(low)} others: {', '.join(f'{q:.3f}' for q in low)}" if len(low) else ""
    yield Claim(
        "For the rest of the starts of five it is above 0.9.",
        f"{len(five) - len(low)} of {len(five)} above 0.9{others}.",
        HOLDS if len(low) == 0 else PARTLY,
    )
    yield Claim(
        "Hiddenness costs five evaders more than three.",
        f"Mean ratio {three.mean():.4f} for three, {five.mean():.4f} for five.",
        HOLDS if five.mean() < three.mean() else DIFFERS,
    )
    near = {size: float((values > 1 - AT_ONE).mean()) for size, values in ratios.items()}
    yield Claim(
        "The near-optimal pursuer attains the lower bound of the survival time, that against a "
        "hidden pursuer, most of the time.",
        "The visible team outlived the hidden one by less than "
        f"{100 * AT_ONE:.1f} % in {100 * near[3]:.0f} % of the starts of three and "
        f"{100 * near[5]:.0f} % of five; by less than 5 % in "
        f"{100 * float((five > 0.95).mean()):.0f} % of five.",
        HOLDS if min(near.values()) > 0.5 else PARTLY if max(near.values()) > 0.5 else DIFFERS,
    )


def _five_at_one(five: Floats, at_one: int) -> Claim:
    share = at_one / len(five)
    error = Z95 * math.sqrt(share * (1.0 - share) / len(five))  # half width of the 95 % interval
    wider = int((np.abs(five - 1.0) < 2.0 * AT_ONE).sum())
    agrees = abs(share - _PAPER_AT_ONE) <= error
    bracketed = at_one <= _PAPER_AT_ONE * len(five) <= wider
    return Claim(
        "Five evaders have a ratio of 1 in 200 of 500 starts (40 %).",
        f"{at_one} of {len(five)} ({100 * share:.0f} ± {100 * error:.0f} %) within {AT_ONE} "
        f"of 1, {wider} within {2.0 * AT_ONE}, {_exactly(five)} within 0.000 001. The paper "
        "doesn't say how near to 1 counts.",
        HOLDS if agrees else PARTLY if bracketed else DIFFERS,
    )


def fig5_claims(gains: Mapping[str, Gains]) -> Iterator[Claim]:
    """Compare the paper's claims about Fig. 5 with mean survival times by turning rate."""
    steps = [step for word in gains for step in _steps(gains[word])]
    yield Claim(
        "The survival time increases with the turning rate.",
        f"It does from each rate to the next in {sum(s > 0 for s in steps)} of {len(steps)} steps "
        f"(sensing × team size × step); the smallest is {min(steps):+.4f} of the time at the "
        "lowest rate.",
        HOLDS if min(steps) > 0 else PARTLY,
    )
    falls = [fall for word in gains for fall in _falling(gains[word])]
    yield Claim(
        "The gain diminishes as the turning rate gets higher.",
        f"The gain for each rad/s is smaller than that of the step before in {sum(falls)} of "
        f"{len(falls)} places.",
        HOLDS if all(falls) else PARTLY,
    )
    last = {word: [row[-1] for row in gains[word].ratios.values()] for word in gains}
    texts = [
        f"{word}: "
        + ", ".join(
            f"{size} evaders {100 * (row[-1].value - 1):.1f} ± {100 * row[-1].error:.1f} %"
            for size, row in gains[word].ratios.items()
        )
        for word in (VISIBLE, HIDDEN)
        if word in gains
    ]
    ordered = all(a.value < b.value for row in last.values() for a, b in itertools.pairwise(row))
    yield Claim(
        "Larger teams gain more.",
        "Gain at the highest rate, " + "; ".join(texts) + ".",
        HOLDS if ordered else PARTLY,
    )


def _exactly(values: Floats) -> int:
    return int((np.abs(values - 1.0) < 1e-6).sum())


def _steps(gains: Gains) -> Iterator[float]:
    for row in gains.ratios.values():
        yield from (b.value - a.value for a, b in itertools.pairwise(row))


def _falling(gains: Gains) -> Iterator[bool]:
    for row in gains.ratios.values():
        slopes = np.diff([each.value for each in row]) / np.diff(gains.turn_rates)
        yield from (bool(b < a) for a, b in itertools.pairwise(slopes))
