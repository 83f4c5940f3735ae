"""
A plan and its critical sequences
=================================

Each evader turns, then flies straight. The guaranteed time is that of the worst order of capture.
"""

import covey

team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
disk = covey.PursuerDisk(radius=0.1)
plan = covey.plan(team, disk)
figure = covey.draw(plan)
count = len(plan.critical_sequences)
print(f"guaranteed {plan.survival_time:.3f} against {count} sequences")
