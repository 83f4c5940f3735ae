"""Bugs of the room `planning`."""

from mutants.bug import Bug

BUGS = (
    Bug(
        "critical sequences unsorted",
        "planning/open_loop.py",
        "rows = sorted(\n        zip(",
        "rows = list(\n        zip(",
        "the first critical sequence isn't the worst; pictures show a wrong capture order",
    ),
    Bug(
        "seed without effect",
        "planning/open_loop.py",
        "np.random.default_rng(seed).uniform",
        "np.random.default_rng(0).uniform",
        "another seed searches the same guesses again",
    ),
    Bug(
        "goal headings not wrapped",
        "planning/open_loop.py",
        "goal_headings=read_only(wrap_angle(team.headings + turns)),",
        "goal_headings=read_only(team.headings + turns),",
        "goal headings lie outside of [-π, π]",
    ),
    Bug(
        "turns of evaders that can't turn",
        "planning/open_loop.py",
        "return np.where(team.turn_rates > 0.0, checked, 0.0)",
        "return checked.copy()",
        "a plan from a warm start tells an evader that can't turn to turn",
    ),
    Bug(
        "workspace of all threads",
        "planning/workspace.py",
        "_kept = threading.local()",
        '_kept = type("Kept", (), {})()',
        "plans in two threads at once overwrite each other's memory",
    ),
    Bug(
        "batch past the last guess",
        "planning/multistart.py",
        "range(first, min(first + BATCH, count))",
        "range(first, first + BATCH)",
        "a search reads random numbers beyond the end of their array",
    ),
)
