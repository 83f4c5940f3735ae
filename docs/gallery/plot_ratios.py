"""
Hidden against visible
======================

A small Fig. 4: how much of its survival time a team loses when it can't see the pursuer.
"""

import tempfile

import covey

study = covey.Study(starts=60, team_size=[3, 5], update_time=0.05, pursuer="as-visible")
with tempfile.TemporaryDirectory() as folder:
    figure = covey.draw(covey.run_study(study, folder, workers=1))
