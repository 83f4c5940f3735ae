"""The header in the documents declares the entries as they are."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

HEADER = Path(__file__).parents[3] / "docs" / "reference" / "covey.h"


def test_the_header_is_that_of_the_entries():
    """In a process of its own, for here the kernels may be plain Python."""
    command = [sys.executable, "-m", "covey.kernels.builder.header"]
    printed = subprocess.run(command, capture_output=True, encoding="utf-8", check=True).stdout
    written = HEADER.read_text(encoding="utf-8")
    assert printed == written, f"write it anew: {' '.join(command[1:])} > docs/reference/covey.h"


def test_a_few_entries_are_enough():
    assert 20 <= HEADER.read_text(encoding="utf-8").count("\nint64_t covey_") <= 40
