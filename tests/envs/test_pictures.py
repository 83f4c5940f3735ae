"""Pictures show who is where; a window shows the same."""

from __future__ import annotations

import numpy as np

from covey.envs import pursuit_v0
from covey.envs.picture import SIZE
from envs.scripted_players import towards_nearest

BLUE, ORANGE, DISK, WHITE = (0, 114, 178), (213, 94, 0), (252, 232, 214), (255, 255, 255)


def pixels(picture, color):
    """Places (n, 2), column and row, of the pixels of a colour."""
    return np.argwhere((picture == color).all(axis=-1))[:, ::-1]


def test_everybody_is_where_it_is():
    env = pursuit_v0.TeamEnv(team_size=1, render_mode="rgb_array")
    env.reset(options={"positions": [[0.4, 0.2]], "headings": [0.0]})
    picture = env.render()
    assert picture.shape == (SIZE, SIZE, 3)
    assert picture.dtype == np.uint8
    middle, scale = SIZE / 2, SIZE / 2 / (1.15 * 0.5)
    np.testing.assert_allclose(pixels(picture, ORANGE).mean(axis=0), middle, atol=2.0)
    evader = middle + scale * np.array([0.4, -0.2])
    np.testing.assert_allclose(pixels(picture, BLUE).mean(axis=0), evader, atol=3.0)


def test_a_hidden_pursuers_disk_grows_in_the_picture():
    env = pursuit_v0.PursuerEnv(sensing="hidden", render_mode="rgb_array")
    env.reset(seed=4)
    areas = []
    for _ in range(4):
        areas.append(len(pixels(env.render(), DISK)))
        env.step([0.0, 0.0])
    assert areas == sorted(areas)
    assert areas[-1] > 2000


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
