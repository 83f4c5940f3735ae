"""The outer half of eq. 6: the turns that maximise the minimum over all capture sequences.

Read `problem`, `working_set`, `local_model`, `curvature`, `trial`, `sqp`; then `multistart`.
`fixed_sequence` and `stationarity` are about one known capture sequence.
"""
