"""A page that speaks to a session without a socket; its clock is set by hand."""

from __future__ import annotations

import json

from covey.web.game.session import Session
from web.chase_pages import aim


class Page:
    def __init__(self, **choices):
        self.session, self.now = Session(), 0.0
        self.game = self.reference = None
        if choices:
            (self.game,) = self.ask(type="new", choices=choices)
            (self.reference,) = self.wait(0.0)

    def ask(self, **message):
        return self.send(json.dumps(message))

    def send(self, content):
        return self.heard(self.session.receive(content, self.now))

    def wait(self, seconds):
        self.now += seconds
        return self.heard(self.session.advance(self.now))

    @staticmethod
    def heard(replies):
        """The messages, without the moments at which others may have a turn."""
        messages = [reply for reply in replies if reply is not None]
        return [json.loads(each) if isinstance(each, str) else each for each in messages]

    def play(self, pace=1.0):
        """Chase to the end; return the score."""
        self.ask(type="run", pace=pace)
        while True:
            frame, *rest = self.wait(1 / 60) or [None]
            if rest:
                return rest[0]
            if frame:
                self.ask(type="steer", target=aim(frame, self.game["cast"]))

    def error(self, content):
        (reply,) = self.send(content)
        assert reply["type"] == "error"
        return reply["text"]
