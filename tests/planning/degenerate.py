"""Games that are special: where maxima are flat, sequences tie, or nothing can be gained."""

from __future__ import annotations

import math

import numpy as np

import covey

POINT = covey.PursuerDisk()


def _polygon(count, turned, *, distance=0.5, speeds=0.25, turn_rates=math.pi / 2):
    """Evaders at the corners of a regular polygon, headings `turned` from straight away."""
    bearings = 2.0 * math.pi * np.arange(count) / count
    places = distance * np.column_stack([np.cos(bearings), np.sin(bearings)])
    return covey.Team(places, bearings + turned, speeds, turn_rates)


def _mirrored(places, headings):
    """Each evader and its mirror image across the x axis."""
    places, headings = np.array(places), np.array(headings)
    both = np.vstack([places, places * [1.0, -1.0]])
    return covey.Team(both, np.append(headings, -headings))


def _in_line(distances, headings):
    """Evaders on the x axis, the pursuer at the origin."""
    return covey.Team([(distance, 0.0) for distance in distances], headings)


COINCIDENT = {
    "two on one spot": (covey.Team([(0.5, 0.1)] * 2, [0.0] * 2), POINT),
    "two on one spot, headings opposite": (covey.Team([(0.5, 0.1)] * 2, [0.0, math.pi]), POINT),
    "three on one spot": (covey.Team([(0.5, 0.1)] * 3, [0.0] * 3), POINT),
    "three on one spot that turn at once": (
        covey.Team([(0.5, 0.1)] * 3, [1.0] * 3, 0.25, math.inf),
        POINT,
    ),
    "two on one spot, one elsewhere": (
        covey.Team([(0.5, 0.1), (0.5, 0.1), (-0.3, 0.2)], [0.0, 0.0, 2.0]),
        POINT,
    ),
    "four on one spot": (covey.Team([(0.5, 0.1)] * 4, [0.0] * 4), POINT),
    "two pairs": (
        covey.Team([(0.4, 0.1)] * 2 + [(-0.3, 0.2)] * 2, [0.5, 0.5, 2.0, 2.0]),
        POINT,
    ),
    "five, two of them on one spot": (
        covey.Team(
            [(0.4, 0.1), (0.4, 0.1), (-0.3, 0.2), (-0.1, -0.4), (0.2, 0.3)],
            [0.3, 0.3, 2.5, -1.8, 1.0],
        ),
        POINT,
    ),
    "five on one spot": (covey.Team([(0.3, 0.2)] * 5, [0.6] * 5), POINT),
    "eight on one spot": (covey.Team([(0.3, 0.2)] * 8, [0.6] * 8), POINT),
    "all where the pursuer is": (covey.Team([(0.0, 0.0)] * 3, [0.0, 1.0, 2.0]), POINT),
}

MIRRORED = {
    "a mirrored pair": (_mirrored([(0.3, 0.2)], [0.5]), POINT),
    "a mirrored pair with one heading": (covey.Team([(0.3, 0.2), (0.3, -0.2)], [0.0, 0.0]), POINT),
    "a mirrored pair and one on the axis": (
        covey.Team([(0.3, 0.2), (0.3, -0.2), (0.4, 0.0)], [0.5, -0.5, 0.0]),
        POINT,
    ),
    "a mirrored pair and one on the axis that comes": (
        covey.Team([(0.3, 0.2), (0.3, -0.2), (0.4, 0.0)], [0.5, -0.5, math.pi]),
        POINT,
    ),
    "two mirrored pairs": (_mirrored([(0.4, 0.3), (-0.2, 0.5)], [0.3, 2.0]), POINT),
    "two mirrored pairs, a disk": (
        _mirrored([(0.4, 0.3), (-0.2, 0.5)], [0.3, 2.0]),
        covey.PursuerDisk(radius=0.1),
    ),
    "a square and its centre": (
        covey.Team(
            [(0.3, 0.3), (-0.3, 0.3), (-0.3, -0.3), (0.3, -0.3), (0.0, 0.0)],
            [0.8, 2.4, -2.4, -0.8, 0.0],
        ),
        POINT,
    ),
    "three mirrored pairs": (
        _mirrored([(0.4, 0.3), (-0.2, 0.5), (0.1, 0.1)], [0.3, 2.0, 1.0]),
        POINT,
    ),
}

IN_THE_DISK = {
    "one of two in the disk": (
        covey.Team([(0.1, 0.0), (0.6, 0.1)], [0.0, 0.0]),
        covey.PursuerDisk(radius=0.2),
    ),
    "one of three in the disk": (
        covey.Team([(0.1, 0.0), (0.5, 0.1), (-0.3, 0.4)], [0.0, 0.5, 2.0]),
        covey.PursuerDisk(radius=0.2),
    ),
    "two of four in the disk": (
        covey.Team([(0.1, 0.0), (-0.1, 0.1), (0.5, 0.1), (-0.3, 0.4)], [0.0, 2.0, 0.5, 2.0]),
        covey.PursuerDisk(radius=0.2),
    ),
    "all three in the disk": (
        covey.Team([(0.1, 0.0), (-0.1, 0.1), (0.0, -0.15)], [0.0, 2.0, -1.0]),
        covey.PursuerDisk(radius=0.2),
    ),
    "all five in the disk": (
        _polygon(5, 1.0, distance=0.1),
        covey.PursuerDisk(radius=0.3),
    ),
    "one where the pursuer is": (
        covey.Team([(0.0, 0.0), (0.5, 0.1), (-0.3, 0.4)], [0.0, 0.5, 2.0]),
        POINT,
    ),
    "all within reach": (
        covey.Team([(0.01, 0.0), (0.0, 0.01), (-0.01, 0.0)], [0.0, 1.0, 2.0]),
        covey.PursuerDisk(capture_radius=0.1),
    ),
    "one alone, on the border": (
        covey.Team([(0.25, 0.0)], [0.0]),
        covey.PursuerDisk(radius=0.25),
    ),
    "one of three on the border": (
        covey.Team([(0.25, 0.0), (0.5, 0.1), (-0.3, 0.4)], [0.0, 0.5, 2.0]),
        covey.PursuerDisk(radius=0.25),
    ),
    "all three on the border": (
        covey.Team([(0.25, 0.0), (0.0, 0.25), (-0.25, 0.0)], [0.0, 1.5, 3.0]),
        covey.PursuerDisk(radius=0.25),
    ),
    "all four on the border, one inward": (
        covey.Team(
            [(0.25, 0.0), (0.0, 0.25), (-0.25, 0.0), (0.0, -0.25)], [math.pi, 1.5, 3.0, -1.5]
        ),
        covey.PursuerDisk(radius=0.25),
    ),
}

