"""Bugs of the room `simulation`."""

from mutants.bug import Bug

BUGS = (
    Bug(
        "flight from time 0",
        "simulation/build_record.py",
        "share = (log.times[row:last] - since) / (time - since)",
        "share = log.times[row:last] / time",
        "the recorded pursuer jumps after the first capture",
    ),
    Bug(
        "damage unnoticed",
        "simulation/storage.py",
        "if notes[_CHECKSUM_KEY] != _checksum(notes[_KEY], table):",
        "if _CHECKSUM_KEY not in notes:",
        "a record whose numbers were changed is loaded as if it were sound",
    ),
    Bug(
        "rows by number",
        "simulation/information.py",
        "np.array([living.index(i) for i in sequence], dtype=np.int64)",
        "np.array(sequence, dtype=np.int64)",
        "after a capture a pursuer in Python chases another evader than it named",
    ),
    Bug(
        "place seen from the origin",
        "simulation/strategy.py",
        "distance = float(np.hypot(*(position - disk.center)))",
        "distance = float(np.hypot(*position))",
        "a legal place in a disk away from the origin is refused",
    ),
    Bug(
        "intention a row late",
        "simulation/match.py",
        "self._log.intended[self._log.counters[ROWS] - 1, : len(decision.rows)]",
        "self._log.intended[self._log.counters[ROWS], : len(decision.rows)]",
        "the record shows a sequence before the pursuer had it in mind",
    ),
)
