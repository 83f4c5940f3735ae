"""Plays many games: every start of a study in every case of a grid.

Read in this order: `design` (what is played), `running` (on which machines, into which files),
`analysis` (means and ratios, with `statistics`), `paper` (Figs. 4 and 5). The public names stand in
`__init__.pyi`; each is imported when it is first used, so that a worker loads only what it plays
with.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
