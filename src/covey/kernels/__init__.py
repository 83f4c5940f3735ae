"""Compiled numerical kernels: numbers, arrays and records of these in and out; no I/O.

Read `capture`, `minimum`, `maximum`, then `play`: the order of the paper. `bounds` and `contingent`
go past it. `linalg` knows of no game; `arrays` and `_jit` are what all chapters stand on. `library`
calls the compiled kernels, `builder` compiles them.
"""
