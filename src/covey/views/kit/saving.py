"""Save pictures to files. The ending says the format; the same picture gives the same bytes."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from covey.model import InputError
from covey.simulation.files import whole_file
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
    """Save a picture in a folder that is there; an existing file is replaced.

    Parameters
    ----------
    figure
        What one of the drawing functions returned.
    path
        Ends in .png, .svg or .pdf: the format.

    Returns
    -------
    pathlib.Path
        The file that was written.

    Raises
    ------
    InputError
        If the ending is another one.
    OSError
        If the file can't be written; its `strerror` says why.

    Examples
    --------
    >>> import covey
    >>> team = covey.Team([[0.3, 0.1], [-0.2, 0.4], [0.1, -0.5]], headings=[0.3, 2.0, -1.4])
    >>> disk = covey.PursuerDisk()
    >>> import tempfile
    >>> from pathlib import Path
    >>> from covey import views
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     saved = views.save(covey.draw(covey.plan(team, disk)), Path(folder) / "plan.pdf")
    ...
    >>> saved.name
    'plan.pdf'
    """
    path = Path(path)
    suffix = checked_suffix(path, STILLS, "a picture")
    with whole_file(path) as file:
        figure.savefig(file, format=suffix[1:], metadata=_NO_DATES[suffix])
    return path


def checked_suffix(path: Path, possible: Sequence[str], what: str) -> str:
    """Return a file's ending in lower case, or raise InputError if `what` can't have it."""
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
