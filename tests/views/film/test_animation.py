"""Films: a camera that doesn't move, time at a constant rate, and files that play."""

from __future__ import annotations

import base64
import re
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageSequence

import covey
from covey.views import animate
from covey.views.film.animation import frame_times
from covey.views.film.frames import FrameRenderer
from covey.views.games.scene import draw_numbers
from covey.views.games.snapshot import snapshot_at
from views.flown_games import SECOND_CAPTURE, game_by_hand, simulated


def test_a_gif_plays_as_long_as_it_should(tmp_path):
    calls = []
    film = animate(game_by_hand(), seconds=0.8, fps=15)
    path = film.save(tmp_path / "game.gif", progress=lambda *call: calls.append(call))
    assert calls == [(k, 12) for k in range(1, 13)]
    with Image.open(path) as film:
        size, durations = film.size, [p.info["duration"] for p in ImageSequence.Iterator(film)]
        assert film.info["loop"] == 0
    assert len(durations) == 12
    # 1/15 s isn't a whole number of hundredths: single frames are rounded, their sum is not.
    assert set(durations[:-1]) <= {60, 70}
    assert sum(durations) == 1800
    assert size == FrameRenderer(game_by_hand()).frame(0.0).shape[1::-1]
    assert path.stat().st_size < 100_000


@pytest.mark.parametrize("ending", ["gif", "mp4"])
def test_a_film_that_cannot_be_written_is_not_drawn(ending, tmp_path):
    pytest.importorskip("imageio_ffmpeg")
    drawn = []
    with pytest.raises(OSError, match=r"there is no folder .*; make it first: mkdir -p "):
        animate(game_by_hand()).save(
            tmp_path / "no" / f"a.{ending}", progress=lambda *_: drawn.append(1)
        )
    assert not drawn


def test_frames_are_even_in_time_and_end_with_the_game():
    times = frame_times(game_by_hand(), 7.0, 20.0)
    assert len(times) == 140
    assert times[0] == 0.0
    assert times[-1] == SECOND_CAPTURE
    assert np.diff(times) == pytest.approx(np.full(139, SECOND_CAPTURE / 139))


def test_the_camera_stands_still():
    renderer = FrameRenderer(simulated())
    limits = renderer.axes.get_xlim(), renderer.axes.get_ylim()
    times = frame_times(simulated(), 1.0, 6.0)
    frames = [renderer.frame(time) for time in times]
    assert (renderer.axes.get_xlim(), renderer.axes.get_ylim()) == limits
    moving = np.any([frame != frames[0] for frame in frames[1:]], axis=(0, 3))
    box = renderer.axes.get_window_extent()
    height = moving.shape[0]
    rows, columns = np.nonzero(moving)
    # All that moves is within the map, or in the caption above it.
    assert columns[rows > height - round(box.y1)].min() >= round(box.x0)
    assert rows.max() <= height - round(box.y0) + 1
    assert moving[round(height - box.y1) : round(height - box.y0)].sum() > 1000
    # A frame depends on its time alone.
    assert (renderer.frame(times[2]) == frames[2]).all()
    assert not renderer.axes.patches


def test_the_caption_counts():
    renderer = FrameRenderer(game_by_hand())
    renderer.frame(1.0)
    caption = renderer.axes.get_title(loc="left")
    assert caption.split("   ") == [
        "t = 1.00",
        f"guaranteed until {SECOND_CAPTURE:.2f}",
        "captured 1 of 2",
    ]


@pytest.mark.parametrize("name", ["x.png", "x.avi", "x"])
def test_other_endings_are_refused(tmp_path, name):
    with pytest.raises(covey.InputError, match=r"\.gif, \.mp4"):
        animate(game_by_hand()).save(tmp_path / name)


@pytest.mark.parametrize("rates", [{"fps": 0}, {"fps": 60}, {"seconds": -1.0}, {"width": 0}])
def test_rates_out_of_range_are_refused(rates):
    with pytest.raises(covey.InputError, match=next(iter(rates))):
        animate(game_by_hand(), **rates)


def test_without_ffmpeg_an_mp4_says_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    with pytest.raises(covey.InputError, match=r"pip install 'covey\[video\]'"):
        animate(game_by_hand()).save(tmp_path / "x.mp4")
    assert list(tmp_path.iterdir()) == []


class FakeFfmpeg:
    """Takes frames as imageio_ffmpeg does, and breaks off after some of them if it should."""

    def __init__(self, breaks_after=None):
        self.breaks_after, self.frames, self.options = breaks_after, [], None

    def write_frames(self, path, size, **options):
        self.size, self.options = size, options
        with Path(path).open("wb") as file:
            while True:
                try:
                    frame = yield
                except GeneratorExit:
                    return
                self.frames.append(frame)
                file.write(frame[:10])
                if len(self.frames) == self.breaks_after:
                    raise OSError("ffmpeg broke")


def test_an_mp4_gets_every_frame_and_holds_the_last(tmp_path, monkeypatch):
    fake = FakeFfmpeg()
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", fake)
    path = animate(game_by_hand(), seconds=0.5, fps=8).save(tmp_path / "game.mp4")
    assert len(fake.frames) == 4 + 8
    assert len(set(fake.frames[-9:])) == 1
    width, height = fake.size
    assert width % 2 == height % 2 == 0
    assert {len(frame) for frame in fake.frames} == {3 * width * height}
    assert fake.options["fps"] == 8
    assert path.stat().st_size == 120


def test_a_film_that_breaks_off_leaves_nothing_behind(tmp_path, monkeypatch):
    fake = FakeFfmpeg(breaks_after=2)
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", fake)
    with pytest.raises(OSError, match="ffmpeg broke"):
        animate(game_by_hand(), seconds=0.5, fps=8).save(tmp_path / "game.mp4")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("video", "begins"), [(None, "<img src"), (FakeFfmpeg(), "<video ")])
def test_a_film_plays_in_a_notebook_and_brings_all_that_it_needs(video, begins, monkeypatch):
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", video)
    page = animate(game_by_hand(), seconds=0.2, fps=10)._repr_html_()
    assert page.startswith(begins)
    kind, data = re.search(r'src="data:(image/gif|video/mp4);base64,([^"]+)"', page).groups()
    assert (kind == "video/mp4") == (video is not None)
    assert base64.b64decode(data)
    assert "http" not in page


def test_a_film_is_one_line_at_the_prompt():
    assert repr(animate(simulated(), seconds=3.0)).startswith("Film(Game(4 evaders, ")


def test_every_evader_carries_its_number_through_the_film():
    renderer = FrameRenderer(simulated())
    for time in (0.0, 1.0):
        numbers = draw_numbers(renderer.axes, snapshot_at(simulated(), time))
        assert [text.get_text() for text in numbers] == ["0", "1", "2", "3"]


@pytest.mark.parametrize("width", [3.5, 2.0])
def test_the_caption_fits_in_a_frame(width):
    team = covey.Team([(900.0, 300.0), (-200.0, 1000.0)], 0.3, 20.0, turn_radii=60.0, unit="m")
    game = covey.simulate(team, covey.PursuerDisk(speed=45.0), update_time=20.0)
    renderer = FrameRenderer(game, title="From 900 m", width=width)
    renderer.frame(game.survival_time)
    caption = renderer.axes._left_title  # there is no public way to it
    page = renderer.axes.figure.bbox
    box = caption.get_window_extent()
    assert caption.get_text().startswith("t = ")
    assert page.x0 < box.x0 < box.x1 < page.x1
