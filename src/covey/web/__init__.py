"""The page on which a person plays the pursuer against a team that plans as it flies.

Read `human_game` first (the game), then `messages` and `session` (what a page asks, and what it is
answered), `game_json` (what a page draws), and `connection`, `app`, `protocol`, `server` (the
transport). What keeps one page from another's game: `fair_queue` and `fair_threads` (whose turn it
is), `worker` (what takes long), `admission` and `protocol` (what comes in).
"""
