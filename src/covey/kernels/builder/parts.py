"""Two objects, built side by side: the search for a plan, and all other entries.

The search is more than half of all code. What else calls it, a game, calls it in the other object.
"""

from __future__ import annotations

import gc
import multiprocessing
import os
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, wait
from contextlib import contextmanager
from typing import Any

from covey.kernels.builder.lower import (
    Progress,
    defines,
    import_kernels,
    lowered_texts,
    stand_in_for,
)
from covey.kernels.builder.optimise import Target, compiled_object, linked
from covey.kernels.play import policy

PARTS = ("search", "rest")
_SEARCH = ("multistart", "refine")  # the entries of the search; games call the last

_LOWERING, _LINKING = 0.6, 0.65  # shares of the time until the end of each; the rest is LLVM's
_INTERVAL = 0.2  # seconds

_shares: Any = None  # of the parts, in the processes that build them


def built_parts(targets: Sequence[Target], progress: Progress) -> list[list[bytes]]:
    """Return, for each target, the objects of all parts."""
    context = multiprocessing.get_context("spawn")
    shares = context.Array("d", len(PARTS))
    with (
        _environment_for_lowering(),
        ProcessPoolExecutor(
            len(PARTS), mp_context=context, initializer=_keep_shares, initargs=(shares,)
        ) as pool,
    ):
        building = [pool.submit(_built, part, targets) for part in PARTS]
        while wait(building, timeout=_INTERVAL).not_done:
            progress(sum(shares[:]) / len(PARTS))
        objects = [future.result() for future in building]
    return [list(each) for each in zip(*objects, strict=True)]


@contextmanager
def _environment_for_lowering() -> Iterator[None]:
    """Let processes that begin now lower only, for any processor, whatever the user's settings."""
    before = dict(os.environ)
    for name in [name for name in before if name.startswith("NUMBA_")]:
        del os.environ[name]
    os.environ |= {
        "COVEY_JIT": "1",
        "NUMBA_OPT": "0",
        "NUMBA_CPU_NAME": "generic",
        "NUMBA_CPU_FEATURES": "",
    }
    try:
        yield
    finally:
        os.environ.clear()
        os.environ |= before


def _keep_shares(shares: Any) -> None:
    global _shares
    _shares = shares


def _built(part: str, targets: Sequence[Target]) -> list[bytes]:
    """Return the objects of a part for all targets; it is lowered once."""
    gc.set_threshold(200_000)  # the compiler makes many small objects, and few of them are garbage
    text = linked(_lowered(part, lambda share: _report(part, _LOWERING * share)))
    objects = []
    for k, target in enumerate(targets):
        _report(part, _LINKING + (1.0 - _LINKING) * k / len(targets))
        objects.append(compiled_object(text, target))
    _report(part, 1.0)
    return objects


def _report(part: str, share: float) -> None:
    _shares[PARTS.index(part)] = share


def _lowered(part: str, progress: Progress) -> list[str]:
    kernels = import_kernels()
    search = [kernels.pop(name) for name in _SEARCH]
    if part == "search":
        return lowered_texts(search, search[-1], progress)
    stand_in = stand_in_for(search[-1])
    policy.refine = stand_in  # type: ignore[attr-defined] # in place of the import there
    texts = lowered_texts(kernels.values(), stand_in, progress)
    return [text for text in texts if not defines(text, stand_in)]
