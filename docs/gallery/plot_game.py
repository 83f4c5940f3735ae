"""
All paths and captures
======================

One picture of a whole game against a pursuer that the team sees.
"""

import covey

game = covey.load_scenario("visible").simulate()
figure = covey.draw(game)
