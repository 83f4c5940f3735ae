"""What a terminal shows while a command computes, and that nothing else sees it."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys

import pytest

COVEY = [sys.executable, "-m", "covey"]
PLAN = [*COVEY, "plan", "fig3", "--json"]
SCORE = [*COVEY, "score", "covey:StraightAway", "paper-2", "--beside", "hold-course"]


@pytest.mark.parametrize(
    ("command", "said"), [(PLAN, b"planning"), (SCORE, b"playing")], ids=["plan", "score"]
)
def test_a_terminal_shows_that_something_is_going_on(command, said):
    pty = pytest.importorskip("pty")
    reader, terminal = pty.openpty()
    environment = {**os.environ, "TERM": "xterm"}
    shown = b""
    with subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=terminal, env=environment
    ) as running:
        os.close(terminal)
        with contextlib.suppress(OSError):  # so Linux tells that nobody writes any more
            while chunk := os.read(reader, 4096):
                shown += chunk
    os.close(reader)
    assert running.returncode == 0
    assert said in shown


def test_nothing_else_sees_it():
    ran = subprocess.run(PLAN, capture_output=True, check=True)
    assert b"planning" not in ran.stderr
