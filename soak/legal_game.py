"""Whether a record is a game by the rules, checked without the code that played it.

Each check returns the largest error that it finds. An error of a place is relative to the game's
`extent`, an angle is in radians. What must be equal to the last bit, and is not, is an error of
`math.inf`.
"""

from __future__ import annotations

import inspect
import math

import numpy as np

import covey
from covey.kernels.play.rules import MOST_UPDATES
from soak.reference_flight import captures, flown, living

SAMPLES = 50
"""Moments between two rows at which somebody might have been touched."""


def extent(game):
    """The largest coordinate or radius that goes into the arithmetic."""
    places = (game.evader_positions, game.pursuer_positions, game.disk_centers)
    reach = game.disk.radius + 2.0 * game.disk.capture_radius
    return max(float(np.abs(each).max()) for each in places) + reach or 1.0


def numbers_are_finite(game):
    """All but the times of captures that did not come."""
    series = (
        game.times,
        game.guarantees,
        game.evader_positions,
        game.evader_headings,
        game.evader_turns,
        game.pursuer_positions,
        game.disk_centers,
        game.disk_radii,
        game.capture_times,
        (game.guarantee, game.planned_value),
    )
    return _exactly(np.isfinite(each).all() for each in series)


def times_are_in_order(game):
    """From 0, never back; captures too."""
    series = (game.times, game.capture_times)
    return _exactly([game.times[0] == 0.0, *((np.diff(each) >= 0.0).all() for each in series)])


def everyone_flies_what_was_announced(game):
    """The living, on an arc and then straight; the captured stay where they are."""
    (places,), (headings,) = flown(game, np.diff(game.times)[np.newaxis])
    alive = living(game)[:-1]
    off = np.linalg.norm(game.evader_positions[1:] - places, axis=2)[alive]
    turned = np.abs(game.evader_headings[1:] - headings)[alive]
    moved = (game.evader_positions[1:] != game.evader_positions[:-1]).any(axis=2)[~alive]
    return max(_largest(off) / extent(game), _largest(turned), _exactly([not moved.any()]))


def nobody_is_faster_than_it_can_be(game):
    """Neither in its flight nor in its turn."""
    durations = np.diff(game.times)[:, np.newaxis]
    moved = np.linalg.norm(np.diff(game.evader_positions, axis=0), axis=2)
    slow = np.isfinite(game.team.turn_rates)
    turned = np.abs(np.diff(game.evader_headings, axis=0))[:, slow]
    return max(
        _largest(moved - game.team.speeds * durations) / extent(game),
        _largest(turned - game.team.turn_rates[slow] * durations),
    )


def the_pursuer_is_no_faster_than_it_can_be(game, placed=False):
    """A visible one that was in a disk shows where as it sets out, so that row isn't compared."""
    if not (shows(game, placed) or game.disk.capture_radius == 0.0):
        return 0.0  # with reach, a hidden pursuer may be anywhere in it after each capture
    first = first_shown(game, placed)
    places, times = game.pursuer_positions[first:], game.times[first:]
    moved = np.linalg.norm(np.diff(places, axis=0), axis=1)
    too_far = _largest(moved - game.disk.speed * np.diff(times))
    if len(times):
        from_center = _distance(places[0], game.disk.center)
        too_far = max(too_far, from_center - game.disk.radius - game.disk.speed * times[0])
    return too_far / extent(game)


def each_capture_is_a_row_of_its_own(game):
    """At its exact time, and nobody vanishes otherwise."""
    found = [(i, game.times[row]) for i, row in captures(game)]
    told = list(zip(game.capture_sequence.tolist(), game.capture_times, strict=True))
    return _exactly([found == told, len({row for _, row in captures(game)}) == len(found)])


def who_is_captured_is_within_reach(game, placed=False):
    """Of the pursuer that has a position, and of the disk at the moment that it grew to that."""
    reach, error = game.disk.capture_radius, 0.0
    for i, row in captures(game):
        place = game.evader_positions[row, i]
        if shows(game, placed):
            error = max(error, _distance(place, game.pursuer_positions[row]) - reach)
        if game.sensing == "hidden":
            duration = game.times[row] - game.times[row - 1]
            grown = game.disk_radii[row - 1] + game.disk.speed * duration
            off = _distance(place, game.disk_centers[row - 1]) - grown - reach
            # A disk takes whom it wants as soon as it reaches that evader, or at a decision, if the
            # pursuer thought better of it.
            prompt = not placed and duration > 0.0
            error = max(error, abs(off) if prompt else off)
    return error / extent(game)


