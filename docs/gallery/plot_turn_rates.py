"""
What a higher turn rate brings
==============================

A small Fig. 5: the survival time of larger teams grows more.
"""

import math
import tempfile

import covey

rates = [math.pi / 4, math.pi / 2, math.pi, 2.0 * math.pi]
study = covey.Study(starts=40, team_size=[2, 4], turn_rate=rates, sensing="hidden")
with tempfile.TemporaryDirectory() as folder:
    figure = covey.draw(covey.run_study(study, folder, workers=1))
