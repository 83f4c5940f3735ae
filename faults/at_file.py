"""`python -m faults.at_file COUNT SIGNAL WORDS`: run covey; it sends itself a signal at a file.

The signal comes just before the process opens, renames or removes a file of the results for the
COUNT-th time. Between two of these operations nothing changes that another process could see.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable

from covey.__main__ import run
from faults.study import RESULTS

_OPERATIONS = ("open", "os.mkdir", "os.rename", "os.remove")


def strike_at(count: int, number: int) -> Callable[[str, tuple[object, ...]], None]:
    """Return an audit hook that sends this process a signal at the count-th operation."""
    left = count

    def hook(event: str, arguments: tuple[object, ...]) -> None:
        nonlocal left
        if event in _OPERATIONS and str(arguments[0]).startswith(RESULTS):
            left -= 1
            if left == 0:
                os.kill(os.getpid(), number)

    return hook


if __name__ == "__main__":
    count, number = (int(sys.argv.pop(1)) for _ in range(2))
    sys.addaudithook(strike_at(count, number))
    sys.exit(run())
