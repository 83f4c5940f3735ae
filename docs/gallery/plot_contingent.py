"""
A plan that answers captures
============================

The turns for now, and those that begin once an evader has been captured.
"""

import math

import covey

disk = covey.PursuerDisk()
positions = [[0.37, 0.34], [-0.24, 0.50], [-0.42, -0.35], [0.10, -0.46]]
team = covey.Team(positions, disk.headings_away(positions), turn_rates=math.inf)
tree = covey.plan_contingent(team, disk)
figure = covey.draw(tree)
print(f"without answers {covey.plan(team, disk).survival_time:.3f} is guaranteed")
print(f"with answers {tree.survival_time:.3f}")
