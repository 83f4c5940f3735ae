"""Captures of evaders on given paths: eq. 5, eq. 7 and Algorithm 1 of the paper.

Read `path`, `pursuit`, `interception`, `sequence`, then `derivatives`. `straight_legs` is the
vectorised closed form that `interception` and the minima share.
"""
