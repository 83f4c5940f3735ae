"""One worker: draws cases of a target until its time is up, or until one is a finding.

Hypothesis draws the cases, and simplifies one that fails. Coverage would guide a search little
here: most of what reads the files is compiled (pydantic, pyarrow, the kernels). Instead, answers
are told apart by their kind, so that a search shows how much of the error messages it has seen.
"""

from __future__ import annotations

import importlib
import json
import re
import sys
import time
import traceback
import warnings
from collections.abc import Callable
from pathlib import Path

from hypothesis import HealthCheck, Phase, given, seed, settings

from fuzz.oracle import require
from fuzz.target import Target, corpus

TARGETS = ("scenarios", "studies", "records", "results", "page", "calls")
MOST_SECONDS = 20.0
"""Of the processor, for a case; the largest legal ones take a tenth of that."""
ROUND = 100
"""Cases that Hypothesis draws from one seed; each round begins with small ones."""


def load(name: str) -> Target:
    """Return a target by its name."""
    target: Target = importlib.import_module(f"fuzz.{name}").TARGET
    return target


def try_case(target: Target, content: bytes) -> str:
    """Check a case and return what came of it; a warning or a waste of time is a finding too."""
    began = time.process_time()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        answer = target.check(content)
    seconds = time.process_time() - began
    require(seconds <= MOST_SECONDS, f"took {seconds:.0f} s of the processor")
    return answer


def shape(answer: str) -> str:
    """Return an answer without its numbers and quotations: what kind of answer it is."""
    words = re.sub(r"\"[^\"]*\"|'[^']*'|\S*\d\S*", "_", answer)
    return " ".join(words.split())[:200]


def search(name: str, run_seed: str, seconds: float, folder: Path) -> dict[str, object]:
    """Search until the time is up; return what was done.

    The folder holds `current`, the case that is being tried, and `found`, the last that failed.
    """
    target, deadline = load(name), time.monotonic() + seconds

    def attempt(content: bytes) -> str:
        (folder / "current").write_bytes(content)
        try:
            return shape(try_case(target, content))
        except Exception:
            # The last one is the simplest: from the first on, Hypothesis tries simpler ones.
            (folder / "found").write_bytes(content)
            (folder / "error").write_text(traceback.format_exc(), encoding="utf-8")
            raise

    known = {attempt(file.read_bytes()) for file in corpus(name)}
    answers: list[str] = []

    def body(content: bytes) -> None:
        if time.monotonic() < deadline:
            answers.append(attempt(content))

    number = 0
    while time.monotonic() < deadline:
        _round(target, body, f"{run_seed} {name} {number}")
        number += 1
    kinds = set(answers)
    return {"cases": len(answers), "answers": len(kinds), "new": sorted(kinds - known)}


def _round(target: Target, body: Callable[[bytes], None], round_seed: str) -> None:
    """Try `ROUND` cases; raise the exception of the simplest finding."""
    chosen = settings(
        max_examples=ROUND,
        deadline=None,
        database=None,
        phases=(Phase.generate, Phase.shrink),
        suppress_health_check=list(HealthCheck),
        report_multiple_bugs=False,
        print_blob=False,
    )
    seed(round_seed)(chosen(given(target.cases)(body)))()


def main(name: str, run_seed: str, seconds: str, folder: str = ".") -> int:
    """Search; write `result.json`, or leave a finding and its `error` in the folder."""
    place = Path(folder)
    try:
        done = search(name, run_seed, float(seconds), place)
    except Exception:
        if (place / "found").exists():
            return 1
        raise
    (place / "result.json").write_text(json.dumps(done), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
