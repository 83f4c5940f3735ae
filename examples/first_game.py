"""Five vehicles, and a pursuer last seen at the origin: what is guaranteed, and what happens."""

import numpy as np

import covey

rng = np.random.default_rng(3)
team = covey.Team(rng.uniform(-0.5, 0.5, (5, 2)), headings=rng.uniform(-np.pi, np.pi, 5))
disk = covey.PursuerDisk(center=(0.0, 0.0), speed=1.0)

plan = covey.plan(team, disk)
print(f"Guaranteed against any pursuer: {plan.survival_time:.3f}")

game = covey.simulate(team, disk, sensing="hidden")
for evader, time in zip(game.capture_sequence, game.capture_times, strict=True):
    print(f"  evader {evader} captured at {time:.3f}")
print(f"Survived: {game.survival_time:.3f}")
