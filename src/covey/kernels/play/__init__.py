"""The rules of play, and games from one decision to the next (sections IV.C and V.B)."""
