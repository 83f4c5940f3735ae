"""
What it costs not to know
=========================

The guaranteed time falls as the disk, in which the pursuer is for all the team knows, grows.
"""

import matplotlib.pyplot as plt
import numpy as np

import covey

team = covey.Team([[0.6, 0.1], [-0.3, 0.7], [0.1, -0.8]], headings=[0.1, 2.0, -1.4])
radii = np.linspace(0.0, 0.5, 11)
guaranteed = [covey.plan(team, covey.PursuerDisk(radius=r)).survival_time for r in radii]

figure, axes = plt.subplots(figsize=(4.0, 2.5), layout="constrained")
axes.plot(radii, guaranteed, marker="o")
axes.set_xlabel("radius of the disk")
axes.set_ylabel("guaranteed survival time")
