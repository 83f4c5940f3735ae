"""The page on which a person plays the pursuer against a team that plans as it flies.

Read `game` (what is played, and what a page is answered), then `serving` (how pages are served).
`page` has the files that a browser loads. `worker` calls in another process what takes long.
"""
