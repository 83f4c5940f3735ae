"""What the package says of itself, and what a wheel with the compiled kernels inside differs in.

`packaging/wheels.py` names the libraries of such a wheel in `COVEY_WHEEL_LIBRARIES`, its tag in
`COVEY_WHEEL_TAG`.
"""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface
from hatchling.metadata.plugin.interface import MetadataHookInterface

LIBRARIES = os.environ.get("COVEY_WHEEL_LIBRARIES")

PICTURE = re.compile(r"^\[?!\[[^]]*\]\((?!https?:)[^)]*\)(\]\([^)]*\))?\n\n?", re.MULTILINE)
LINK = re.compile(r"\[([^]]*)\]\((?!https?:)[^)]*\)")


class Metadata(MetadataHookInterface):
    """The dependencies, and the description on a package index."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Set both; the compiler is needed only where kernels have still to be compiled."""
        compiler = [] if LIBRARIES else self.config["compiler"]
        metadata["dependencies"] = sorted([*self.config["always"], *compiler])
        text = (Path(self.root) / "README.md").read_text(encoding="utf-8")
        metadata["readme"] = {"content-type": "text/markdown", "text": description(text)}


def description(readme: str) -> str:
    """Return the README without pictures and links that lead to files of the checkout."""
    return LINK.sub(r"\1", PICTURE.sub("", readme))


class Libraries(BuildHookInterface):
    """Takes the libraries into the wheel, and names the platform that they run on."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:  # noqa: ARG002
        """Set files and tag."""
        if LIBRARIES and self.target_name == "wheel":
            for file in Path(LIBRARIES).iterdir():
                build_data["force_include"][str(file)] = f"covey/kernels/library/{file.name}"
            build_data["pure_python"] = False
            build_data["tag"] = os.environ["COVEY_WHEEL_TAG"]
