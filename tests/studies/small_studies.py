"""A study that is played in a second, and what to compare of its results."""

from __future__ import annotations

from covey.studies import Study


def small_study(**changes):
    """200 games of 2 and 3 evaders, in four parts."""
    given = {"starts": 50, "team_size": [2, 3], "update_time": 0.1, "seed": 3, **changes}
    return Study(**given)


def files(folder):
    """All that must not depend on how a study was played: names and bytes."""
    kept = [*folder.glob("*/*.parquet"), folder / "manifest.json"]
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(kept)}
