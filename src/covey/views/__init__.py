"""Pictures and films of plans, games and studies. They read records, and never solve.

The public names stand in `__init__.pyi`; matplotlib is loaded with the first of them. Read `kit`
first (what all pictures share), then `games`, `film` and `charts`, then `draw`, which draws
whatever has a picture.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
