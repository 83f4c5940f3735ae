"""The other still pictures: Figs. 1 and 2 of the paper, a plan, a whole game."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import covey
from covey.views import draw_capture, draw_control, draw_game, draw_plan
from covey.views.games.capture_labels import number_and_time
from covey.views.kit import style
from covey.views.kit.layout import Camera, single_map
from covey.views.kit.page import Sheet
from covey.views.kit.point_labels import label
from covey.views.kit.time_format import time_format
from views.drawn_artists import boxes, disks, labels, line, points
from views.flown_games import FIRST_CAPTURE, SECOND_CAPTURE, game_by_hand, simulated, turning_evader

EVADER = covey.Team([[1.0, -2.0]], [0.4], 0.5, 2.0)


@pytest.mark.parametrize("turn", [1.8, -1.2, 3.0])
def test_a_control_rises_at_the_turn_rate_and_the_path_is_its_circle(turn):
    heading, path = draw_control(EVADER, turn).axes
    times, angles = line(heading, "heading").get_data()
    end = abs(turn) / 2.0
    assert times[:2].tolist() == pytest.approx([0.0, end])
    assert angles.tolist() == pytest.approx([0.4, 0.4 + turn, 0.4 + turn])
    assert heading.get_xticks().tolist() == pytest.approx([0.0, end])
    assert heading.get_yticks().tolist() == pytest.approx([0.4, 0.4 + turn])
    flown = points(path, "flown by evaders")
    left = 0.4 + math.copysign(math.pi / 2, turn)
    center = [1.0 + 0.25 * math.cos(left), -2.0 + 0.25 * math.sin(left)]
    assert np.hypot(*(flown[:20] - center).T) == pytest.approx(np.full(20, 0.25))
    x, y = flown[-1] - flown[-2]
    assert math.remainder(math.atan2(y, x) - 0.4 - turn, math.tau) == pytest.approx(0.0, abs=1e-9)


def test_the_figures_of_the_paper_come_without_arguments():
    assert len(draw_control().axes) == 2
    (axes,) = draw_capture().axes
    assert [disk.radius for disk in disks(axes)] == sorted(
        [disk.radius for disk in disks(axes)], reverse=True
    )
    assert disks(axes)[-1].radius == 0.3


@pytest.mark.parametrize(
    ("team", "turn"),
    [
        (EVADER, 0.0),
        (EVADER, math.nan),
        (covey.Team([[0.0, 0.0]], [0.0], 0.5, 0.0), 1.0),
        (covey.Team([[0.0, 0.0]], [0.0], 0.5, math.inf), 1.0),
        (covey.Team([[0.0, 0.0]], [0.0], 0.0, 1.0), 1.0),
    ],
)
def test_an_evader_that_makes_no_turn_has_no_figure(team, turn):
    with pytest.raises(covey.InputError, match="turn"):
        draw_control(team, turn)
    with pytest.raises(covey.InputError, match="turn"):
        draw_capture(team, None, turn)


def test_there_must_be_such_an_evader():
    with pytest.raises(covey.InputError, match=r"evader: expected one of 0\.\.0, got 1"):
        draw_control(EVADER, 1.0, evader=1)


@pytest.mark.parametrize("capture_radius", [0.0, 0.1])
@pytest.mark.parametrize("distance", [0.6, 3.0])
def test_the_disk_reaches_the_evader_at_the_capture(distance, capture_radius):
    team = covey.Team([[distance, 0.0]], [2.0], 0.5, 1.0)
    disk = covey.PursuerDisk((0.1, -0.1), 0.2, 1.0, capture_radius)
    (axes,) = draw_capture(team, disk, -1.5).axes
    (capture,) = points(axes, "predicted captures")
    t = covey.capture_times(team, disk, [-1.5], [0])[0]
    radii = sorted([0.2, 0.2 + 1.5, 0.2 + t])
    assert sorted(disk.radius for disk in disks(axes)) == pytest.approx(
        [radius + capture_radius for radius in radii]
    )
    assert math.dist(capture, (0.1, -0.1)) == pytest.approx(0.2 + capture_radius + t)
    # Caught in the turn (near) or after it (far); the path flown ends there.
    assert (t < 1.5) == (distance == 0.6)
    assert points(axes, "flown by evaders")[-1] == pytest.approx(capture)


def test_a_plan_shows_its_captures_in_order(frame):
    game = game_by_hand()
    team, disk = frame.game(game.team, game.disk)
    turns, first, second = (
        game.evader_turns[0],
        frame.time * FIRST_CAPTURE,
        frame.time * SECOND_CAPTURE,
    )
    plan = covey.Plan(
        team,
        disk,
        turns,
        turns,
        second,
        covey.LastCapture(),
        second,
        ((0, 1), (1, 0)),
        covey.PlanStatus.CONVERGED,
        *([0] * (len(covey.Plan.__dataclass_fields__) - 9)),
    )
    (axes,) = draw_plan(plan).axes
    captures, rounding = (
        frame.points([[0.8, 0.0], turning_evader(SECOND_CAPTURE)]),
        1e-12 * frame.length,
    )
    assert points(axes, "predicted captures") == pytest.approx(captures, abs=rounding)
    assert points(axes, "evaders").tolist() == team.positions.tolist()
    write = time_format(second)
    assert [text.get_text() for text in labels(axes)] == [
        *("0", "1"),
        number_and_time(0, write(first)),
        number_and_time(1, write(second)),
    ]
    positions = np.array([text.xy for text in labels(axes)])
    both = np.concatenate([team.positions, captures])
    assert positions == pytest.approx(both, abs=rounding)


def test_a_game_shows_its_captures_in_order():
    (axes,) = draw_game(game_by_hand()).axes
    captures = [[0.8, 0.0], turning_evader(SECOND_CAPTURE)]
    assert points(axes, "captured evaders") == pytest.approx(np.array(captures), abs=1e-12)
    assert points(axes, "dots").tolist() == [[0.6, 0.0], [0.0, 1.0]]
    assert points(axes, "flown by pursuer")[-1] == pytest.approx(captures[1])
    assert [text.get_text() for text in labels(axes)] == [
        *("0", "1"),
        number_and_time(0, f"{FIRST_CAPTURE:.2f}"),
        number_and_time(1, f"{SECOND_CAPTURE:.2f}"),
    ]
    assert f"survived {SECOND_CAPTURE:.2f}" in axes.get_title(loc="left")


def test_who_lives_when_a_game_is_stopped_is_shown_alive():
    game = simulated(time_limit=0.3)
    (axes,) = draw_game(game).axes
    alive = sorted(set(range(4)) - set(game.capture_sequence.tolist()))
    assert points(axes, "evaders").tolist() == game.evader_positions[-1, alive].tolist()
    assert f"stopped with {len(alive)} of 4 alive" in axes.get_title(loc="left")


@pytest.mark.parametrize("seed", range(3))
def test_labels_overlap_neither_each_other_nor_the_edge(seed):
    (axes,) = draw_game(simulated(seed=seed)).axes
    filled = boxes(axes)
    assert len(filled) == 4 + 4
    for one, other in itertools.combinations(filled, 2):
        assert not one.overlaps(other)
    page = axes.get_window_extent()
    for box in filled:
        assert page.containsx(box.x0)
        assert page.containsx(box.x1)
        assert page.containsy(box.y0)
        assert page.containsy(box.y1)


def test_labels_of_one_place_lie_side_by_side():
    _, axes = single_map(Camera(0.0, 0.0, 1.0), Sheet(None, None, 3.5))
    corner = np.array([[0.95, 0.95]] * 4)
    label(axes, corner, ["1: 0.27", "2: 0.27", "3: 0.28", "4: 0.28"], corner)
    for one, other in itertools.combinations(boxes(axes), 2):
        assert not one.overlaps(other)
    assert max(box.x1 for box in boxes(axes)) < axes.get_window_extent().x1


@pytest.mark.parametrize("seed", range(6))
def test_a_label_leaves_its_mark_free_wherever_it_stands(seed):
    _, axes = single_map(Camera(0.0, 0.0, 1.0), Sheet(None, None, 3.5))
    generator = np.random.default_rng(seed)
    marks, lines = generator.uniform(-0.6, 0.6, (6, 2)), generator.uniform(-1.0, 1.0, (300, 2))
    label(axes, marks, ["1: t = 2.75"] * 6, lines)
    for (x, y), box in zip(axes.transData.transform(marks), boxes(axes), strict=True):
        gap = math.hypot(max(box.x0 - x, 0.0, x - box.x1), max(box.y0 - y, 0.0, y - box.y1))
        assert gap * 72.0 / axes.figure.dpi > 0.5 * style.CAPTURED_SIZE


def test_labels_of_a_narrow_map_are_smaller():
    wide, narrow = (draw_game(simulated(), width=width).axes[0] for width in (3.5, 1.8))
    assert labels(narrow)[0].get_fontsize() < labels(wide)[0].get_fontsize() == 7.0


def _luminance(color):
    """Relative luminance of WCAG 2, to which a figure printed in grey comes down."""
    channels = [int(color[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return float(np.dot(linear, [0.2126, 0.7152, 0.0722]))


@pytest.mark.parametrize("color", [style.EVADER, style.PURSUER, style.CAPTURED])
@pytest.mark.parametrize("ground", [style.PAPER, style.DISK])
def test_marks_stand_out_in_grey(color, ground):
    contrast = (_luminance(ground) + 0.05) / (_luminance(color) + 0.05)
    assert contrast > 2.5


def test_team_and_pursuer_differ_in_more_than_color():
    (axes,) = draw_game(game_by_hand()).axes
    team, pursuer = line(axes, "flown by evaders"), line(axes, "flown by pursuer")
    assert team.get_linewidth() > 2.0 * pursuer.get_linewidth()
    assert line(axes, "dots").get_marker() != line(axes, "pursuer").get_marker()
