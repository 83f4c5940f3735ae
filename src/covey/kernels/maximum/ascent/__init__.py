"""An ascent: one local maximum of eq. 6 from given turns.

Read `local_model` and `curvature` (what a step is proposed by), `oracle` (which sequence is
missing), `trial` and `step`, then `sqp`, which is all of it. `large_team` repeats ascents where the
exact minimum is too slow to be asked at each step.
"""
