"""The compiled library and the compiler's ordinary way give the same games, to the last bit."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

PROGRAM = Path(__file__).parent / "many_games.py"


def printed(**settings):
    """What the program prints in a process with these settings."""
    ran = subprocess.run(
        [sys.executable, str(PROGRAM)],
        env={**os.environ, **settings},
        capture_output=True,
        text=True,
        check=False,
    )
    assert ran.returncode == 0, ran.stderr
    return ran.stdout.splitlines()


def test_a_thousand_games_are_the_same_by_the_library_and_by_the_jit():
    by_library, by_jit = printed(COVEY_JIT="0"), printed(COVEY_JIT="1")
    assert len(by_library) > 1000
    assert by_library == by_jit
