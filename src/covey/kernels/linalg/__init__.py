"""Linear algebra and quadratic programming of a few variables; they know of no game.

Read `symmetric`, then `quadratic_program`.
"""
