"""Shows pictures in a window (`render_mode` "human"), or returns them as arrays ("rgb_array")."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from covey.envs.episode import Episode
from covey.envs.picture import PURSUER, SIZE, draw, load_pygame
from covey.kernels.capture.path import X, Y
from covey.model import InputError
from covey.model.validation import Floats, choice

if TYPE_CHECKING:
    from pygame import Surface

MODES = ["human", "rgb_array"]
RATE = 20
"""Pictures a second in the mode "human"."""


class Canvas:
    """Follows one game after another; with the mode None it does nothing.

    Parameters
    ----------
    mode
        None, "human" or "rgb_array".
    least_extent
        Pictures show at least the coordinates from -`least_extent` to `least_extent`.
    """

    def __init__(self, mode: str | None, least_extent: float) -> None:
        self.mode = None if mode is None else choice("render_mode", mode, MODES)
        self._least_extent = least_extent
        self._window: Surface | None = None
        self._episode: Episode | None = None

    def begin(self, episode: Episode) -> None:
        """Follow a game from its start."""
        self._episode, self._extent = episode, self._least_extent
        self._trails: dict[int, list[Floats]] = {}
        self.update()

    def update(self) -> None:
        """Add all positions to the trails; in the mode "human", show the game."""
        episode = self._episode
        if self.mode is None or episode is None:
            return
        state = episode.state
        positions = {i: state.capture_pose[i, :2] for i in self._trails if i != PURSUER}
        for i, row in zip(episode.living.tolist(), state.evaders, strict=False):
            positions[i] = row[[X, Y]]
        positions[PURSUER] = state.pursuer[:2]
        for i, position in positions.items():
            self._trails.setdefault(i, []).append(position.copy())
            self._extent = max(self._extent, float(np.abs(position).max()))
        if self.mode == "human":
            self._show(episode)

    def render(self) -> npt.NDArray[np.uint8] | None:
        """Return the picture (SIZE, SIZE, 3) in the mode "rgb_array"."""
        if self.mode != "rgb_array":
            return None
        if self._episode is None:
            raise InputError("render: expected a game to be begun; call reset() first")
        columns = load_pygame().surfarray.array3d(self._draw(self._episode))
        return np.ascontiguousarray(columns.swapaxes(0, 1))

    def close(self) -> None:
        """Close the window, if there is one."""
        if self._window is not None:
            load_pygame().display.quit()
            self._window = None

    def _draw(self, episode: Episode) -> Surface:
        return draw(episode, self._trails, self._extent)

    def _show(self, episode: Episode) -> None:
        pygame = load_pygame()
        if self._window is None:
            pygame.display.init()
            pygame.display.set_caption("covey: pursuit_v0")
            self._window = pygame.display.set_mode((SIZE, SIZE))
            self._clock = pygame.time.Clock()
        self._window.blit(self._draw(episode), (0, 0))
        pygame.event.pump()  # without events the window manager reports a hanging program
        pygame.display.flip()
        self._clock.tick(RATE)
