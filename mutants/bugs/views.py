"""Bugs of the room `views`."""

from mutants.bug import Bug

BUGS = (
    Bug(
        "disk stands still",
        "views/games/snapshot.py",
        "game.disk_radii[row] + game.disk.speed * elapsed,",
        "game.disk_radii[row],",
        "between two rows of a record the pursuer's disk is drawn too small",
    ),
    Bug(
        "all turns to the left",
        "views/games/flight.py",
        "np.copysign(np.fmin(np.abs(turns), team.turn_rates * elapsed), turns)",
        "np.fmin(np.abs(turns), team.turn_rates * elapsed)",
        "evaders that turn right are drawn off their path",
    ),
    Bug(
        "last bin missing",
        "views/charts/ratios.py",
        "np.arange(low, high + 2)",
        "np.arange(low, high + 1)",
        "the largest ratios are left out of the histogram",
    ),
    Bug(
        "camera by the shorter side",
        "views/kit/layout.py",
        "side = float(np.max(high - low)) or 1.0",
        "side = float(np.min(high - low)) or 1.0",
        "parts of a game lie outside of its picture",
    ),
)
