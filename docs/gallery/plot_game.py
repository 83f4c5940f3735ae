"""
All paths and captures
======================

One picture of a whole game against a pursuer that the team sees.
"""

import covey
from covey import scenarios, views

game = covey.load_scenario(scenarios.example_path("visible")).simulate()
figure = views.draw_game(game)
