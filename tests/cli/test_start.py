"""`covey` as a program of its own: it starts quickly, teaches, and ends as a shell expects."""

from __future__ import annotations

import ast
import subprocess
import sys

import pytest

from covey.cli import main
from covey.cli.app import COMMANDS
from covey.scenarios import example_names

NAMES = [name.replace("_", "-") for name in COMMANDS]
COVEY = [sys.executable, "-m", "covey"]
UNUSED_BY_A_PLAN = [
    *("numba", "matplotlib", "pyarrow", "loky", "scipy", "dask", "distributed"),
    *("starlette", "uvicorn", "covey.studies.running"),
]
HEAVY = [*UNUSED_BY_A_PLAN, "numpy", "pydantic", "llvmlite"]


def run(*arguments):
    return subprocess.run([*COVEY, *arguments], capture_output=True, text=True, check=False)


def loaded(statement, modules):
    """Which of these modules a new process has loaded after a statement."""
    found = f"[name for name in {modules} if name in sys.modules]"
    code = f"import sys\n{statement}\nprint({found}, file=sys.stderr)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return ast.literal_eval(done.stderr.splitlines()[-1])


@pytest.mark.parametrize(
    "room",
    [
        "covey",
        "covey.model.units",
        "covey.scenarios",
        "covey.instances",
        "covey.studies",
        "covey.views",
    ],
)
def test_a_room_of_public_names_loads_nothing_heavy(room):
    assert loaded(f"import {room}", HEAVY) == []


@pytest.mark.parametrize(
    "words",
    [["--help"], ["--version"], ["plam"], *([each, "--help"] for each in NAMES)],
    ids=" ".join,
)
def test_nothing_heavy_is_loaded_to_answer_a_question(words):
    assert loaded(f"from covey.cli import main; main({words})", HEAVY) == []


@pytest.mark.parametrize("words", [["plan", "fig3"], ["simulate", "unequal"]], ids=" ".join)
def test_a_command_loads_no_library_that_it_does_not_use(words):
    assert loaded(f"from covey.cli import main; main({words})", UNUSED_BY_A_PLAN) == []


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


@pytest.mark.parametrize("command", NAMES)
def test_the_help_of_each_command_shows_how_it_is_called(command, capsys):
    assert main([command, "--help"]) == 0
    text = capsys.readouterr().out
    assert "--empty-" not in text  # nobody needs the opposite of an option that takes numbers
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
