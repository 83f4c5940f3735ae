"""Exit statuses of `covey` other than 0. Any other status is a fault of the program."""

from __future__ import annotations

OUTPUT_CLOSED = 1
"""Nobody reads the output to its end."""

INPUT_ERROR = 2
"""There is a mistake in a file or on the command line."""

GAMES_MISSING = 3
"""Games of a study could not be played; the others were."""

INTERRUPTED = 130
"""After Ctrl-C, as shells have it."""


class MissingGamesError(Exception):
    """Games of a study that could not be played; the message names them."""
