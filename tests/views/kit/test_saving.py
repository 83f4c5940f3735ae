"""Pictures in files: formats by their ending, the same bytes for the same picture."""

from __future__ import annotations

import subprocess
import sys

import matplotlib
import pytest
from PIL import Image

import covey
from covey.views import draw_control, draw_game, save
from views.flown_games import game_by_hand


@pytest.mark.parametrize("suffix", [".svg", ".pdf", ".png"])
def test_the_same_picture_gives_the_same_bytes(tmp_path, suffix):
    first = save(draw_game(game_by_hand()), tmp_path / f"first{suffix}")
    second = save(draw_game(game_by_hand()), tmp_path / f"second{suffix}")
    assert first.read_bytes() == second.read_bytes()
    assert first.stat().st_size > 5000


def test_settings_of_the_caller_neither_change_a_picture_nor_are_changed(tmp_path):
    plain = save(draw_control(), tmp_path / "plain.svg")
    with matplotlib.rc_context({"font.size": 30.0, "svg.hashsalt": "x", "axes.facecolor": "red"}):
        before = dict(matplotlib.rcParams)
        other = save(draw_control(), tmp_path / "other.svg")
        assert dict(matplotlib.rcParams) == before
    assert plain.read_bytes() == other.read_bytes()


def test_a_column_of_a_paper_at_300_dots_per_inch(tmp_path):
    with Image.open(save(draw_control(), tmp_path / "control.PNG")) as picture:
        assert picture.format == "PNG"
        assert picture.width == 1050
        assert picture.info["dpi"] == pytest.approx((300.0, 300.0), abs=0.1)


def test_the_file_that_was_written_is_returned(tmp_path):
    path = save(draw_control(), tmp_path / "control.svg")
    assert path == tmp_path / "control.svg"
    assert path.read_text().startswith("<?xml")


def test_a_missing_folder_is_not_made(tmp_path):
    with pytest.raises(FileNotFoundError, match="there is no folder"):
        save(draw_control(), tmp_path / "a" / "control.svg")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("name", "advice"),
    [("x.jpg", "'.jpg'"), ("x", "no ending"), ("x.gif", "covey.views.animate makes films")],
)
def test_other_endings_are_refused(tmp_path, name, advice):
    with pytest.raises(covey.InputError) as refusal:
        save(draw_control(), tmp_path / name)
    assert ".png, .svg, .pdf" in str(refusal.value)
    assert advice in str(refusal.value)
    assert list(tmp_path.iterdir()) == []


def test_an_unwritable_place_is_named(tmp_path):
    (tmp_path / "file").write_text("not a folder")
    with pytest.raises(OSError, match="can't be written") as failure:
        save(draw_control(), tmp_path / "file" / "control.png")
    assert "control.png" in str(failure.value)


def test_importing_the_room_is_cheap():
    heavy = "{'matplotlib', 'numba', 'PIL', 'numpy'} & set(sys.modules)"
    program = f"import sys, covey.views; print(dir(covey.views) and {heavy})"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, check=True)
    assert done.stdout.strip() == b"set()"


def test_every_public_name_is_there():
    for name in covey.views.__all__:
        assert callable(getattr(covey.views, name))
        assert getattr(covey.views, name).__doc__
    with pytest.raises(AttributeError, match="no_such"):
        _ = covey.views.no_such
