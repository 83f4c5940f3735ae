"""Pictures to files: the name's ending says how, and the same picture gives the same bytes."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from covey.model import InputError
from covey.simulation.storage import whole_file
from covey.views.kit.style import styled

STILLS = (".png", ".svg", ".pdf")
FILMS = (".gif", ".mp4")

_NO_DATES: dict[str, dict[str, Any]] = {
    ".svg": {"Date": None},
    ".pdf": {"CreationDate": None},
    ".png": {},
}


@styled
def save(figure: Figure, path: str | os.PathLike[str]) -> Path:
    """Save a picture. Folders that are missing are made, and a file of that name is replaced.

    Parameters
    ----------
    figure
        What one of the drawing functions returned.
    path
        Ends in .png, .svg or .pdf, which says how to save it.

    Returns
    -------
    pathlib.Path
        Where it is now.

    Raises
    ------
    InputError
        If the ending is another one.
    OSError
        If the file can't be written; its `strerror` says why.
    """
    place = Path(path)
    suffix = checked_suffix(place, STILLS, "a picture")
    with whole_file(place) as file:
        figure.savefig(file, format=suffix[1:], metadata=_NO_DATES[suffix])
    return place


def checked_suffix(path: Path, possible: Sequence[str], what: str) -> str:
    """Return the ending of a file's name, in small letters, if `what` can be saved as that."""
    suffix = path.suffix.lower()
    if suffix in possible:
        return suffix
    advice = ""
    if suffix in FILMS:
        advice = "; covey.views.animate makes films"
    elif suffix in STILLS:
        advice = "; covey.views.save saves pictures"
    came = repr(suffix) if suffix else "no ending"
    raise InputError(f"{path}: {what} can be saved as {', '.join(possible)}, got {came}{advice}")
