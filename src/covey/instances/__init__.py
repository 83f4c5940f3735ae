"""The covey set: games that anybody can take for a comparison, and what is known about each.

`games/` has the states, a scenario file each, which never change; `values/` has the best plans and
bounds known, which get better. Read `instance` and `load`, then `generate` (where the games came
from), `improve` and `check` (where the values come from, and whether they hold), and `scores`
(strategies on the set). The public names stand in `__init__.pyi`.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
