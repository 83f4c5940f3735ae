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
_DART = _FINER * np.array([[9.0, 0.0], [-6.0, 5.0], [-3.0, 0.0], [-6.0, -5.0]])  # flies along +x
_CROSS = _FINER * 4.0


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
    for number, trail in trails.items():
        if len(trail) > 1:
            color = _PURSUER if number == PURSUER else _EVADER
            pygame.draw.lines(surface, color, False, pixels(trail), _FINER)
        if number != PURSUER and number not in episode.living:
            x, y = pixels(trail[-1])
            for side in (_CROSS, -_CROSS):
                ends = (x - _CROSS, y - side), (x + _CROSS, y + side)
                pygame.draw.line(surface, _INK, *ends, 2 * _FINER)
    for row in state.evaders[: len(episode.living)]:
        cosine, sine = math.cos(row[HEADING]), math.sin(row[HEADING])
        turned = _DART @ np.array([[cosine, -sine], [sine, cosine]])  # y points down on a screen
        pygame.draw.polygon(surface, _EVADER, pixels(row[[X, Y]]) + turned)
    pursuer = pixels(state.pursuer[:2])
    pygame.draw.circle(surface, _PURSUER, pursuer, 4.0 * _FINER)
    pygame.draw.circle(surface, _PURSUER, pursuer, scale * episode.rules.reach, _FINER)
    _caption(surface, f"time {episode.time:.2f}     guaranteed {episode.guarantee:.2f}")
    picture: Surface = pygame.transform.smoothscale(surface, (SIZE, SIZE))
    return picture


def _caption(surface: Surface, text: str) -> None:
    font = load_pygame().font
    font.init()
    surface.blit(font.Font(None, 24 * _FINER).render(text, True, _INK), (12 * _FINER, 10 * _FINER))
