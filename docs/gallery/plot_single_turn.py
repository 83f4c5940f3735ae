"""
One turn, then straight
=======================

The paper's Fig. 1: the heading over time, and the path that follows from it (eq. 5).
"""

from covey import views

figure = views.draw_control()
