"""Pictures of plans and games, on a map.

Read `flight` (where a plan takes the evaders), `snapshot` (a game at any time) and `prediction`
(the captures to expect), then `scene` (draws a snapshot). `plan`, `game`, `snapshots` use them.
"""
