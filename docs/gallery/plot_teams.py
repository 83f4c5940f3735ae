"""
A small tournament
==================

Four teams against three pursuers: mean survival times, relative to the first team.
"""

import tempfile

import covey

teams = ["iterative-open-loop", "open-loop", "straight-away", "hold-course"]
pursuers = ["committed", "nearest-first", "best-sequence"]
study = covey.Study(
    starts=20,
    team_size=[2, 3],
    sensing="hidden",
    update_time=0.05,
    evaders=teams,
    pursuer=pursuers,
)
with tempfile.TemporaryDirectory() as folder:
    figure = covey.draw(covey.run_study(study, folder, workers=1))
