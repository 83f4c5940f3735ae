"""A game on the page: what is chosen, played and shown; it knows no sockets.

Read `human_game` first (the game), with `choices` and `human_pursuer`, then `messages` and
`session` (what a page asks, and what it is answered) and `game_json` (what a page draws). `pacing`
says how many updates are due, `upload` reads the records that a page opens.
"""
