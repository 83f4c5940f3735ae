"""One picture of a game: who is where, how they came there, what the team knows."""

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

_FINER = 2  # drawn larger by this, then shrunk, which smooths the edges
_PAPER, _INK = (255, 255, 255), (60, 60, 60)
_EVADER, _PURSUER, _DISK = (0, 114, 178), (213, 94, 0), (252, 232, 214)
_DART = _FINER * np.array([[9.0, 0.0], [-6.0, 5.0], [-3.0, 0.0], [-6.0, -5.0]])  # flies along +x
_CROSS = _FINER * 4.0


def load_pygame() -> Any:
    """Return pygame, which is loaded when a picture is first asked for."""
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
    try:
        return import_module("pygame")
    except ModuleNotFoundError as error:
        raise ImportError("pictures need pygame: pip install 'covey[env]'") from error


def draw(episode: Episode, trails: Mapping[int, Sequence[Floats]], extent: float) -> Surface:
    """Return a picture (SIZE, SIZE); `extent` is the largest coordinate that it must show."""
    pygame = load_pygame()
    sheet = pygame.Surface((_FINER * SIZE, _FINER * SIZE))
    sheet.fill(_PAPER)
    scale = 0.5 * _FINER * SIZE / (1.15 * extent)

    def pixels(places: npt.ArrayLike) -> Floats:
        return 0.5 * _FINER * SIZE + scale * np.asarray(places) * (1.0, -1.0)

    state = episode.state
    pygame.draw.circle(sheet, _DISK, pixels(state.disk[:2]), scale * state.disk[2])
    for number, trail in trails.items():
        if len(trail) > 1:
            color = _PURSUER if number == PURSUER else _EVADER
            pygame.draw.lines(sheet, color, False, pixels(trail), _FINER)
        if number != PURSUER and number not in episode.living:
            x, y = pixels(trail[-1])
            for side in (_CROSS, -_CROSS):
                ends = (x - _CROSS, y - side), (x + _CROSS, y + side)
                pygame.draw.line(sheet, _INK, *ends, 2 * _FINER)
    for row in state.evaders[: len(episode.living)]:
        cosine, sine = math.cos(row[HEADING]), math.sin(row[HEADING])
        turned = _DART @ np.array([[cosine, -sine], [sine, cosine]])  # y points down on a screen
        pygame.draw.polygon(sheet, _EVADER, pixels(row[[X, Y]]) + turned)
    place = pixels(state.pursuer[:2])
    pygame.draw.circle(sheet, _PURSUER, place, 4.0 * _FINER)
    pygame.draw.circle(sheet, _PURSUER, place, scale * episode.rules.reach, _FINER)
    _caption(sheet, f"time {episode.time:.2f}     guaranteed {episode.guarantee:.2f}")
    picture: Surface = pygame.transform.smoothscale(sheet, (SIZE, SIZE))
    return picture


def _caption(sheet: Surface, text: str) -> None:
    font = load_pygame().font
    font.init()
    sheet.blit(font.Font(None, 24 * _FINER).render(text, True, _INK), (12 * _FINER, 10 * _FINER))
