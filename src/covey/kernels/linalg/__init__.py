"""Linear algebra of a few variables; it knows of no game."""
