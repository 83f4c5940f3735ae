"""A compiled solve, run again step by step, with a clock on the kernels that do its work.

The functions that steer are interpreted, so that one can see what they call; the kernels that they
call are compiled, and each call is timed in a compiled loop, on a copy of its own arguments.
"""

from __future__ import annotations

import copy
from collections import Counter
from functools import cache
from types import FunctionType

from numba.core.registry import CPUDispatcher

from stopwatch import seconds_of

_loop_of = cache(seconds_of)


class Watch:
    """Seconds spent in the kernels named, while a kernel that uses them is interpreted.

    Each call is made `calls` times, five times over, and counted once.
    """

    def __init__(self, names, calls):
        self.names, self.calls = frozenset(names), calls
        self.seconds, self.met = Counter(), set()

    def interpreted(self, kernel):
        """Return the kernel as a Python function that calls the named kernels watched."""
        function = kernel.py_func
        known = dict(function.__globals__)
        for name in function.__code__.co_names:
            if isinstance(known.get(name), CPUDispatcher):
                called = known[name]
                watched = called.py_func.__name__ in self.names
                known[name] = self._watched(called) if watched else self.interpreted(called)
                self.met.add(called.py_func.__name__)
        return FunctionType(function.__code__, known, function.__name__, function.__defaults__)

    def _watched(self, kernel):
        name, loop = kernel.py_func.__name__, _loop_of(kernel)

        def call(*arguments):
            self.seconds[name] += loop(self.calls, copy.deepcopy(arguments))
            return kernel(*arguments)

        return call
