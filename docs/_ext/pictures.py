"""Takes the pictures and films of an example of the gallery: its figures, and the GIFs it saves."""

from __future__ import annotations

from pathlib import Path
from shutil import move
from typing import Any

from matplotlib.figure import Figure
from sphinx_gallery.scrapers import figure_rst


def scrape(_block: Any, variables: dict[str, Any], settings: dict[str, Any]) -> str:
    """Save what a block of an example has made, and return the reST that shows it."""
    names, paths = variables["image_path_iterator"], []
    for figure in _figures(variables["example_globals"]):
        paths.append(next(names))
        figure.savefig(paths[-1], dpi=150)
    for film in Path(variables["src_file"]).parent.glob("*.gif"):
        paths.append(str(Path(next(names)).with_suffix(".gif")))
        move(film, paths[-1])
    return str(figure_rst(paths, settings["src_dir"]))


def _figures(names: dict[str, Any]) -> list[Figure]:
    """Return the figures of this block; a later block does not meet them again."""
    found = [name for name, value in names.items() if isinstance(value, Figure)]
    return [names.pop(name) for name in found]
