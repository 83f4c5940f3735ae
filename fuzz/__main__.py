"""`python -m fuzz --minutes 10 --seed 1` searches; `python -m fuzz --case FILE` repeats a case."""

from __future__ import annotations

import argparse
import secrets
import sys
from pathlib import Path

from fuzz.search import TARGETS, load, try_case
from fuzz.watch import fuzz


def main() -> int:
    """Run the command line; return its exit status."""
    parser = argparse.ArgumentParser(prog="python -m fuzz", description=__doc__)
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--seed", type=int, default=secrets.randbelow(2**32))
    parser.add_argument("--case", type=Path, help="a file of fuzz/corpus or fuzz/findings")
    options = parser.parse_args()
    if options.case is None:
        return fuzz(options.minutes, options.seed)
    named = (name for name in TARGETS if name in (options.case.parent.name, _before(options.case)))
    target = load(next(named))
    print(try_case(target, options.case.read_bytes()))
    return 0


def _before(case: Path) -> str:
    """Return the target that a finding's name begins with."""
    return case.name.partition("-")[0]


if __name__ == "__main__":
    sys.exit(main())
