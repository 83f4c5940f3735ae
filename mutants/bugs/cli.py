"""Bugs of the room `cli`."""

from mutants.bug import Bug

BUGS = (
    Bug(
        "places by number",
        "cli/show/json_output.py",
        "positions = game.evader_positions[-1, order].tolist()",
        "positions = game.evader_positions[-1].tolist()",
        "`--json` tells captures at the places of other evaders",
    ),
    Bug(
        "delays ignored",
        "cli/commands/worst_case.py",
        "scenario.worst_case(delays or [0.0])",
        "scenario.worst_case()",
        "`--delays` has no effect",
    ),
    Bug(
        "seed ignored",
        "cli/shared/sources.py",
        "return covey.load_scenario(name, seed=seed)",
        "return covey.load_scenario(name)",
        "`--seed` has no effect",
    ),
    Bug(
        "figures of missing games",
        "cli/commands/reproduce.py",
        "    print_study(result)\n    require_all_games(result)\n",
        "    print_study(result)\n",
        "the paper's figures are drawn, and reported, without the games that failed",
    ),
)
