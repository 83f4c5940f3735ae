"""A study whose process gets a signal: Ctrl-C, or kill -9."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from covey import studies

pytestmark = pytest.mark.skipif(
    not Path("/proc/self").exists(), reason="the processes are found in /proc"
)


def hear_interrupts():
    """Hear interrupts also where a shell, which has this process in its background, has none."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture
def running(tmp_path):
    """A study that is played by two workers, in a process group of its own, and its folder."""
    text = studies.example_path("fig5").read_text(encoding="utf-8")
    (tmp_path / "long.toml").write_text(text, encoding="utf-8")
    folder = tmp_path / "result"
    command = [sys.executable, "-m", "covey", "study", "long.toml", "-o", str(folder)]
    with subprocess.Popen(
        [*command, "--workers", "2"],
        cwd=tmp_path,
        stderr=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        encoding="utf-8",
        start_new_session=True,
        preexec_fn=hear_interrupts,
    ) as process:
        wait_for(lambda: any((folder / "games").glob("*.parquet")), 60.0)
        yield process, folder
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)


def wait_for(holds, seconds):
    """Wait until a condition holds."""
    end = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.05)


def group(leader):
    """The processes of a group that live, by number."""
    found = set()
    for status in Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            state, _, number, *_ = status.read_text().rpartition(")")[2].split()
            if int(number) == leader and state != "Z":
                found.add(int(status.parent.name))
    return found


def test_an_interrupt_from_a_terminal_is_one_line_and_nothing_is_lost(running):
    process, folder = running
    os.killpg(process.pid, signal.SIGINT)
    _, errors = process.communicate(timeout=20)
    assert process.returncode == 130
    assert errors.splitlines() == [
        f"covey: stopped: {folder} keeps the games that were finished, "
        "and the same command goes on there"
    ]
    kept = sorted((folder / "games").glob("*.parquet"))
    assert kept
    assert not studies.load_study(folder).is_complete
    wait_for(lambda: not group(process.pid), 10.0)


def workers(leader):
    """The processes of a group that play games, by number."""
    found = set()
    for number in group(leader):
        with contextlib.suppress(OSError):
            if b"LokyProcess" in Path(f"/proc/{number}/cmdline").read_bytes():
                found.add(number)
    return found


def test_workers_end_with_the_command_although_they_have_been_stopped(tmp_path):
    """Python would wait for them at its exit."""
    script = """
import sys
from pathlib import Path
import covey
from covey.cli.show import study
from covey.studies import run_study

def run(*arguments, **options):
    result = run_study(*arguments, **options)
    print("played", flush=True)
    sys.stdin.readline()
    return result

study.studies.run_study, played = run, covey.Study(starts=4, team_size=2, update_time=0.2)
study.run_with_progress(played, Path("results"), 2)
"""
    pipes = dict.fromkeys(("stdin", "stdout"), subprocess.PIPE)
    with subprocess.Popen(
        [sys.executable, "-c", script],
        cwd=tmp_path,
        encoding="utf-8",
        start_new_session=True,
        **pipes,
    ) as process:
        assert process.stdout.readline() == "played\n"
        stopped = workers(process.pid)
        assert stopped
        for number in stopped:
            os.kill(number, signal.SIGSTOP)
        try:
            process.communicate("\n", timeout=20)
            assert process.returncode == 0
            wait_for(lambda: not group(process.pid), 10.0)
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)


def test_workers_end_with_a_parent_that_was_killed(running):
    process, _ = running
    assert len(group(process.pid)) >= 3
    process.kill()
    process.wait()
    wait_for(lambda: not group(process.pid), 10.0)
