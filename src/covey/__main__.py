"""`python -m covey` is `covey`. This file is all that is loaded before an interrupt is one line."""

from __future__ import annotations

import signal
import sys
import time
from _thread import interrupt_main, start_new_thread


def run() -> int:
    """Run the command line with the words of this process, and return its exit status.

    An interrupt while the command line is being loaded is one line too. At the end the signal gets
    its default action, for Python would answer an interrupt in its own last steps by a traceback.
    """
    sys.unraisablehook = _raise_again
    try:
        from covey.cli import main

        return main()
    except KeyboardInterrupt:
        print("covey: stopped", file=sys.stderr)
        return 130
    finally:
        signal.signal(signal.SIGINT, signal.SIG_DFL)


def _raise_again(ignored: sys.UnraisableHookArgs) -> None:
    """Interrupt again if an interrupt came inside a finalizer, whose exceptions Python ignores."""
    if ignored.exc_type is KeyboardInterrupt:
        start_new_thread(_interrupt_soon, ())
    else:
        sys.__unraisablehook__(ignored)


def _interrupt_soon() -> None:
    """Interrupt the main thread when it has left the finalizer."""
    time.sleep(0.01)
    interrupt_main()


if __name__ == "__main__":
    sys.exit(run())
