"""The one place that decides how kernels are compiled.

By default a kernel that Python calls runs in the compiled library, and the others are compiled into
it (`kernels.library`, `kernels.builder`). With `COVEY_JIT=1` numba compiles each kernel when it is
first called, which is quicker for whoever edits one of them. With `NUMBA_DISABLE_JIT=1` all are
plain Python, where an index beyond its array is an error.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any, TypeVar

from covey.kernels.library.entry import Entry

Function = TypeVar("Function", bound=Callable[..., object])

USES_PYTHON = os.environ.get("NUMBA_DISABLE_JIT", "0") not in ("", "0")
USES_NUMBA = os.environ.get("COVEY_JIT") == "1" and not USES_PYTHON

# - nogil: kernels touch no Python object, so threads may run them in parallel.
# - error_model="numpy": a division by zero gives inf as in NumPy, and no test for it stands in the
#   inner loops.
# - no fastmath: the guarantee is compared with what happens to 1e-9, and the same game must give
#   the same bits on every path through the code.
# - no runtime of numba's: nothing can be allocated, and no array is counted; the counting took four
#   fifths of the time of an interception.
OPTIONS = {"nogil": True, "error_model": "numpy", "_nrt": False}

entries: list[Any] = []
"""The kernels that Python calls, as the compiler sees them; empty unless numba compiles."""

compiled_kernels: list[Any] = []
"""All kernels that become functions, likewise."""


def entry(function: Function) -> Function:
    """Compile a kernel that Python calls, too: an entry of the compiled library."""
    if USES_NUMBA:
        kernel = compiled(function)
        entries.append(kernel)
        return kernel
    return function if USES_PYTHON else Entry(function)  # type: ignore[return-value]


def compiled(function: Function) -> Function:
    """Compile a kernel that other kernels call."""
    # Without the option a kernel would be inlined into each caller that itself is `inlined`.
    kernel = _by_numba(function, forceinline=False)
    if USES_NUMBA:
        compiled_kernels.append(kernel)
    return kernel


def inlined(function: Function) -> Function:
    """Compile a small kernel into each of its callers: a call costs as much as an interception."""
    return _by_numba(function, forceinline=True)


def expanded(function: Function) -> Function:
    """Expand a kernel's code into each of its callers before they are compiled.

    Without numba's runtime a compiled function can't return an array. An expanded one returns none.
    """
    return _by_numba(function, inline="always")


def _by_numba(function: Function, **options: Any) -> Function:
    if not USES_NUMBA:
        return function
    import numba

    kernel: Function = numba.njit(**OPTIONS, **options)(function)
    return kernel
