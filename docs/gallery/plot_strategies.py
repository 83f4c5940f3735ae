"""
One start, every team
=====================

How long each of covey's teams survives from the same start, against the same pursuer.
"""

import matplotlib.pyplot as plt

import covey

scenario = covey.load_scenario("fig3")
teams = {
    "iterative-open-loop": covey.IterativeOpenLoop(),
    "open-loop": covey.OpenLoop(),
    "constant-heading": covey.ConstantHeading(),
    "largest-distance": covey.LargestDistance(replan_time=0.1),
    "straight-away": covey.StraightAway(),
    "hold-course": covey.HoldCourse(),
}
times = {
    name: covey.simulate(
        scenario.team, scenario.disk, evaders=team, pursuer=covey.CommittedPursuer()
    ).survival_time
    for name, team in teams.items()
}

figure, axes = plt.subplots(figsize=(6.0, 2.5), layout="constrained")
axes.barh(list(times)[::-1], list(times.values())[::-1])
axes.set_xlabel("survival time")
