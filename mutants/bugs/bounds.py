"""Bugs of the room `bounds`."""

from mutants.bug import Bug

BUGS = (
    Bug(
        "one evader bounded from the origin",
        "bounds/polygon_bound.py",
        "np.zeros(1), opening.end[np.newaxis, :]",
        "np.zeros(1), np.zeros((1, 2))",
        "the upper bound of one evader is wrong where the disk isn't at the origin",
    ),
    Bug(
        "opening towards the wrong evader",
        "bounds/polygon_bound.py",
        "[first : first + 1]",
        "[:1]",
        "the bounding pursuer begins in a wrong direction; the bound is loose",
    ),
    Bug(
        "a turn that costs nothing",
        "bounds/reachable_hull.py",
        "radius * (off - np.sin(off))",
        "radius * (off - off)",
        "the upper end forgets what turning costs; the bound is loose",
    ),
    Bug(
        "turn limits known for too long",
        "bounds/polygon_bound.py",
        "(disk.speed - team.speeds[previous]) * time",
        "(disk.speed + team.speeds[previous]) * time",
        "an evader is taken to turn when it turns no more; the bound may be wrong",
    ),
    Bug(
        "value at pursuer speed 1",
        "bounds/two_evaders.py",
        "return float(self.at(team.positions - disk.center)) / disk.speed",
        "return float(self.at(team.positions - disk.center))",
        "the true value of two evaders is wrong for other speeds of the pursuer",
    ),
)
