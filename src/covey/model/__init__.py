"""What a game is: the team, the pursuer's disk, the objective. Values are frozen and checked.

Read `team`, `pursuer_disk` and `objectives`; `angles` and `validation` serve them and all rooms,
`value`, `display` and `units` say how values compare and look. The public names stand in
`__init__.pyi`; NumPy is loaded with the first of them.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
