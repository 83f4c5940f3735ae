"""A server that has been played on keeps nothing of the games that are over."""

from __future__ import annotations

import gc

from covey.simulation import Game
from covey.web.human_game import HumanGame
from covey.web.session import Session
from web.served_pages import hear, say, wait_for

OBJECTS_OF_A_FILM = 1000


def play(server, games):
    """Set up games on pages of their own, look at a film and go; return the objects that remain."""
    for seed in range(games):
        with server.page() as page:
            say(page, type="new", choices={"evaders": 2, "seed": seed, "capture_radius": 0.1})
            hear(page, "optimal")
            say(page, type="step")
            say(page, type="film", game="optimal")
            hear(page, "film")
    wait_for(lambda: server.pages() == 0 and not server.connections())
    gc.collect()
    return gc.get_objects()


def test_nothing_is_left_of_games_that_are_over(server):
    before = len(play(server, 3))  # what is loaded once
    after = play(server, 5)
    assert not [each for each in after if isinstance(each, Game | HumanGame | Session)]
    assert len(after) - before < OBJECTS_OF_A_FILM
