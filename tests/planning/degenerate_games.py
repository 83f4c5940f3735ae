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

# Random games of which a search was once content with a large turn during which the evader is
# caught, although a small one is better: on such a plateau nothing says which way leads off it.
CAUGHT_TURNING = {
    "two on one spot, better hardly turning": (
        covey.Team([(0.3106, 0.3218)] * 2, [-0.6131, 0.6463]),
        covey.PursuerDisk(radius=0.1),
    ),
    "three on one spot, one better hardly turning": (
        covey.Team([(0.4596, 0.2943)] * 3, [0.9238, -2.6098, -0.0082]),
        covey.PursuerDisk(radius=0.1),
    ),
    "two that can hardly turn, one better straight": (
        covey.Team([(0.2215, -0.3288), (0.0646, 0.1127)], [-1.2162, -1.9868], 0.25, 0.1),
        POINT,
    ),
    "three that can hardly turn, two better straight": (
        covey.Team(
            [(0.0386, -0.0441), (0.0038, -0.089), (0.1, -0.0254)],
            [-1.1403, 1.4689, 0.8185],
            0.25,
            0.6,
        ),
        POINT,
    ),
    "three in line, one better turning less": (
        covey.Team([(0.4377, 0.2), (0.2239, 0.2), (0.54, 0.2)], [1.7163, -0.4607, 0.9353]),
        POINT,
    ),
    "a mirrored pair and one behind, one better straight": (
        covey.Team(
            [(0.2312, -0.1961), (0.2312, 0.1961), (-0.1384, 0.0)], [-2.3738, 2.3738, math.pi]
        ),
        covey.PursuerDisk(radius=0.1),
    ),
    "three, one fast": (
        covey.Team(
            [(-0.493, 0.1208), (0.207, 0.3179), (0.4839, -0.1653)],
            [-0.4588, -2.3863, 2.8931],
            [0.25, 0.9, 0.25],
        ),
        POINT,
    ),
}

GAMES = (
    COINCIDENT | MIRRORED | IN_THE_DISK | INDISTINGUISHABLE | HALF_TURNS | PLATEAUS | COLLINEAR
    | UNEQUAL | CAUGHT_TURNING
)  # fmt: skip

# The best of 500 starts with each of three seeds. Whoever finds more writes it here.
BEST_KNOWN = {
    "four on one spot": 0.850407249,
    "two pairs": 2.207264984,
    "five, two of them on one spot": 4.071800998,
    "five on one spot": 0.578751125,
    "eight on one spot": 0.579249180,
    "two mirrored pairs": 5.580434326,
    "two mirrored pairs, a disk": 5.188445089,
    "a square and its centre": 5.029110046,
    "three mirrored pairs": 6.508716259,
    "two of four in the disk": 2.302783349,
    "all five in the disk": 0.778015329,
    "all four on the border, one inward": 1.410238772,
    "4 at the corners of a polygon, away": 5.927027141,
    "4 at the corners of a polygon, aside": 5.089682517,
    "4 at the corners of a polygon, inward": 2.024557556,
    "5 at the corners of a polygon, away": 6.938252788,
    "5 at the corners of a polygon, aside": 5.956674276,
    "5 at the corners of a polygon, inward": 2.308655953,
    "6 at the corners of a polygon, away": 7.662614250,
    "6 at the corners of a polygon, aside": 6.577569697,
    "6 at the corners of a polygon, inward": 2.565750876,
    "8 at the corners of a polygon, away": 9.723055601,
    "8 at the corners of a polygon, aside": 8.187775852,
    "8 at the corners of a polygon, inward": 3.363920210,
    "five that fly at the pursuer, far": 19.006403928,
    "five that can hardly turn": 1.664308212,
    "five in line that flee": 0.761255896,
    "five, of which two stand": 2.065277397,
}
