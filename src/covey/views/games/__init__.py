"""Pictures of games and plans."""
