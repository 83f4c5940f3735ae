"""Notebooks: their settings, and the one that comes with the package.

They are run with settings of their own, not with those of whoever builds the pages.
"""

from __future__ import annotations

import os
from pathlib import Path
from shutil import copyfile

from sphinx.application import Sphinx

from covey.cli.show.notebook import FIRST

SETTINGS = "get_config().IPKernelApp.log_level = 'ERROR'\n"
"""A kernel warns that it talks to this machine without encryption, as every kernel does."""


def setup(app: Sphinx) -> dict[str, bool]:
    """Lead kernels to the settings, and Sphinx to a copy of the notebook of `covey notebook`."""
    copy = Path(app.srcdir) / "generated" / FIRST.name
    copy.parent.mkdir(exist_ok=True)
    copyfile(FIRST, copy)
    folder = Path(app.doctreedir) / "ipython"
    file = folder / "profile_default" / "ipython_kernel_config.py"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(SETTINGS, encoding="utf-8")
    os.environ["IPYTHONDIR"] = str(folder)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
