"""The inner half of eq. 6: the minimum over all capture sequences.

Read `labels` and `last_capture`, the dynamic programme; `deadlines` and `greedy_sequence` prune it.
`large` does without a table of all sets, for teams that are too large for one. `total_time` is the
same for the sum of capture times; `inner_minimum` chooses between them.
"""
