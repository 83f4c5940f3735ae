"""A kernel that Python calls: a flat entry of the compiled library.

In C an entry is `int64_t covey_NAME(const int64_t *words, int64_t *results)`. It returns 0. The
caller owns all memory: the words are read, the results and the arrays among the arguments are
written.
"""

from __future__ import annotations

import ctypes
import functools
from collections.abc import Callable
from typing import Any

from covey.kernels.library.layout import parameters_of, results_of, words_expression
from covey.kernels.library.load import entry_point

_C_TYPES = {"float": ctypes.c_double, "int": ctypes.c_int64, "bool": ctypes.c_int64}


def symbol_of(kernel: Callable[..., object]) -> str:
    """Return the name of a kernel's entry in the library."""
    return f"covey_{kernel.__name__}"


class Entry:
    """Calls a kernel in the compiled library, which the first call loads.

    `__wrapped__` is the kernel as plain Python.
    """

    def __init__(self, kernel: Callable[..., object]) -> None:
        functools.update_wrapper(self, kernel)
        self._kernel = kernel

    def __call__(self, *arguments: Any) -> Any:
        """Call the kernel."""
        return self._call(*arguments)

    @functools.cached_property
    def _call(self) -> Callable[..., Any]:
        """Write the call out, for a loop over the arguments would cost as much as an interception.

        A call packs the words, runs the entry and unpacks the results.
        """
        parameters = parameters_of(self._kernel)
        words, names = words_expression(parameters)
        names |= {"run": entry_point(symbol_of(self._kernel)), "fail": _fail}
        source = [f"def call({', '.join(parameters)}):"]
        kinds = results_of(self._kernel)
        if kinds:
            names |= {"Results": _results_type(kinds), "reference": ctypes.byref}
            source += [
                "    results = Results()",
                f"    if run({words}, reference(results)): fail()",
                f"    return {', '.join(map(_value, range(len(kinds)), kinds))}",
            ]
        else:
            source += [f"    if run({words}, None): fail()"]
        exec("\n".join(source), names)
        call: Callable[..., Any] = names["call"]
        return call


def _results_type(kinds: list[str]) -> type[ctypes.Structure]:
    fields = [(f"value_{k}", _C_TYPES[kind]) for k, kind in enumerate(kinds)]
    return type("Results", (ctypes.Structure,), {"_fields_": fields})


def _value(k: int, kind: str) -> str:
    return f"results.value_{k}" + (" != 0" if kind == "bool" else "")


def _fail() -> None:
    raise RuntimeError("a kernel ended with an error, which none should; please report it")
