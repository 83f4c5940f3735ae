"""Compiled numerical kernels: numbers, arrays and records of these in and out; no I/O.

Importing this room imports the compiler. Read `capture`, `minimum`, `maximum`, then `play`: the
order of the paper. `linalg` knows of no game; `arrays` and `_jit` are what all chapters stand on.
"""
