"""The kernels as plain Python, where an index beyond its array is an error, not a wrong number."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent

QUICK = (
    "kernels/capture/test_path.py",
    "kernels/linalg/test_symmetric.py",
    "kernels/capture/test_derivatives.py::test_hessian",
    "kernels/linalg/test_quadratic_program.py::test_models_that_all_meet_in_a_point",
    "kernels/linalg/test_quadratic_program.py::test_models_twice_or_parallel",
    "kernels/capture/test_earliest_capture_by_hand.py",
    "kernels/minimum/test_guarantee_by_enumeration.py::test_worst_order_of_three_that_stand",
    "planning/test_plan_by_hand.py::test_mirrored_team",
    "planning/test_plan_by_hand.py::test_all_within_reach_at_the_start",
    "planning/test_warm_start.py::test_a_plan_that_starts_from_itself_stays",
)


@pytest.mark.skipif("NUMBA_DISABLE_JIT" in os.environ, reason="this is that run")
def test_some_tests_pass_without_compilation():
    """In a process of its own: numba decides when it is imported."""
    command = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider"]
    ran = subprocess.run(
        [*command, *(str(HERE.parent / test) for test in QUICK)],
        cwd=HERE.parent.parent,
        env={**os.environ, "NUMBA_DISABLE_JIT": "1"},
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert " passed" in ran.stdout
