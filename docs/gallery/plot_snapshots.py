"""
Moments of a game
=================

The paper's Fig. 3: the disk grows while the pursuer is hidden, and collapses at a capture.
"""

import covey
from covey import views

game = covey.load_scenario("fig3").simulate()
figure = views.draw_snapshots(game)
