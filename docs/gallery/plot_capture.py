"""
The earliest capture of one evader
==================================

The paper's Fig. 2: the disk in which the pursuer can be grows until it meets the evader (eq. 7).
"""

from covey import views

figure = views.draw_capture()
