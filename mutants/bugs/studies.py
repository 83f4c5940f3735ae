"""Bugs of the room `studies`."""

from mutants.bug import Bug

BUGS = (
    Bug(
        "interval too narrow",
        "studies/analysis/paired_ratios.py",
        "float(deviations.std(ddof=1)) / count**0.5",
        "float(deviations.std(ddof=1)) / count",
        "confidence intervals of a tournament are far too narrow",
    ),
    Bug(
        "game in place of start",
        "studies/running/scheduler.py",
        "start = error.number // len(self._study.cases)",
        "start = error.number",
        "the report of a failed game names another start",
    ),
    Bug(
        "survivors left out",
        "studies/design/as_visible.py",
        "return FixedSequence([*captured, *rest])",
        "return FixedSequence(captured)",
        "the hidden game fails where the visible one was stopped at its time limit",
    ),
    Bug(
        "first case for all sizes",
        "studies/analysis/summary.py",
        'base = bases.setdefault(case["team_size"], k)',
        'base = bases.setdefault("first", k)',
        "larger teams are compared with a smaller team",
    ),
    Bug(
        "starts in the order of the file",
        "studies/design/start_table.py",
        "return digest, Starts(rows[order], ",
        "return digest, Starts(rows, ",
        "a table of starts that isn't sorted mixes evaders of several starts",
    ),
    Bug(
        "versions mixed",
        "studies/running/manifest.py",
        '[*_differences(before, now, "study"), *_differences(before, now, "versions")]',
        '[*_differences(before, now, "study")]',
        "a study is finished by other code than began it",
    ),
)
