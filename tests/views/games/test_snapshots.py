"""The snapshots (Fig. 3) show what the record and Algorithm 1 say, all through one camera."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

import covey
from covey.views import draw_snapshots
from covey.views.games.snapshot import snapshot_at
from covey.views.games.snapshots import times_around_first_capture
from views.drawn_artists import bearing_of_marker, boxes, disks, labels, line, numbers_below, points
from views.flown_games import FIRST_CAPTURE, SECOND_CAPTURE, game_by_hand, simulated, turning_evader


def test_marks_stand_where_everybody_is():
    (before, after) = draw_snapshots(game_by_hand(), [0.5, 1.5]).axes
    assert points(before, "evaders") == pytest.approx(
        np.array([[0.725, 0.0], turning_evader(0.5)]), abs=1e-14
    )
    assert len(points(before, "captured evaders")) == 0
    assert points(before, "pursuer") == pytest.approx(np.array([[0.5, 0.0]]))
    assert points(after, "evaders") == pytest.approx(np.array([turning_evader(1.5)]), abs=1e-14)
    assert points(after, "captured evaders").tolist() == [[0.8, 0.0]]


def test_the_disk_grows_and_collapses():
    panels = draw_snapshots(game_by_hand(), [0.5, FIRST_CAPTURE, 1.0]).axes
    centers = [disks(panel)[0].center for panel in panels]
    assert centers == [(0.0, 0.0), (0.8, 0.0), (0.8, 0.0)]
    assert [disks(panel)[0].radius for panel in panels] == pytest.approx([0.5, 0.0, 0.2])
    assert [points(panel, "disk center")[0].tolist() for panel in panels] == [
        list(center) for center in centers
    ]


def test_predicted_captures_by_hand():
    (panel,) = draw_snapshots(game_by_hand(), [0.0]).axes
    captures = np.array([[0.8, 0.0], turning_evader(SECOND_CAPTURE)])
    assert points(panel, "predicted captures") == pytest.approx(captures, abs=1e-12)
    # The planned paths lead there, and the predicted pursuit from the center through them.
    planned = points(panel, "planned by evaders")
    assert planned[0].tolist() == [0.6, 0.0]
    assert planned[-1] == pytest.approx(captures[1], abs=1e-12)
    pursuit = points(panel, "predicted of pursuer")
    assert pursuit == pytest.approx(np.vstack([[0.0, 0.0], captures]), abs=1e-12)


@pytest.mark.parametrize("sensing", ["hidden", "visible"])
@pytest.mark.parametrize("capture_radius", [0.0, 0.03])
def test_predicted_captures_keep_the_times_of_algorithm_1(sensing, capture_radius):
    game = simulated(sensing, capture_radius=capture_radius)
    for share in (0.0, 0.1, 0.4, 0.7):
        snapshot = snapshot_at(game, share * game.survival_time)
        living = snapshot.sequence
        assert sorted(living) == np.flatnonzero(snapshot.alive).tolist()
        times = covey.capture_times(
            snapshot.team.take(living),
            snapshot.disk,
            snapshot.turns[living],
            range(len(living)),
        )
        assert snapshot.time + times[-1] == pytest.approx(snapshot.guaranteed, rel=1e-9)
        (panel,) = draw_snapshots(game, [snapshot.time]).axes
        captures = points(panel, "predicted captures")
        reach = np.full(len(times), 2.0 * capture_radius)
        reach[0] = snapshot.disk.radius + capture_radius
        flights = np.diff(np.vstack([snapshot.disk.center, captures]), axis=0)
        flown = np.hypot(*flights.T) - reach
        # Whoever is in reach already is captured at once, and nothing is flown.
        assert np.maximum(flown, 0.0) == pytest.approx(
            game.disk.speed * np.diff(times, prepend=0.0), abs=1e-9
        )


def test_the_pursuer_points_where_it_flies():
    (first, second) = draw_snapshots(game_by_hand(), [0.4, 1.2]).axes
    assert bearing_of_marker(line(first, "pursuer")) == pytest.approx(0.0, abs=1e-12)
    x, y = turning_evader(SECOND_CAPTURE) - np.array([0.8, 0.0])
    assert bearing_of_marker(line(second, "pursuer")) == pytest.approx(math.atan2(y, x))


def test_trajectories_are_those_flown_until_then():
    (panel,) = draw_snapshots(game_by_hand(), [1.5]).axes
    flown = points(panel, "flown by evaders")
    for position in (turning_evader(1.5), turning_evader(0.0), [0.6, 0.0], [0.8, 0.0]):
        assert np.hypot(*(flown - position).T).min() < 1e-12
    assert flown[:, 1].max() == pytest.approx(turning_evader(1.5)[1])


def test_one_camera_for_all_panels_and_a_true_scale():
    figure = draw_snapshots(simulated())
    frames = {(axes.get_xlim(), axes.get_ylim()) for axes in figure.axes}
    assert len(frames) == 1
    ((left, right), (bottom, top)) = frames.pop()
    assert right - left == pytest.approx(top - bottom)
    figure.canvas.draw()
    for axes in figure.axes:
        assert axes.get_aspect() == 1.0
        box = axes.get_window_extent()
        assert box.width == pytest.approx(box.height)
        for name in ("flown by evaders", "predicted captures", "pursuer"):
            x, y = points(axes, name).T
            assert (left < x).all()
            assert (x < right).all()
            assert (bottom < y).all()
            assert (y < top).all()


def test_default_moments_suit_the_length_of_the_game():
    titles = [axes.get_title(loc="left") for axes in draw_snapshots(game_by_hand()).axes]
    end = SECOND_CAPTURE
    assert titles == [
        f"({letter})  $t$ = {share * end:.2f}"
        for letter, share in zip("abcd", (0.0, 0.2, 0.5, 1.0), strict=True)
    ]


def test_the_moments_of_the_papers_figure_are_around_the_first_capture():
    later = FIRST_CAPTURE + 0.25 * (SECOND_CAPTURE - FIRST_CAPTURE)
    times = times_around_first_capture(game_by_hand())
    assert times == pytest.approx([0.0, 0.6, 0.8, later])


def test_every_evader_carries_its_number():
    game = simulated()
    for axes in draw_snapshots(game).axes:
        assert [text.get_text() for text in labels(axes)] == ["0", "1", "2", "3"]
        time = float(axes.get_title(loc="left").split("=")[1])
        marked = np.array([text.xy for text in labels(axes)])
        close = snapshot_at(game, min(time, game.survival_time)).team.positions
        assert marked == pytest.approx(close, abs=0.01)  # the title's time has two decimals


def test_outer_maps_name_their_axes_with_the_unit():
    team = covey.Team([(3.0, 4.0), (-5.0, 0.0)], 0.0, unit="km")
    game = covey.simulate(team, covey.PursuerDisk(), update_time=1.0)
    panels = draw_snapshots(game).axes
    assert [axes.get_ylabel() for axes in panels] == ["$y$ (km)", ""] * 2
    assert [axes.get_xlabel() for axes in panels] == ["", "", *["$x$ (km)"] * 2]
    assert all(axes.get_title(loc="left").endswith(" s") for axes in panels)


@cache
def uavs():
    """The game of the tutorial, whose team is small beside it, in few rows."""
    positions = [(900.0, 300.0), (-200.0, 1000.0), (-800.0, -500.0), (400.0, -900.0)]
    disk = covey.PursuerDisk(radius=690.0, speed=45.0, capture_radius=5.0, unit="m")
    headings = disk.headings_away(positions)
    team = covey.Team(positions, headings, speeds=20.0, turn_radii=60.0, unit="m")
    return covey.simulate(team, disk, update_time=5.0)


def test_wide_numbers_below_neighbours_stand_apart_and_every_map_has_some():
    figure = draw_snapshots(uavs())
    figure.canvas.draw()
    left, right = (numbers_below(axes) for axes in figure.axes[2:])
    gap = min(box.x0 for box in right) - max(box.x1 for box in left)
    assert gap / figure.dpi > 0.05


def test_a_number_hides_no_other_mark():
    for axes in draw_snapshots(uavs()).axes:
        marks = [points(axes, name) for name in ("evaders", "disk center", "pursuer")]
        places = axes.transData.transform(np.concatenate(marks))
        assert [box.count_contains(places) for box in boxes(axes)] == [0] * 4


def test_nothing_leaves_the_page():
    figure = draw_snapshots(simulated())
    figure.canvas.draw()
    page, drawn = figure.bbox, figure.get_tightbbox()
    width, height = figure.get_size_inches()
    assert drawn.x0 >= 0.0
    assert drawn.y0 >= 0.0
    assert drawn.x1 <= width
    assert drawn.y1 <= height
    assert page.width == pytest.approx(3.5 * figure.dpi)


def test_a_game_with_one_evader_and_one_that_was_stopped():
    alone = covey.simulate(covey.Team([[0.3, 0.0]], [0.0]), covey.PursuerDisk(), update_time=0.5)
    assert len(draw_snapshots(alone).axes) == 4
    stopped = simulated(time_limit=0.3)
    (panel,) = draw_snapshots(stopped, [stopped.times[-1]]).axes
    assert len(points(panel, "evaders")) == 4 - len(stopped.capture_sequence) > 0


def test_when_all_are_captured_nothing_is_predicted():
    (panel,) = draw_snapshots(game_by_hand(), [SECOND_CAPTURE]).axes
    assert len(points(panel, "evaders")) == len(points(panel, "predicted captures")) == 0
    assert len(points(panel, "captured evaders")) == 2


@pytest.mark.parametrize("times", [[], [-0.1], [0.0, 100.0], [math.nan], "soon"])
def test_times_outside_the_game_are_refused(times):
    with pytest.raises(covey.InputError, match="times"):
        draw_snapshots(game_by_hand(), times)
