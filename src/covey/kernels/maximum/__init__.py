"""The outer half of eq. 6: the turns that maximise the minimum over all capture sequences.

Read `problem`, `working_set`, `local_model`, `curvature`, `trial`, `step` and `sqp`, then
`multistart`.
"""