INDISTINGUISHABLE = {
    f"{count} at the corners of a polygon, {name}": (_polygon(count, turned), disk)
    for count in (2, 3, 4, 5, 6, 8)
    for name, turned, disk in (
        ("away", 0.0, POINT),
        ("aside", 0.5 * math.pi, POINT),
        ("inward", math.pi, covey.PursuerDisk(radius=0.1)),
    )
}

HALF_TURNS = {
    "one that flies at the pursuer": (_in_line([2.0], [math.pi]), POINT),
    "one that flies at the pursuer, near": (_in_line([0.3], [math.pi]), POINT),
    "two that fly at the pursuer": (_in_line([0.5, 1.0], [math.pi] * 2), POINT),
    "three that fly at the pursuer from three sides": (_polygon(3, math.pi), POINT),
    "one that flies at the pursuer, one away": (_in_line([0.5, -0.5], [math.pi] * 2), POINT),
    "five that fly at the pursuer, far": (
        _polygon(5, math.pi, distance=2.0),
        covey.PursuerDisk(radius=0.5),
    ),
}

PLATEAUS = {
    "one that can hardly turn": (covey.Team([(0.3, 0.2)], [2.0], 0.25, 0.1), POINT),
    "two that are caught while they turn": (
        covey.Team([(0.1, 0.0), (0.0, 0.1)], [math.pi, 2.0], 0.25, 0.5),
        POINT,
    ),
    "three, one of them caught while it turns": (
        covey.Team([(0.05, 0.0), (0.4, 0.3), (-0.5, 0.2)], [2.0, 0.0, 2.0]),
        POINT,
    ),
    "three that can hardly turn": (
        covey.Team([(0.3, 0.2), (-0.2, 0.3), (0.1, -0.4)], [2.0, -1.0, 0.5], 0.25, 0.2),
        POINT,
    ),
    "five that can hardly turn": (
        covey.Team(
            [(0.3, 0.2), (-0.2, 0.3), (0.1, -0.4), (-0.4, -0.2), (0.45, -0.1)],
            [2.0, -1.0, 0.5, 0.0, 3.0],
            0.25,
            0.2,
        ),
        POINT,
    ),
}

COLLINEAR = {
    "two in line that flee": (_in_line([1.0, 2.0], [0.0, 0.0]), POINT),
    "three in line that flee": (_in_line([0.2, 0.4, 0.6], [0.0] * 3), POINT),
    "three in line on both sides": (_in_line([-0.3, 0.2, 0.5], [math.pi, 0.0, 0.0]), POINT),
    "three in line across": (
        covey.Team([(0.3, -0.2), (0.3, 0.0), (0.3, 0.2)], [math.pi / 2] * 3),
        POINT,
    ),
    "five in line that flee": (_in_line([0.1, 0.2, 0.3, 0.4, 0.5], [0.0] * 5), POINT),
}

UNEQUAL = {
    "one that stands": (
        covey.Team([(0.3, 0.2), (-0.2, 0.3), (0.1, -0.4)], [2.0, -1.0, 0.5], [0.0, 0.25, 0.25]),
        POINT,
    ),
    "one that crawls": (
        covey.Team([(0.3, 0.2), (-0.2, 0.3), (0.1, -0.4)], [2.0, -1.0, 0.5], [1e-3, 0.25, 0.25]),
        POINT,
    ),
    "all but one stand": (
        covey.Team([(0.3, 0.2), (-0.2, 0.3), (0.1, -0.4)], [2.0, -1.0, 0.5], [0.0, 0.0, 0.25]),
        POINT,
    ),
    "three that stand": (
        covey.Team([(1.0, 0.0), (-2.0, 0.0), (3.0, 0.0)], [0.1, 0.2, 0.3], 0.0),
        POINT,
    ),
    "one nearly as fast as the pursuer": (
        covey.Team([(0.3, 0.2), (-0.2, 0.3)], [2.0, -1.0], [0.99, 0.25]),
        POINT,
    ),
    "five, of which two stand": (
        covey.Team(
            [(0.3, 0.2), (-0.2, 0.3), (0.1, -0.4), (-0.4, -0.2), (0.45, -0.1)],
            [2.0, -1.0, 0.5, 0.0, 3.0],
            [0.0, 0.25, 0.25, 0.0, 0.25],
        ),
        POINT,
    ),
}

GAMES = (
    COINCIDENT | MIRRORED | IN_THE_DISK | INDISTINGUISHABLE | HALF_TURNS | PLATEAUS | COLLINEAR
    | UNEQUAL
)  # fmt: skip
