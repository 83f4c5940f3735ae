"""One picture of a game: positions, trails, and the disk that the team knows of."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from covey.envs.episode import Episode
from covey.kernels.capture.path import HEADING, X, Y
from covey.model.validation import Floats

if TYPE_CHECKING:
    from pygame import Surface

SIZE = 600
"""Width and height of a picture, pixels."""

PURSUER = -1
"""Key of the pursuer's trail; an evader's is its number."""

_FINER = 2  # pictures are drawn larger by this factor, then shrunk, which smooths the edges
_PAPER, _INK = (255, 255, 255), (60, 60, 60)
_EVADER, _PURSUER, _DISK = (0, 114, 178), (213, 94, 0), (252, 232, 214)
_EDGE = (235, 160, 105)  # of the disk: what the team knows of the pursuer ends here
_DART = _FINER * np.array([[9.0, 0.0], [-6.0, 5.0], [-3.0, 0.0], [-6.0, -5.0]])  # flies along +x
_CROSS = _FINER * 4.0
_BESIDE = _FINER * 14.0  # from an evader to its number, at its left


def load_pygame() -> Any:
    """Return pygame. It is loaded with the first picture."""
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
    try:
        return import_module("pygame")
    except ModuleNotFoundError as error:
        raise ImportError("pictures need pygame: pip install 'covey[env]'") from error


def draw(episode: Episode, trails: Mapping[int, Sequence[Floats]], extent: float) -> Surface:
    """Return a picture (SIZE, SIZE) that shows coordinates up to `extent`, and a margin."""
    pygame = load_pygame()
    surface = pygame.Surface((_FINER * SIZE, _FINER * SIZE))
    surface.fill(_PAPER)
    scale = 0.5 * _FINER * SIZE / (1.15 * extent)

    def pixels(positions: npt.ArrayLike) -> Floats:
        return 0.5 * _FINER * SIZE + scale * np.asarray(positions) * (1.0, -1.0)

    state = episode.state
    pygame.draw.circle(surface, _DISK, pixels(state.disk[:2]), scale * state.disk[2])
    pygame.draw.circle(surface, _EDGE, pixels(state.disk[:2]), scale * state.disk[2], _FINER)
    for number, trail in trails.items():
        if len(trail) > 1:
            color = _PURSUER if number == PURSUER else _EVADER
            pygame.draw.lines(surface, color, False, pixels(trail), _FINER)
        if number != PURSUER and number not in episode.living:
            x, y = pixels(trail[-1])
            for side in (_CROSS, -_CROSS):
                ends = (x - _CROSS, y - side), (x + _CROSS, y + side)
                pygame.draw.line(surface, _INK, *ends, 2 * _FINER)
            _write(surface, str(number), (x, y - _BESIDE), 20)
    for i, row in zip(episode.living.tolist(), state.evaders, strict=False):
        cosine, sine = math.cos(row[HEADING]), math.sin(row[HEADING])
        turned = _DART @ np.array([[cosine, -sine], [sine, cosine]])  # y points down on a screen
        pygame.draw.polygon(surface, _EVADER, pixels(row[[X, Y]]) + turned)
        _write(surface, str(i), pixels(row[[X, Y]]) + _BESIDE * np.array([-sine, -cosine]), 20)
    pursuer = pixels(state.pursuer[:2])
    pygame.draw.circle(surface, _PURSUER, pursuer, 4.0 * _FINER)
    pygame.draw.circle(surface, _PURSUER, pursuer, scale * episode.rules.reach, _FINER)
    _caption(surface, episode)
    _scale_bar(surface, scale)
    picture: Surface = pygame.transform.smoothscale(surface, (SIZE, SIZE))
    return picture


def _caption(surface: Surface, episode: Episode) -> None:
    count = episode.setup.team_size
    text = (
        f"time {episode.time:.2f}     guaranteed {episode.guarantee:.2f}"
        f"     captured {count - len(episode.living)} of {count}"
    )
    _write(surface, text, (_FINER * SIZE / 2, 18 * _FINER), 24)


def _scale_bar(surface: Surface, scale: float) -> None:
    """Draw a bar of a round length, a tenth to a quarter of the picture, with its length."""
    length = round_below(0.25 * _FINER * SIZE / scale)
    left, y = 16 * _FINER, _FINER * (SIZE - 16)
    right = left + scale * length
    line = load_pygame().draw.line
    line(surface, _INK, (left, y), (right, y), _FINER)
    for x in (left, right):
        line(surface, _INK, (x, y - 4 * _FINER), (x, y + 4 * _FINER), _FINER)
    _write(surface, f"{length:g}", (0.5 * (left + right), y - 12 * _FINER), 22)


def round_below(length: float) -> float:
    """Return the largest of ..., 0.1, 0.2, 0.5, 1, 2, 5, 10, ... that isn't above a length."""
    power = 10.0 ** math.floor(math.log10(length))
    return max(step * power for step in (1.0, 2.0, 5.0) if step * power <= length)


def _write(surface: Surface, text: str, middle: Sequence[float] | Floats, size: int) -> None:
    """Write a text around a point."""
    font = load_pygame().font
    font.init()
    image = font.Font(None, size * _FINER).render(text, True, _INK)
    surface.blit(image, image.get_rect(center=tuple(middle)))
