"""The outer half of eq. 6: the maximum over the turns."""
