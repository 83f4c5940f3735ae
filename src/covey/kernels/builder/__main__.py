"""`python -m covey.kernels.builder FILE`: write the objects for this machine to the cache's file.

Prints the share that is done, in [0, 1], a number a line.
"""

from __future__ import annotations

import sys
from pathlib import Path

from covey.kernels.builder.optimise import host_target
from covey.kernels.builder.parts import built_parts
from covey.kernels.library.cache import write_objects

if __name__ == "__main__":
    (objects,) = built_parts([host_target()], lambda share: print(f"{share:.3f}", flush=True))
    write_objects(Path(sys.argv[1]), objects)
