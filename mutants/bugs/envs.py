"""Bugs of the room `envs`."""

from mutants.bug import Bug

BUGS = (
    Bug(
        "one game many times",
        "envs/batch.py",
        "[None if seed is None else int(seed) + b for b in range(self.num_envs)]",
        "[None if seed is None else int(seed) for b in range(self.num_envs)]",
        "a batch with a seed plays the same game in all its places",
    ),
    Bug(
        "shares of the dead",
        "envs/parallel.py",
        "sharing = len(episode.living)",
        "sharing = self.setup.team_size",
        "after a capture the rewards no longer sum to the survival time",
    ),
    Bug(
        "actions of the first rows",
        "envs/episode.py",
        "(shares * self.setup.largest_turns)[self.living]",
        "(shares * self.setup.largest_turns)[:alive]",
        "after a capture evaders fly the actions of others",
    ),
    Bug(
        "guesses of another game",
        "envs/vector.py",
        "        part_of(self._memories.uniforms, b, self.num_envs)[:] = memory.uniforms\n",
        "",
        "games of a batch differ from the single game with the same seed",
    ),
)
