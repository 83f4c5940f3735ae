"""Notebooks are run with settings of their own, not with those of whoever builds the pages."""

from __future__ import annotations

import os
from pathlib import Path

from sphinx.application import Sphinx

SETTINGS = "get_config().IPKernelApp.log_level = 'ERROR'\n"
"""A kernel warns that it talks to this machine without encryption, as every kernel does."""


def setup(app: Sphinx) -> dict[str, bool]:
    """Lead kernels to the settings."""
    folder = Path(app.doctreedir) / "ipython"
    file = folder / "profile_default" / "ipython_kernel_config.py"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(SETTINGS, encoding="utf-8")
    os.environ["IPYTHONDIR"] = str(folder)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
