"""The soak plays what it says, and stops at the first game that breaks a rule, with its seed."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from soak import trial

ROOT = Path(__file__).parents[1]

BOAST = """
from soak import trial
from soak.__main__ import main

honest = trial.covey.simulate


def boasting(team, disk, **settings):
    game = honest(team, disk, **settings)
    if len(team) == 3 and not hasattr(settings["evaders"], "__self__"):
        object.__setattr__(game, "guarantee", 2.0 * game.survival_time)
    return game


trial.covey.simulate = boasting

if __name__ == "__main__":
    raise SystemExit(main())
"""
"""A covey that claims too much of its plans for three evaders, in the workers too."""


def soak(tmp_path, *arguments, program=None):
    """Run the soak; return the finished process and what it saved."""
    start = ["-m", "soak"] if program is None else [str(program)]
    output = tmp_path / "soak.json"
    done = subprocess.run(
        [sys.executable, *start, "--output", str(output), *arguments],
        cwd=ROOT,
        env={"PYTHONPATH": f"{ROOT}:{ROOT / 'src'}"},
        capture_output=True,
        text=True,
        check=False,
    )
    return done, json.loads(output.read_text()) if output.exists() else None
