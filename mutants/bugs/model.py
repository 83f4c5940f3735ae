"""Bugs of the room `model`."""

from mutants.bug import Bug

BUGS = (
    Bug(
        "weights that sum to zero",
        "model/objectives.py",
        "if not 0.0 < sum(kept) < math.inf:",
        "if not 0.0 <= sum(kept) < math.inf:",
        "weights of zero give nan everywhere in place of an error",
    ),
    Bug(
        "past the goal",
        "model/pursuer_disk.py",
        "np.minimum(lengths, distance)[..., np.newaxis]",
        "np.asarray(lengths)[..., np.newaxis]",
        "a pursuer that starts near its first capture flies past it",
    ),
    Bug(
        "array of the caller",
        "model/validation.py",
        "array: npt.NDArray[Any] = np.array(value)",
        "array: npt.NDArray[Any] = np.asarray(value)",
        "the caller's own array becomes read-only, and a change of it changes a frozen team",
    ),
)
