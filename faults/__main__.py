"""`python -m faults`: try all faults, and tell what they came to."""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from pathlib import Path

from covey.kernels.library.load import load_library
from faults.catalogue import FAULTS, Fault, name_of, try_at
from faults.outcome import FaultError, SkippedError


def main() -> int:
    """Try the faults; return 1 if one had a consequence that it must not have."""
    by_name = {name_of(fault): fault for fault in FAULTS}
    parser = argparse.ArgumentParser(prog="python -m faults", description=__doc__)
    parser.add_argument("--seed", type=int, default=0, help="of the first moment; then one more")
    parser.add_argument("--fault", choices=by_name, nargs="+", help="by default all")
    parser.add_argument("--times", type=int, help="moments of each fault; by default many")
    given = parser.parse_args()
    load_library()
    failures = 0
    for name in given.fault or by_name:
        times = given.times or FAULTS[by_name[name]]
        failures += _try_all(by_name[name], given.seed, times)
    return 1 if failures else 0


def _try_all(fault: Fault, seed: int, times: int) -> int:
    """Try a fault at moments from a seed on, print a line, and return how many failed."""
    failures, began = 0, time.monotonic()
    for each in range(seed, seed + times):
        with tempfile.TemporaryDirectory() as folder:
            try:
                try_at(fault, each, Path(folder))
            except SkippedError as reason:
                print(f"{name_of(fault):28} skipped: {reason}", flush=True)
                return failures
            except FaultError as error:
                failures += 1
                print(f"FAILED: python -m faults --fault {name_of(fault)} --seed {each} --times 1")
                print(error, flush=True)
            except KeyboardInterrupt:
                sys.exit(f"{name_of(fault)}: stopped after {each - seed} of {times} moments")
    seconds = time.monotonic() - began
    print(f"{name_of(fault):28} {times:4} moments {failures:4} failed {seconds:6.0f} s", flush=True)
    return failures


if __name__ == "__main__":
    sys.exit(main())
