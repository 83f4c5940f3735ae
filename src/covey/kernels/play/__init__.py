"""The rules of play, and games from one decision to the next (sections IV.C and V.B).

Read `rules`, which moves a game; `policy` and `commitment`, how both sides decide; then `game`,
`to_capture` and `batches`, which play.
"""
