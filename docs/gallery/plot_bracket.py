"""
How far from the best
=====================

The guarantee of a plan, and the time that no team could exceed, for faster and faster evaders.
"""

import matplotlib.pyplot as plt
import numpy as np

import covey

positions, headings = [[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], [0.3, 2.0, -1.4]
speeds = np.linspace(0.1, 0.6, 11)
teams = [covey.Team(positions, headings, speed) for speed in speeds]
brackets = [covey.bracket(team, covey.PursuerDisk()) for team in teams]

lower, upper = [each.lower for each in brackets], [each.upper for each in brackets]

figure, axes = plt.subplots(figsize=(4.0, 2.5), layout="constrained")
axes.plot(speeds, upper, "C1--", label="no team is sure of more")
axes.plot(speeds, lower, "C0", label="guaranteed")
axes.fill_between(speeds, lower, upper, color="C0", alpha=0.2, linewidth=0.0)
axes.legend()
axes.set_xlabel("speed of the evaders (pursuer: 1)")
axes.set_ylabel("survival time")
