"""Bugs of the room `kernels`."""

from mutants.bug import Bug

BUGS = (
    Bug(
        "right turn mirrored by half",
        "kernels/capture/interception.py",
        "        across, half_rate = -across, -half_rate",
        "        half_rate = -half_rate",
        "captures of evaders that turn right come at wrong times",
    ),
    Bug(
        "half a mixed derivative",
        "kernels/capture/derivatives.py",
        "            if j >= i:\n                hessian[j, i]",
        "            if j > i:\n                hessian[j, i]",
        "the planner's second derivatives are wrong; plans converge slowly, or short of the best",
    ),
    Bug(
        "one reach for many captures",
        "kernels/minimum/deadlines.py",
        "granted, slack = n * pursuit.later_radius, ",
        "granted, slack = pursuit.later_radius, ",
        "with a capture radius a better sequence is pruned, and the guarantee is too high",
    ),
    Bug(
        "pairs of an earlier call",
        "kernels/minimum/total_time.py",
        "remembered = scratch.stamps[state] == scratch.call[0]",
        "remembered = scratch.stamps[state] > 0",
        "the least sum of a game depends on the games before it",
    ),
    Bug(
        "disk collapses to a point",
        "kernels/play/rules.py",
        "        disk[2] = rules.reach",
        "        disk[2] = 0.0",
        "after a capture the team knows more than it can, and its guarantee is broken",
    ),
    Bug(
        "team before the capture",
        "kernels/play/policy.py",
        "forget(memory, n + 1, captured_row)",
        "forget(memory, n, captured_row)",
        "after a capture the team's sequences hold evaders twice, or captured ones",
    ),
    Bug(
        "delay begins anew",
        "kernels/play/to_capture.py",
        "contained_since = min(contained_since, state.time[0])",
        "contained_since = state.time[0]",
        "a pursuer that waits never captures: no worst case with delays",
    ),
    Bug(
        "one side of the border",
        "kernels/bounds/fixed_sequence.py",
        "best >= nodes - 2",
        "best >= nodes - 1",
        "the search narrows beside the maximum; known sequences get too small a value",
    ),
    Bug(
        "away from the origin",
        "kernels/maximum/initial_guesses.py",
        "off_x, off_y = evaders[i, X] - pursuit.center_x, evaders[i, Y] - pursuit.center_y",
        "off_x, off_y = evaders[i, X], evaders[i, Y]",
        "the first guess is worse, the farther the disk is from the origin",
    ),
    Bug(
        "newest kernels forgotten",
        "kernels/library/cache.py",
        "by_age[:-_MOST_FILES]",
        "by_age[_MOST_FILES:]",
        "after eight versions every process compiles again",
    ),
)
