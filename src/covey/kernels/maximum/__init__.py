"""The outer half of eq. 6: the turns that maximise the minimum over all capture sequences.

Read `problem` and `working_set`, then `ascent`, which finds one local maximum, and `multistart`,
which finds the best of many. `expected_value` is for objectives that are expectations.
"""
