"""A pursuer of your own. A strategy is a function that sees the situation and decides."""

import numpy as np

import covey


def nearest_first(situation: covey.Situation) -> covey.Chase:
    off = situation.team.positions - situation.disk.center
    nearest = np.hypot(off[:, 0], off[:, 1]).argmin()
    return covey.Chase((situation.evaders[nearest],))


rng = np.random.default_rng(4)
team = covey.Team(rng.uniform(-0.5, 0.5, (5, 2)), headings=rng.uniform(-np.pi, np.pi, 5))
disk = covey.PursuerDisk(center=(0.0, 0.0), speed=1.0)

for pursuer in (nearest_first, covey.CommittedPursuer()):
    game = covey.simulate(team, disk, pursuer=pursuer, sensing="visible")
    name, order = game.strategies["pursuer"]["name"], game.capture_sequence.tolist()
    print(f"{name}: captures {order}, the last at {game.survival_time:.3f}")
print(f"No pursuer is done before {game.guarantee:.3f}")
