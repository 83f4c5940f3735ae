"""Calls of the library's entries with arguments that are packed once."""

from __future__ import annotations

import ctypes

from covey.kernels.library.entry import symbol_of
from covey.kernels.library.layout import parameters_of, results_of, words_expression
from covey.kernels.library.load import entry_point


def ready(kernel, *arguments):
    """Return a function that calls a kernel, and whose `value()` is the first that it returned."""
    parameters = parameters_of(kernel)
    expression, names = words_expression(parameters)
    words = eval(f"lambda {', '.join(parameters)}: {expression}", names)(*arguments)
    results = (ctypes.c_double * len(results_of(kernel)))()
    entry, address = entry_point(symbol_of(kernel)), ctypes.addressof(results)

    def call():
        entry(words, address)

    call.keeps, call.value = (arguments, results), lambda: results[0]
    return call
