"""The pursuer's disk: defaults, copies, and who is too fast for it."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import covey


def test_defaults_are_a_known_pursuer_at_the_origin():
    disk = covey.PursuerDisk()
    assert disk.center.tolist() == [0.0, 0.0]
    assert (disk.radius, disk.speed, disk.capture_radius) == (0.0, 1.0, 0.0)


def test_numbers_become_floats():
    disk = covey.PursuerDisk([1, 2], np.float32(3), np.int64(4), 5)
    assert disk.center.tolist() == [1.0, 2.0]
    assert all(type(x) is float for x in (disk.radius, disk.speed, disk.capture_radius))


def test_nothing_about_it_can_be_changed():
    center = np.zeros(2)
    disk = covey.PursuerDisk(center)
    center[:] = 7.0
    assert disk.center.tolist() == [0.0, 0.0]
    with pytest.raises(ValueError, match="read-only"):
        disk.center[0] = 1.0
    with pytest.raises(dataclasses.FrozenInstanceError):
        disk.radius = 1.0


@pytest.mark.parametrize(
    ("goal", "nearest"),
    [((1.0, 7.0), (1.0, 4.0)), ((4.0, 6.0), (2.2, 3.6)), ((0.0, 1.0), (0.0, 1.0)),
     ((1.0, 2.0), (1.0, 2.0)), ((-1.0, 2.0), (-1.0, 2.0))],
)  # fmt: skip
def test_nearest_point(goal, nearest):
    """Outside on the rim, inside and on the rim the goal itself."""
    disk = covey.PursuerDisk((1.0, 2.0), 2.0)
    assert disk.nearest_point(np.array(goal)) == pytest.approx(nearest, rel=1e-15)


def test_a_known_pursuer_is_its_own_nearest_point():
    disk = covey.PursuerDisk((1.0, 2.0))
    assert disk.nearest_point(np.array([-3.0, 5.0])).tolist() == [1.0, 2.0]


def test_the_way_to_a_goal_ends_there():
    disk = covey.PursuerDisk((1.0, 2.0), 9.0)
    points = disk.towards(np.array([4.0, 6.0]), [0.0, 2.5, 5.0, 7.0])
    assert points == pytest.approx(np.array([[1, 2], [2.5, 4], [4, 6], [4, 6]]), rel=1e-15)


@pytest.mark.parametrize("speed", [0.0, 0.5, 2.0 * (1.0 - 2e-12)])
def test_slower_evaders_are_fine(speed):
    covey.PursuerDisk(speed=2.0).require_faster_than(covey.Team([(0, 0)], [0], speed))


@pytest.mark.parametrize("speed", [np.nextafter(2.0, 0.0), 2.0, 3.0])
def test_an_evader_as_fast_as_the_pursuer_is_named(speed):
    team = covey.Team(np.zeros((3, 2)), np.zeros(3), [0.1, speed, 0.1])
    with pytest.raises(
        covey.InputError, match=rf"speeds: .*slower.*\(2\), got speeds\[1\] = {speed:g}"
    ):
        covey.PursuerDisk(speed=2.0).require_faster_than(team)


def test_a_pursuer_seen_a_while_ago_may_have_flown_since():
    disk = covey.PursuerDisk.last_seen((1, 2), within=150, ago=12, speed=45, capture_radius=5)
    assert disk.center.tolist() == [1.0, 2.0]
    assert (disk.radius, disk.speed, disk.capture_radius) == (690.0, 45.0, 5.0)
    assert covey.PursuerDisk.last_seen((1, 2), ago=0).radius == 0.0


@pytest.mark.parametrize("wrong", ["within", "ago", "speed"])
def test_a_sighting_that_can_not_be_is_refused_by_name(wrong):
    with pytest.raises(covey.InputError, match=f"^{wrong}: expected a finite number >.*got -1"):
        covey.PursuerDisk.last_seen((1, 2), **{"ago": 1, wrong: -1})


def test_headings_away_lead_away_from_the_centre():
    disk = covey.PursuerDisk((3, 1), 9.0)
    assert disk.headings_away([(4, 1), (3, 3)]).tolist() == [0.0, np.pi / 2]


def test_at_the_centre_no_heading_leads_away():
    message = r"none at the disk's centre.*got positions\[1\]; choose the heading"
    with pytest.raises(covey.InputError, match=message):
        covey.PursuerDisk((3, 1)).headings_away([(4, 1), (3, 1)])
