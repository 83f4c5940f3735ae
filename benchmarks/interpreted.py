"""A compiled solve, run again step by step, to see what the kernels that do its work are asked.

The functions that steer are interpreted; the kernels that they call are compiled as ever. What
these were given is noted, and the clock runs when they get it again, in a compiled loop.
"""

from __future__ import annotations

import copy
from collections import defaultdict
from functools import cache
from types import FunctionType

from numba.core.registry import CPUDispatcher
from numba.typed import List

from covey.kernels.minimum.labels import SubsetScratch
from stopwatch import seconds_of_all, seconds_of_one

_one, _all = cache(seconds_of_one), cache(seconds_of_all)


class Watch:
    """Notes the calls of the kernels named, while a kernel that uses them is interpreted."""

    def __init__(self, names):
        self.names, self.met = frozenset(names), set()
        self.calls = defaultdict(list)  # by kernel, copies of the arguments

    def interpreted(self, kernel):
        """Return the kernel as a Python function that calls the named kernels watched."""
        function = kernel.py_func
        known = dict(function.__globals__)
        for name in function.__code__.co_names:
            # A name may be that of an attribute alone: no kernel calls itself.
            if isinstance(known.get(name), CPUDispatcher) and known[name] is not kernel:
                called = known[name]
                watched = called.py_func.__name__ in self.names
                known[name] = self._watched(called) if watched else self.interpreted(called)
                self.met.add(called.py_func.__name__)
        return FunctionType(function.__code__, known, function.__name__, function.__defaults__)

    def _watched(self, kernel):
        def call(*arguments):
            # The dynamic programme's tables are large, and clean between calls: all share them.
            shared = {id(part): part for part in arguments if isinstance(part, SubsetScratch)}
            self.calls[kernel].append(copy.deepcopy(arguments, shared))
            return kernel(*arguments)

        return call

    def seconds(self, long):
        """Return, by name, the seconds of all calls noted, `long` ones or not; forget them."""
        found = {
            kernel.py_func.__name__: _all(kernel)(List(calls))
            if long
            else sum(_one(kernel)(arguments) for arguments in calls)
            for kernel, calls in self.calls.items()
        }
        self.calls.clear()
        return found
