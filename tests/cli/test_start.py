"""`covey` as a program of its own: it starts quickly, teaches, and ends as a shell expects."""

from __future__ import annotations

import subprocess
import sys

import pytest

from covey.cli import main
from covey.cli.app import COMMANDS
from covey.scenarios import example_names

COVEY = [sys.executable, "-m", "covey"]
HEAVY = ["numba", "matplotlib", "pyarrow", "pydantic", "numpy", "starlette", "uvicorn"]


def run(*arguments):
    return subprocess.run([*COVEY, *arguments], capture_output=True, text=True, check=False)


@pytest.mark.parametrize(
    "statement",
    [
        "import covey",
        "from covey.cli import main; main(['--help'])",
        "from covey.cli import main; main(['plan', '--help'])",
        "from covey.cli import main; main(['draw', '--help'])",
        "from covey.cli import main; main(['chase', '--help'])",
        "from covey.cli import main; main(['--version'])",
    ],
)
def test_nothing_heavy_is_loaded_to_answer_a_question(statement):
    code = f"import sys\n{statement}\nloaded = [m for m in {HEAVY} if m in sys.modules]\n"
    done = subprocess.run(
        [sys.executable, "-c", f"{code}assert not loaded, loaded"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr


def test_help_comes_at_once():
    # The processor's time, not the clock's: other tests run beside this one. Best of three.
    code = (
        "import time\nfrom covey.cli import main\nmain(['--help'])\n"
        "import sys\nprint(time.process_time(), file=sys.stderr)"
    )
    times = [
        float(
            subprocess.run(
                [sys.executable, "-c", code], capture_output=True, text=True, check=True
            ).stderr
        )
        for _ in range(3)
    ]
    assert min(times) < 0.4


def test_help_names_the_commands_the_examples_and_the_units(capsys):
    assert main(["--help"]) == 0
    text = " ".join(capsys.readouterr().out.split())
    for word in ("plan", "simulate", "draw", "reproduce", "chase", *example_names()):
        assert word in text
    assert "Angles are radians, counter-clockwise from +x" in text


@pytest.mark.parametrize("command", [name.replace("_", "-") for name in COMMANDS])
def test_the_help_of_each_command_shows_how_it_is_called(command, capsys):
    assert main([command, "--help"]) == 0
    text = capsys.readouterr().out
    assert "Try:" in text
    assert f"\n covey {command} " in text


def test_a_mistake_ends_the_program_with_status_2():
    done = run("pln")
    assert (done.returncode, done.stdout) == (2, "")
    assert 'Did you mean "plan"?' in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("arguments", [["--help"], ["plan", "unequal", "--json"]])
def test_a_reader_that_leaves_early_gets_no_traceback(arguments):
    with subprocess.Popen(
        [*COVEY, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        process.stdout.close()
        assert process.stderr.read() == b""
    assert process.returncode == 1
