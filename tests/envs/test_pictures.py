"""Pictures show who is where; a window shows the same."""

from __future__ import annotations

import numpy as np
import pytest

from covey.envs import picture, pursuit_v0
from covey.envs.picture import SIZE
from envs.scripted_players import towards_nearest

BLUE, ORANGE, DISK, EDGE = (0, 114, 178), (213, 94, 0), (252, 232, 214), (235, 160, 105)


def pixels(shown, color):
    """Places (n, 2), column and row, of the pixels of a colour."""
    return np.argwhere((shown == color).all(axis=-1))[:, ::-1]


def test_everybody_is_where_it_is():
    env = pursuit_v0.TeamEnv(team_size=1, render_mode="rgb_array")
    env.reset(options={"positions": [[0.4, 0.2]], "headings": [0.0]})
    shown = env.render()
    assert shown.shape == (SIZE, SIZE, 3)
    assert shown.dtype == np.uint8
    middle, scale = SIZE / 2, SIZE / 2 / (1.15 * 0.5)
    np.testing.assert_allclose(pixels(shown, ORANGE).mean(axis=0), middle, atol=2.0)
    evader = middle + scale * np.array([0.4, -0.2])
    np.testing.assert_allclose(pixels(shown, BLUE).mean(axis=0), evader, atol=3.0)


def test_a_hidden_pursuers_disk_grows_in_the_picture():
    env = pursuit_v0.PursuerEnv(sensing="hidden", render_mode="rgb_array")
    env.reset(seed=4)
    areas = []
    for _ in range(4):
        areas.append(len(pixels(env.render(), DISK)))
        env.step([0.0, 0.0])
    assert areas == sorted(areas)
    assert areas[-1] > 2000


def test_what_the_team_knows_of_the_pursuer_has_an_edge():
    env = pursuit_v0.PursuerEnv(sensing="hidden", disk_radius=0.3, render_mode="rgb_array")
    env.reset(seed=4)
    edge = pixels(env.render(), EDGE)
    middle, scale = SIZE / 2, SIZE / 2 / (1.15 * 0.5)
    np.testing.assert_allclose(np.hypot(*(edge - middle).T), 0.3 * scale, atol=2.0)


def test_the_caption_counts_the_captured_and_the_bar_tells_the_scale(monkeypatch):
    written = []
    monkeypatch.setattr(
        picture, "_write", lambda _, text, middle, size: written.append((text, middle))
    )
    env = pursuit_v0.PursuerEnv(team_size=2, render_mode="rgb_array")
    seen, _ = env.reset(seed=0)
    env.render()
    (first, _), (second, _), (caption, _), (length, _) = written
    assert (first, second, length) == ("0", "1", "0.2")
    assert caption.startswith("time 0.00     guaranteed ")
    assert caption.endswith("     captured 0 of 2")
    while len(written) == 4 or not written[-2][0].endswith("captured 1 of 2"):
        seen, *_ = env.step(towards_nearest(seen, 2))
        env.render()
    assert len(written[-3][0]) == 1  # the number of who is left


@pytest.mark.parametrize(
    ("length", "rounded"), [(1.0, 1.0), (0.19, 0.1), (4.9, 2.0), (5e3, 5e3), (0.021, 0.02)]
)
def test_the_bar_is_round(length, rounded):
    assert picture.round_below(length) == pytest.approx(rounded)


def test_nothing_is_drawn_unless_asked_for():
    env = pursuit_v0.PursuerEnv()
    env.reset(seed=0)
    assert env.render() is None


def test_a_window(monkeypatch):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    env = pursuit_v0.PursuerEnv(render_mode="human")
    seen, _ = env.reset(seed=0)
    for _ in range(3):
        seen, *_ = env.step(towards_nearest(seen, 3))
    import pygame

    shown = pygame.surfarray.array3d(pygame.display.get_surface())
    assert len(pixels(shown, BLUE)) > 100
    env.close()
    assert not pygame.display.get_init()
    env.close()
