"""Strategies of the pursuer.

Read `commitment` first (how a pursuer follows a sequence), then `committed` (the paper's, section
V.B) and `fixed_order`, then `parallel_approach` and `assured` (the pursuer with a guarantee), then
the pursuers of other kinds.
"""
