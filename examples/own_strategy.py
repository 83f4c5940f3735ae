"""A strategy of one's own for either side: a function that sees the situation and decides."""

import numpy as np

import covey


def away(situation: covey.Situation) -> np.ndarray:
    """Turn every evader straight away from the middle of where the pursuer can be."""
    return covey.turns_to(situation.team, situation.disk.headings_away(situation.team.positions))


def nearest_first(situation: covey.Situation) -> covey.Chase:
    """Chase whoever is nearest now."""
    off = situation.team.positions - situation.disk.center
    return covey.Chase((situation.evaders[np.hypot(off[:, 0], off[:, 1]).argmin()],))


covey.testing.check_strategy(evaders=away)
covey.testing.check_strategy(pursuer=nearest_first)

rng = np.random.default_rng(4)
team = covey.Team(rng.uniform(-0.5, 0.5, (5, 2)), headings=rng.uniform(-np.pi, np.pi, 5))
disk = covey.PursuerDisk(center=(0.0, 0.0), speed=1.0)

for evaders in (away, "iterative-open-loop"):
    for pursuer in (nearest_first, "committed"):
        game = covey.simulate(team, disk, evaders=evaders, pursuer=pursuer, sensing="visible")
        names = " against ".join(str(side["name"]) for side in game.strategies.values())
        print(f"{names}: {game.survival_time:.3f}, by the first plan {game.guarantee:.3f}")
