"""`python -m covey` is `covey`. This file is all that is loaded before an interrupt is one line."""

from __future__ import annotations

import signal
import sys


def run() -> int:
    """Run the command line with the words of this process, and return its exit status.

    An interrupt while the command line is being loaded is one line too. At the end the signal gets
    its default action, for Python would answer an interrupt in its own last steps by a traceback.
    """
    try:
        from covey.cli import main

        return main()
    except KeyboardInterrupt:
        print("covey: stopped", file=sys.stderr)
        return 130
    finally:
        signal.signal(signal.SIGINT, signal.SIG_DFL)


if __name__ == "__main__":
    sys.exit(run())
