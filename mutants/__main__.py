"""Plant each bug of `bugs` in a copy of the checkout, and see whether the tests catch it.

    python -m mutants [--room] [WORD ...]

Only the bugs whose name or room is one of the words are planted; without words, all. The tests
beside the code run first, then those of its room, then the rest, until one fails; with --room, the
rest doesn't run. A bug counts as caught only if that test passes without the bug. Digests of the
sources differ with each bug, and no test knows their values.

Prints a Markdown table. The exit status is 1 if a bug survived or could not be planted.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from mutants.bug import Bug
from mutants.bugs import BUGS

ROOT = Path(__file__).resolve().parents[1]

_ELSEWHERE = {"kernels/maximum": ["planning", "bounds"], "kernels/play": ["simulation", "players"]}
"""Folders of the tests of a chapter that has no folder of tests."""

_PLANTING = "tests/test_mutants.py"
"""Tests that each bug can be planted. They fail where one has been planted, and tell nothing."""

_LONGEST = 1800
"""Seconds after which tests that don't end count as failed."""

NO_TESTS = 5
"""Exit status of pytest where all tests were run before."""

TOO_LONG, CRASHED = "tests that don't end", "tests whose process crashes"

_FAILED = re.compile(r"^(?:FAILED|ERROR) (\S+\.py(?:::\w+)*)", re.MULTILINE)


def main(words: Sequence[str]) -> int:
    """Plant the chosen bugs, and print what became of each."""
    chosen = {word for word in words if word != "--room"}
    planted = [bug for bug in BUGS if not chosen or chosen & {bug.name, bug.room}]
    if not planted:
        sys.exit(f"no bug or room is called {' or '.join(chosen)}")
    print("| room | bug | what it does | caught by |\n| --- | --- | --- | --- |")
    caught = 0
    for bug in planted:
        try:
            test = catching_test(bug, beside_only="--room" in words)
        except (LookupError, RuntimeError) as error:
            test, told = None, f"**{error}**"
        else:
            told = test or "**nothing**"
        caught += test is not None
        print(f"| {bug.room} | {bug.name} | {bug.harm} | {told} |", flush=True)
    print(f"\n{caught} of {len(planted)} bugs were caught.")
    return int(caught < len(planted))


def catching_test(bug: Bug, *, beside_only: bool) -> str | None:
    """Return the test that catches a bug, or None."""
    with tempfile.TemporaryDirectory() as folder:
        tree = copied_tree(Path(folder) / "bug")
        bug.plant(tree / "src" / "covey")
        # Kernels with a bug would drive others out of the user's cache.
        own = {"COVEY_CACHE_DIR": str(tree / "cache")} if bug.room == "kernels" else {}
        beside = tests_beside(bug)
        nearest = beside if beside_only else [*beside, "tests"]
        runs = ([path, *_without([_PLANTING, *nearest[:k]])] for k, path in enumerate(nearest))
        failed = next(filter(None, (first_failure(tree, run, own) for run in runs)), None)
        if failed in (None, TOO_LONG, CRASHED):
            return failed
        if first_failure(copied_tree(Path(folder) / "sound"), [failed], {}) is not None:
            raise RuntimeError(f"{failed} fails without the bug, too")
        return failed


def tests_beside(bug: Bug) -> list[str]:
    """Return the tests beside a bug, the nearest first: files of its file's name, then folders."""
    chapters = [each.as_posix() for each in Path(bug.file).parents[:-1]]
    elsewhere = [folder for chapter in chapters for folder in _ELSEWHERE.get(chapter, ())]
    folders = [ROOT / "tests" / each for each in (*elsewhere, *chapters)]
    named = [path for each in folders for path in each.glob(f"test_{Path(bug.file).stem}*.py")]
    nearest = dict.fromkeys([*named, *filter(Path.is_dir, folders)])
    return [path.relative_to(ROOT).as_posix() for path in nearest]


def _without(paths: Iterable[str]) -> Iterator[str]:
    return (f"--ignore={path}" for path in paths)


def copied_tree(target: Path) -> Path:
    """Copy the files that git tracks to `target`, and return it."""
    listed = subprocess.run(
        ["git", "-C", str(ROOT), "ls-files", "-z"], capture_output=True, check=True, text=True
    ).stdout
    for name in filter(None, listed.split("\0")):
        (target / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / name, target / name)
    return target


def first_failure(tree: Path, tests: Iterable[str], own: Mapping[str, str]) -> str | None:
    """Run tests of a tree with some variables of its own; return the first that fails."""
    command = [sys.executable, "-m", "pytest", "-x", "-q", "--tb=no", "-p", "no:cacheprovider"]
    try:
        done = subprocess.run(
            [*command, *tests],
            cwd=tree,
            env={**os.environ, "PYTHONPATH": str(tree / "src"), **own},
            capture_output=True,
            text=True,
            timeout=_LONGEST,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return TOO_LONG
    if done.returncode < 0:  # a signal
        return CRASHED
    failed = _FAILED.search(done.stdout)
    if failed is None and done.returncode not in {0, NO_TESTS}:
        raise RuntimeError(f"the tests don't run: {done.stdout[-500:]}{done.stderr[-500:]}")
    return None if failed is None else failed[1]


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
