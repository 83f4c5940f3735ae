"""The compiled kernels as one library: how Python finds it, loads it and calls it.

Read `entry` (a call), `layout` (what crosses), `load` (which file), then `cache` (where it is
kept). Nothing here imports the compiler; a missing library is built by `kernels.builder`, in a
process of its own.
"""
