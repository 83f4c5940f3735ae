"""Compiled numerical kernels: numbers and arrays in and out; no classes, no I/O.

Importing this room imports the compiler, so the rooms above do it inside the functions that need
it.
"""
