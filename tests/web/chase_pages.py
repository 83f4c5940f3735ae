"""A way to chase, for tests that play: fly to where the next one will be."""

from __future__ import annotations

import math


def aim(picture, cast):
    """Where to meet the evader that should be captured next, if it flies straight on."""
    i = picture["sequence"][0]
    x, y, heading, _ = picture["evaders"][i]
    away_x, away_y = x - picture["pursuer"][0], y - picture["pursuer"][1]
    speed = cast["speeds"][i]
    ahead = math.hypot(away_x, away_y) / cast["pursuer_speed"] * speed
    return x + ahead * math.cos(heading), y + ahead * math.sin(heading)
