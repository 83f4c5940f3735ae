"""What several commands print, and how far a long run is.

Read `tables` and `json_output`: a plan, a game and a worst case, for people and for programs.
Then `study`, `comparison` (many games), `film`, and `notebook`, which runs one.
"""
