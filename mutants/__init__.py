"""Mutants: bugs planted in copies of the checkout, to see whether the tests catch them.

`python -m mutants` plants all. Read `bug` (what a bug is), `bugs` (a file for each room), then
`__main__` (which tests run, and what is told).
"""
