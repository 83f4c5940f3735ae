"""An interrupt of the program is one line, also while the program is being loaded."""

from __future__ import annotations

import signal
import subprocess
import sys

import pytest

STRUCK = """
import runpy, signal, sys

class Strike:
    def find_spec(self, name, *_):
        if name == {name!r}:
            signal.raise_signal(signal.SIGINT)

sys.meta_path.insert(0, Strike())
sys.argv = ["covey", "plan", "fig3"]
runpy.run_module("covey", run_name="__main__")
"""


@pytest.mark.parametrize("name", ["covey.cli", "cyclopts", "covey.cli.commands.plan", "numpy"])
def test_an_interrupt_while_a_module_is_loaded_is_one_line(name):
    done = subprocess.run(
        [sys.executable, "-c", STRUCK.format(name=name)],
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "covey: stopped\n")


ENDED = """
import atexit, signal, sys
from covey.__main__ import run

sys.argv = ["covey", "--version"]
atexit.register(signal.raise_signal, signal.SIGINT)
sys.exit(run())
"""


@pytest.mark.skipif(sys.platform == "win32", reason="a signal has another status there")
def test_an_interrupt_while_python_ends_has_no_traceback():
    done = subprocess.run(
        [sys.executable, "-c", ENDED], capture_output=True, encoding="utf-8", check=False
    )
    assert (done.returncode, done.stderr) == (-signal.SIGINT, "")


IGNORED = """
import signal, sys, time
import covey.cli
from covey.__main__ import run

class Finalized:
    def __del__(self):
        signal.raise_signal(signal.SIGINT)

def main():
    Finalized()
    while True:
        time.sleep(0.01)

covey.cli.main = main
sys.exit(run())
"""


# Python ignores the exceptions of finalizers, and of callbacks of its import system.
def test_an_interrupt_in_a_finalizer_is_not_ignored():
    done = subprocess.run(
        [sys.executable, "-c", IGNORED],
        capture_output=True,
        encoding="utf-8",
        check=False,
        timeout=50.0,
    )
    assert (done.returncode, done.stderr) == (130, "covey: stopped\n")
