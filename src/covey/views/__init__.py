"""Pictures and animations of plans and games: they read records, and never solve.

The public names stand in `__init__.pyi`; matplotlib is loaded with the first of them. Read `kit`
(parts of pictures), then `games`, `film`, and `charts` (the paper's other figures).
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