def a_hidden_pursuer_is_a_disk_that_grows_and_collapses(game):
    """It grows at the pursuer's speed, and collapses to the reach around each capture."""
    if game.sensing == "visible":
        return 0.0
    centers = game.disk_centers[:-1].copy()
    radii = game.disk_radii[:-1] + game.disk.speed * np.diff(game.times)
    for i, row in captures(game):
        centers[row - 1] = game.evader_positions[row, i]
        radii[row - 1] = game.disk.capture_radius
    taken = [row for _, row in captures(game)]
    exact = _exactly(
        [
            np.array_equal(game.disk_centers[0], game.disk.center),
            game.disk_radii[0] == game.disk.radius,
            np.array_equal(game.disk_centers[1:], centers),
            (game.disk_radii[taken] == game.disk.capture_radius).all(),
        ]
    )
    return max(exact, _largest(np.abs(game.disk_radii[1:] - radii)) / extent(game))


def a_visible_pursuer_is_where_its_disk_is(game):
    """A point, but for the disk in which it begins."""
    if game.sensing == "hidden":
        return 0.0
    return _exactly(
        [
            np.array_equal(game.disk_centers[1:], game.pursuer_positions[1:]),
            game.disk_radii[0] == game.disk.radius,
            (game.disk_radii[1:] == 0.0).all(),
        ]
    )


def a_pursuer_takes_whomever_it_comes_near(game, placed=False, samples=SAMPLES):
    """Between rows, nobody alive is within the reach of a pursuer that has a position."""
    reach, first = game.disk.capture_radius, first_shown(game, placed)
    if not shows(game, placed) or reach == 0.0:
        return 0.0
    durations = np.diff(game.times)
    shares = np.arange(1, samples)[:, np.newaxis] / samples
    starts, ends = game.pursuer_positions[:-1], game.pursuer_positions[1:]
    pursuer = starts + shares[..., np.newaxis] * (ends - starts)
    places, _ = flown(game, shares * durations)
    gaps = np.linalg.norm(places - pursuer[:, :, np.newaxis], axis=3)
    counts = living(game)[:-1] & (durations > 0.0)[:, np.newaxis]
    counts[:first] = False
    return _largest(reach - gaps[:, counts]) / extent(game)


def a_hidden_pursuer_is_shown_where_it_captures(game):
    """Where it began at a point; in a disk, it may be anywhere."""
    if game.sensing == "visible" or game.disk.radius > 0.0:
        return 0.0
    off = [
        _distance(game.pursuer_positions[row], game.evader_positions[-1, i])
        for i, row in captures(game)
    ]
    return _largest(np.array(off) - game.disk.capture_radius) / extent(game)


def the_last_row_is_the_end(game, time_limit=math.inf):
    """Everybody is captured, or the time or the updates are used up."""
    if game.status is covey.GameStatus.ALL_CAPTURED:
        return _exactly(
            [
                sorted(game.capture_sequence) == list(range(len(game.team))),
                game.survival_time == game.capture_times[-1] == game.times[-1],
                game.guarantees[-1] == 0.0,
            ]
        )
    alive = _exactly([math.isinf(game.survival_time)])
    if game.status is covey.GameStatus.UPDATE_LIMIT:
        return max(alive, _exactly([len(game.times) == MOST_UPDATES + 1]))
    return max(alive, abs(game.times[-1] / time_limit - 1.0))


def errors(game, time_limit=math.inf, placed=False, samples=SAMPLES):
    """The error that each check finds, by its name.

    `placed`: the pursuer has a position also where it is hidden. `time_limit`: of the game.
    """
    given = {"time_limit": time_limit, "placed": placed, "samples": samples}
    return {
        name: check(game, **{asked: given[asked] for asked in options})
        for name, (check, options) in CHECKS.items()
    }


def shows(game, placed):
    """Whether the record tells where the pursuer was."""
    return placed or game.sensing == "visible"


def first_shown(game, placed):
    """The first row that tells it: a pursuer that began in a disk is placed as it sets out."""
    return 1 if shows(game, placed) and not placed and game.disk.radius > 0.0 else 0


def _exactly(conditions):
    return 0.0 if all(conditions) else math.inf


def _largest(errors):
    return float(errors.max(initial=0.0))


def _distance(a, b):
    return float(np.hypot(*(a - b)))


CHECKS = {
    check.__name__.replace("_", " "): (check, [*inspect.signature(check).parameters][1:])
    for check in (
        numbers_are_finite,
        times_are_in_order,
        everyone_flies_what_was_announced,
        nobody_is_faster_than_it_can_be,
        the_pursuer_is_no_faster_than_it_can_be,
        each_capture_is_a_row_of_its_own,
        who_is_captured_is_within_reach,
        a_hidden_pursuer_is_a_disk_that_grows_and_collapses,
        a_visible_pursuer_is_where_its_disk_is,
        a_pursuer_takes_whomever_it_comes_near,
        a_hidden_pursuer_is_shown_where_it_captures,
        the_last_row_is_the_end,
    )
}
"""Each check by its name, and what else it is told."""
