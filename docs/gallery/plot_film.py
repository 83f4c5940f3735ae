"""
A film of a game
================

A hidden pursuer, the disk that the team believes it in, and the team that plans again and again.
"""

import covey
from covey import scenarios, views

game = covey.load_scenario(scenarios.example_path("fig3")).simulate()
views.animate(game, "film.gif", seconds=5.0, fps=12.0)
print(f"survived {game.survival_time:.2f}, guaranteed {game.guarantee:.2f}")
