"""A server that has been played on keeps nothing of the games that are over."""

from __future__ import annotations

import gc

from covey.simulation import Game
from covey.web.game.human_game import HumanGame
from covey.web.game.session import Session
from web.served_pages import hear, say, wait_for

OBJECTS_OF_A_FILM = 1000


def play(server, games):
    """Set up games on pages of their own, look at a film and go; return the objects that remain."""
    for seed in range(games):
        with server.page() as page:
            say(page, type="new", choices={"evaders": 2, "seed": seed, "capture_radius": 0.1})
            hear(page, "reference")
            say(page, type="step")
            say(page, type="film", game="reference")
            hear(page, "film")
    wait_for(lambda: server.pages() == 0 and not server.connections())
    gc.collect()
    return gc.get_objects()


def test_nothing_is_left_of_games_that_are_over(server):
    before = play(server, 3)  # what is loaded once, and what other tests keep
    after = play(server, 5)
    kinds = (Game, HumanGame, Session)
    assert count_of(after, kinds) == count_of(before, kinds)
    assert len(after) - len(before) < OBJECTS_OF_A_FILM


def count_of(objects, kinds):
    return sum(isinstance(each, kinds) for each in objects)
