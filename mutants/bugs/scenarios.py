"""Bugs of the room `scenarios`."""

from mutants.bug import Bug

BUGS = (
    Bug(
        "own turn rate ignored",
        "scenarios/build.py",
        "    if evader.turn_rate is not None:\n        return evader.turn_rate\n",
        "",
        "the turn rate of a single evader in a file has no effect",
    ),
    Bug(
        "time limit ignored",
        "scenarios/scenario.py",
        "            time_limit=self.time_limit,\n",
        "",
        "the time limit of a file has no effect",
    ),
    Bug(
        "random team at the origin",
        "scenarios/build.py",
        "positions = (offsets + np.array(center)).tolist()",
        "positions = offsets.tolist()",
        "a random team isn't placed around the pursuer's disk",
    ),
    Bug(
        "formation off its middle",
        "scenarios/samplers.py",
        "        slots -= slots.mean(axis=0)\n",
        "",
        "formations start nearer or farther than the distance that was asked for",
    ),
)
