"""Plans how a team of turn-limited vehicles survives, as a team, against a faster hidden pursuer.

The public names stand in `__init__.pyi`. Each is imported when it is first used, so that
`import covey` is quick and doesn't load the compiler.

After S.-Y. Liu, Z. Zhou, C. Tomlin and J. K. Hedrick, "Evasion of a Team of Dubins Vehicles from a
Hidden Pursuer", ICRA 2014.
"""

from __future__ import annotations

import warnings
from importlib import import_module

import lazy_loader

_load, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def __getattr__(name: str) -> object:
    """Import a public name from its room when it is first asked for."""
    if name in __all__:
        return _load(name)
    if name == "__version__":
        from importlib.metadata import version  # takes longer than everything else here

        return version("covey")
    if name in ("envs", "instances", "testing", "views"):  # rooms with public names of their own
        return import_module(f"covey.{name}")
    if name == "PatientPursuer":  # for one release
        note = "covey.PatientPursuer is now called covey.UncommittedPursuer"
        warnings.warn(note, DeprecationWarning, stacklevel=2)
        return _load("UncommittedPursuer")
    raise AttributeError(f"module 'covey' has no attribute {name!r}")
