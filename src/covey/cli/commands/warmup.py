"""`covey warmup`: compile the kernels now, not when they are first needed."""

from __future__ import annotations

import time

from covey.kernels.library.cache import cache_folder
from covey.kernels.library.load import load_library, packaged_library


def warmup() -> None:
    """Compile the kernels that all plans and games need, unless that has been done.

    The first plan does it by itself. It takes about a minute on one core, and half of that on two;
    afterwards nothing is left to compile. A package that brings its kernels compiled needs none of
    it. The compiled kernels are kept in the user's cache folder, or where the environment variable
    COVEY_CACHE_DIR says.

    Try:

        covey warmup
    """
    began = time.perf_counter()
    load_library()
    where = packaged_library() or cache_folder()
    print(f"the kernels in {where} are ready, after {time.perf_counter() - began:.1f} s")
