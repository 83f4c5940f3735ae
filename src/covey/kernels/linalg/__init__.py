"""Linear algebra and quadratic programming of a few variables; they know of no game.

Read `symmetric`, then `quadratic_program` and the `active_set` of its method.
"""
