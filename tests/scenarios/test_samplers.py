"""Where evaders are placed at random, and in formation."""

from __future__ import annotations

import math

import numpy as np
import pytest

from covey.studies import Disk, Formation, Study


def test_the_square_is_the_papers():
    study = Study()
    starts = [study.start(number, 5) for number in range(400)]
    places = np.concatenate([start.positions for start in starts])
    assert np.abs(places).max() <= 0.5
    # Mean 0 and variance 1/12 in each direction, within four standard errors of 2000 samples.
    assert places.mean(axis=0) == pytest.approx([0, 0], abs=4 * math.sqrt(1 / 12 / 2000))
    assert places.var(axis=0) == pytest.approx([1 / 12, 1 / 12], rel=0.1)
    headings = np.concatenate([start.headings for start in starts])
    assert np.allclose(headings, np.arctan2(places[:, 1], places[:, 0]))


def test_the_disk_is_filled_evenly():
    study = Study(sampler=Disk(radius=2.0))
    places = np.concatenate([study.start(number, 5).positions for number in range(400)])
    distances = np.hypot(*places.T)
    assert distances.max() <= 2.0
    # Half of the area lies within radius / √2.
    assert (distances < math.sqrt(2.0)).mean() == pytest.approx(0.5, abs=4 * 0.5 / math.sqrt(2000))


@pytest.mark.parametrize("shape", ["line", "wedge", "ring"])
def test_a_formation_keeps_its_spacing_and_flies_one_way(shape):
    study = Study(sampler=Formation(shape, spacing=0.2, distance=1.5), team_size=5)
    start = study.start(0, 5)
    gaps = np.hypot(*(start.positions[:, None] - start.positions).T)
    assert gaps[~np.eye(5, dtype=bool)].min() == pytest.approx(0.2)
    assert np.hypot(*start.positions.mean(axis=0)) == pytest.approx(1.5)
    assert len(set(start.headings)) == 1
