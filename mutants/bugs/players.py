"""Bugs of the room `players`."""

from mutants.bug import Bug

BUGS = (
    Bug(
        "interval counted once",
        "players/teams/replan_interval.py",
        "planned_at, living = situation.time, situation.evaders",
        "living = situation.evaders",
        "after the first interval a team plans at every update, whatever its replan_time",
    ),
    Bug(
        "position by number",
        "players/pursuers/delayed.py",
        "situation.team.positions[situation.evaders.index(target)]",
        "situation.team.positions[target]",
        "a pursuer that waits looks at another evader than its target",
    ),
    Bug(
        "one random order",
        "players/pursuers/fixed_order.py",
        "np.random.default_rng([seed, 1])",
        "np.random.default_rng(1)",
        "the random pursuer takes the same order in every game",
    ),
    Bug(
        "waits cut off",
        "players/worst_case.py",
        "settings = replace(checked, time_limit=math.inf)",
        "settings = checked",
        "long delays end in an error about update_time, or at a wrong time",
    ),
    Bug(
        "turns not refined",
        "players/teams/lookahead.py",
        "        width /= _REFINEMENT\n",
        "",
        "teams that look ahead turn by multiples of 11 degrees",
    ),
    Bug(
        "pursuit from time 0",
        "players/teams/largest_distance.py",
        "return least, captured_at(paths, there, threat.time)",
        "return least, captured_at(paths, there)",
        "ties between turns are decided by a pursuer that starts too early",
    ),
)
