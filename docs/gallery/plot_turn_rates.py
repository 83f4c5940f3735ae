"""
What a higher turn rate brings
==============================

A small Fig. 5: the survival time of larger teams grows more.
"""

import math
import tempfile

import matplotlib.pyplot as plt

import covey
from covey import studies

rates = [math.pi / 4, math.pi / 2, math.pi, 2.0 * math.pi]
study = covey.Study(
    starts=40, team_size=[2, 4], turn_rate=rates, sensing="hidden", update_time=0.05
)
with tempfile.TemporaryDirectory() as folder:
    lines = studies.summary(covey.run_study(study, folder, workers=1))

figure, axes = plt.subplots(figsize=(4.0, 2.5), layout="constrained")
for size in (2, 4):
    means = [line.survival.value for line in lines if line.settings["team_size"] == size]
    axes.plot(rates, [mean / means[0] for mean in means], marker="o", label=f"{size} evaders")
axes.set_xlabel("turn rate (rad)")
axes.set_ylabel("survival time, relative")
axes.legend()
