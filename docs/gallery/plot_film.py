"""
A film of a game
================

A hidden pursuer, the disk that the team believes it in, and the team that plans again and again.
"""

import covey

game = covey.load_scenario("fig3").simulate()
covey.animate(game, seconds=5.0, fps=12.0).save("film.gif")
print(f"survived {game.survival_time:.2f}, guaranteed {game.guarantee:.2f}")
