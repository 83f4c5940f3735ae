"""How a game is played between two strategies, and the record of what happened.

Read `strategy` and `information` first (what players know and decide), then `settings`, `match` and
`loop` (the game), then `record`, `time_series`, `build_record`, `consistency`, `files`,
`storage` and `expected_captures`.
"""

from covey.simulation.loop import play
from covey.simulation.record import Game, GameStatus, Outcome
from covey.simulation.settings import Settings
from covey.simulation.storage import load_game, save_game
from covey.simulation.strategy import (
    Chase,
    Fly,
    PursuerPolicy,
    PursuerStrategy,
    Situation,
    TeamPolicy,
    TeamStrategy,
)

__all__ = [
    "Chase",
    "Fly",
    "Game",
    "GameStatus",
    "Outcome",
    "PursuerPolicy",
    "PursuerStrategy",
    "Settings",
    "Situation",
    "TeamPolicy",
    "TeamStrategy",
    "load_game",
    "play",
    "save_game",
]
