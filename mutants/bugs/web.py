"""Bugs of the room `web`."""

from mutants.bug import Bug

BUGS = (
    Bug(
        "all time made up for",
        "web/game/pacing.py",
        "self._owed += self.pace * min(now - self._last, _MOST_OWED)",
        "self._owed += self.pace * (now - self._last)",
        "after a pause of the machine the game leaps, and the evaders with it",
    ),
    Bug(
        "no origin is our own",
        "web/serving/origin.py",
        'return origin in {f"http://{host}", f"https://{host}"}',
        'return origin is None or origin in {f"http://{host}", f"https://{host}"}',
        "a program that sends no Origin header may play and use the processor",
    ),
    Bug(
        "reference game of another team",
        "web/game/human_game.py",
        "            update_time=UPDATE_TIME,\n            seed=self._choices.seed,\n",
        "            update_time=UPDATE_TIME,\n",
        "a person's score is set beside a game whose team planned from another seed",
    ),
    Bug(
        "new game under way",
        "web/game/session.py",
        "        game = HumanGame(message.choices)\n        self._pacer.pause()\n",
        "        game = HumanGame(message.choices)\n",
        "a new game begins at once while the person still looks at it",
    ),
)
